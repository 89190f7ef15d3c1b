// SPDX-License-Identifier: BSD-3-Clause
#include "multiply_adds.hpp"

namespace contactsim::bench {

double multiply_adds_unfused(std::size_t n_rounds) { return run_multiply_adds(n_rounds); }

}  // namespace contactsim::bench
