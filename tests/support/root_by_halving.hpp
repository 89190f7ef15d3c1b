// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace contactsim::test {

/// The root of a falling function, by halving alone.
template <class F>
double root_by_halving(const F& f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

}  // namespace contactsim::test
