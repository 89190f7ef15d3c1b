// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/output/output_variables.hpp"

namespace contactsim {

class StateArchive;

/// The values of a variable that the deck makes, kept from one computation to the next.
class StoredValues {
 public:
  /// All entities get the same values at first.
  ///   initial  [n_components]
  StoredValues(const Model& model, FieldLocation location, std::vector<double> initial);

  std::size_t n_components() const { return n_components_; }
  /// The values of a range, [count x n_components].
  std::span<double> at(const EntityRange& range);
  std::span<const double> at(const EntityRange& range) const;
  /// Saves or restores them; a variable that was not saved keeps what it has.
  void archive(const std::string& name, StateArchive& saved);

 private:
  std::size_t n_components_;
  std::vector<std::vector<double>> values_;  // by block of the model; of nodes and globals only one
};

/// Adds a variable that gives the stored values.
///   in_blocks  as OutputVariable
const OutputVariable& add_stored_variable(OutputVariables& variables, OutputVariable variable,
                                          std::shared_ptr<const StoredValues> values);

}  // namespace contactsim
