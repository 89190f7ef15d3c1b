// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace contactsim {

/// Rises from 0 to 1 without a kink at either end.
///   share  of the way, from 0 to 1 [1]
template <class Number>
Number smooth_step(const Number& share) {
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace contactsim
