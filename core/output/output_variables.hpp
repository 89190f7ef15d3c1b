// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/output/output_groups.hpp"
#include "core/output/output_table.hpp"

namespace contactsim {

/// A variable that a run can write: of the table, of its materials, or made by its deck.
struct OutputVariable {
  using Fill = std::function<void(const OutputContext&, const EntityRange&, std::span<double> values)>;

  std::string name;  ///< lower case
  FieldLocation location = FieldLocation::global;
  FieldShape shape = FieldShape::scalar;
  int n_components = 1;
  bool is_at_points = false;            ///< an element variable that each integration point has
  std::vector<std::uint8_t> in_blocks;  ///< which of Model::blocks have it, of element variables
  /// Sets the values, [count x n_components]. Any thread may call it; it changes nothing.
  Fill fill;
  std::string dimension = {};  ///< of all components, "[force]"; "" when nobody knows
  bool reads_all = false;      ///< a global that is found from all nodes, or all elements
};

/// All variables of a run by location and name.
class OutputVariables {
 public:
  /// Those of the tables and of the model's materials, and more. The model must outlive them.
  ///   other_names  groups of them, and what others call them
  explicit OutputVariables(const Model& model, std::vector<OutputVariable> more = {},
                           OutputNames other_names = {});

  const Model& model() const { return model_; }
  const OutputNames& other_names() const { return other_names_; }

  /// Adds a variable; it hides an earlier one of its name and location. The reference stays good.
  const OutputVariable& add(OutputVariable variable);

  /// The variable of a name in lower case; null when there is none.
  const OutputVariable* find(FieldLocation location, std::string_view name) const;

  /// The names of a location, for suggestions.
  std::vector<std::string> names(FieldLocation location) const;

 private:
  void add_rows(std::span<const OutputRow> rows);
  void add_material_variables(std::size_t block);

  const Model& model_;
  OutputNames other_names_;
  std::deque<OutputVariable> variables_;
};

}  // namespace contactsim
