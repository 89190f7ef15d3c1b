// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contactsim {

/// A name of -D and the values that it takes in a study.
struct SweepParameter {
  std::string name;
  std::vector<std::string> values;  ///< one, or those of a list; empty for a range
  /// first:last:step, the last included; step is 0 of first:last, from which samples alone are drawn.
  struct Range {
    double first = 0.0, last = 0.0, step = 0.0;
  };
  std::optional<Range> range;

  /// How many values there are; may be more than fit into memory. 0 of a range without a step.
  double n_values() const;
  /// One of them. Precondition: i < n_values().
  std::string value(std::size_t i) const;
};

/// Ends a sweep that is asked for wrongly. Throws DeckError.
[[noreturn]] void refuse_sweep(const std::string& what);

/// Reads "mu=0:0.5:0.1" (a range), "order=1,2" (a list; values that hold a comma in quotes) or "name=value".
/// Throws DeckError, for a step of zero or of the wrong sign too.
SweepParameter parse_sweep_parameter(const std::string& text);

/// A number as it goes into -D: 12 digits, so that 0.1 + 0.2 is 0.3.
std::string format_parameter(double value);

}  // namespace contactsim
