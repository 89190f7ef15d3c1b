// SPDX-License-Identifier: BSD-3-Clause
#include "core/errors.hpp"

#include <fmt/format.h>

namespace contactsim {

SolveError::SolveError(std::int64_t step, double time, const std::string& what)
    : std::runtime_error(fmt::format("step {}, time {:.9g}: {}", step, time, what)) {}

}  // namespace contactsim
