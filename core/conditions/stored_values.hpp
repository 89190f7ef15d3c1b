// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/mesh/stored_variables.hpp"

namespace contactsim {

/// What READ VARIABLE reads: the components of a variable, one after another.
struct StoredValues {
  std::vector<std::vector<double>> components;  ///< [n_components][n_nodes or n_elements]
};

/// Reads variables of the mesh file at the times that TIME lines say; without one at the start of the run.
/// Between stored times values are interpolated linearly.
class StoredReader {
 public:
  /// start  of the run [time]
  StoredReader(const StoredVariables& stored, double start, Diagnostics& diagnostics)
      : stored_(stored), start_(start), diagnostics_(diagnostics) {}

  /// Nothing when an error was added: the file has no results, or no such variable. Throws FileError.
  ///   n_components  1, 3 or 6
  std::optional<StoredValues> read(const MeshVariable& variable, bool is_element,
                                   std::size_t n_components) const;

 private:
  StoredTime time_of(const MeshVariable& variable) const;

  const StoredVariables& stored_;
  double start_;
  Diagnostics& diagnostics_;
};

}  // namespace contactsim
