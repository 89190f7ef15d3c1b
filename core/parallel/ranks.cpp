// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/ranks.hpp"

#include <cstdlib>

namespace contactsim {

void OneRank::abort(int exit_code) { std::_Exit(exit_code); }

Ranks& one_rank() {
  static OneRank alone;
  return alone;
}

}  // namespace contactsim
