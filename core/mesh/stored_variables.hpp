// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace contactsim {

/// Variables of one kind that a mesh file stores at its times.
struct StoredVariableKind {
  std::vector<std::string> names;
  /// Reads a variable, by its position in `names`, at a stored time, by its position. Throws FileError.
  std::function<std::vector<double>(std::size_t variable, std::size_t time)> read;
};

/// The results that a mesh file holds beside the mesh. Empty when it holds none.
struct StoredVariables {
  std::vector<double> times;   ///< in file order [time]
  StoredVariableKind nodal;    ///< read gives [n_nodes]
  StoredVariableKind element;  ///< read gives [n_elements], NaN where a block does not have the variable
};

/// A time between two stored ones: value = (1 - weight) * value at first + weight * value at second.
struct StoredTime {
  std::size_t first = 0, second = 0;  ///< positions of stored times
  double weight = 0.0;                ///< 0 to 1 [1]
};

/// Where a time lies among stored times, by linear interpolation; before the first and after the last it is
/// the end.
///   times  not empty, rising
StoredTime find_stored_time(const std::vector<double>& times, double time);

/// Positions of the variables that a deck name means: the one of that name, case ignored, else its
/// components: name_x or namex and so on. Nothing when the file does not have all of them.
///   n_components  1, 3 (x y z) or 6 (xx yy zz xy yz zx)
std::optional<std::vector<std::size_t>> find_stored(const StoredVariableKind& kind, std::string_view name,
                                                    std::size_t n_components);

}  // namespace contactsim
