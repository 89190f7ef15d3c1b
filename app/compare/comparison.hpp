// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace contactsim {

/// How far two numbers may be apart and still count as the same: by atol + rtol times a scale, which is the
/// larger of the two, of all energies, or of a column, as the comparison says.
struct Tolerance {
  double rtol = 1e-6;  ///< [1]
  double atol = 0.0;   ///< in the unit of the numbers

  /// Whether they are further apart. Two that are not numbers are the same.
  ///   scale  >= 0
  bool is_exceeded(double a, double b, double scale) const;
  /// The same with the larger of the two for a scale.
  bool is_exceeded(double a, double b) const;
};

/// Something in which two files differ.
struct Difference {
  using Value = std::variant<std::string, std::int64_t, double>;

  std::string kind;                                   ///< of the difference: "moved", "value", ...
  std::string text;                                   ///< what a person reads, in one line
  std::vector<std::pair<std::string, Value>> fields;  ///< what a script reads
};

/// What came of comparing two files.
struct FileComparison {
  std::string kind;           ///< of the files: "ownership", "summary", "heartbeat"
  std::string first, second;  ///< their paths
  std::vector<Difference> differences;
};

/// A line that counts the differences, then one line each; none is longer than 120 columns: what is longer
/// goes on in indented lines.
std::string format_comparison(const FileComparison& comparison);

/// The same as JSON, schema contactsim-diff/1; numbers that are not finite are null.
std::string format_comparison_json(const FileComparison& comparison);

/// A number as texts of comparisons show it, with 9 digits: more than a tolerance of 1e-6 needs.
std::string format_value(double value);

}  // namespace contactsim
