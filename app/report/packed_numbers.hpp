// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace contactsim {

/// Packs a table of whole numbers for a page: differences of neighbours along a row and, where rows follow
/// each other in time, of these from row to row; zigzag and base-128 bytes; zlib; base64. `unpack` of
/// app/report/page/data.js reads it.
///   values    [n_rows x n_columns] row by row
///   in_time   whether a row is like the one before
/// Precondition: differences fit into 32 bits, and n_columns divides the number of values.
/// Source: RFC 1950 (zlib), RFC 4648 (base64).
std::string pack_numbers(std::span<const std::int64_t> values, std::size_t n_columns, bool in_time);

/// A range of numbers in so many steps: value = first + step * code; with a `linear_part`, value =
/// linear_part * sinh(first + step * code), which has equal steps about zero and equal ratios far from it.
struct Quantiser {
  double first = 0.0, step = 0.0;
  double linear_part = 0.0;  ///< 0: all is linear

  /// For numbers between `lowest` and `highest` by codes up to `n_steps`.
  Quantiser(double lowest, double highest, double n_steps, double linear = 0.0)
      : first(bent(lowest, linear)),
        step(highest > lowest ? (bent(highest, linear) - first) / n_steps : 0.0),
        linear_part(linear) {}
  static double bent(double value, double linear) {
    return linear > 0.0 ? std::asinh(value / linear) : value;
  }
  /// The code that is nearest.
  std::int64_t code(double value) const;
};

}  // namespace contactsim
