// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/diagnostics.hpp"
#include "core/definition/output_variable.hpp"
#include "core/output/output_variables.hpp"

namespace contactsim {

/// What a command of the deck means by a variable: all of it, one component, its length, one integration
/// point.
struct VariableSelection {
  const OutputVariable* variable = nullptr;
  std::optional<std::size_t> component;  ///< from 0; absent: all
  std::optional<std::size_t> point;      ///< integration point, from 0; absent: the mean of all
  bool is_magnitude = false;             ///< the length of a vector in place of its components

  bool is_one_of_several() const { return component || is_magnitude; }
  std::size_t n_components() const {
    return is_one_of_several() ? 1 : static_cast<std::size_t>(variable->n_components);
  }
  /// Whether the elements of a block have it. Precondition: an element variable.
  bool is_in_block(const Model& model, std::size_t block) const;
};

/// The component that a text names, by its ending or its number from 1; nothing when there is none.
std::optional<std::size_t> find_component(const OutputVariable& variable, std::string_view text);

/// The component that a name tells by its ending, "stress_xx"; nothing when there is none.
std::optional<VariableSelection> find_by_ending(const OutputVariables& variables, FieldLocation location,
                                                const std::string& name);

/// Where a variable lives that a command asks for; nothing when it does not say, or when nothing lives there.
std::optional<FieldLocation> to_field_location(VariableLocation location);

/// The selection that a reference means. Nothing when it means nothing in this run: a warning is added
/// ("output-variable-unknown") that names the nearest variable, or the location at which there is one.
std::optional<VariableSelection> find_selection(const OutputVariables& variables, VariableLocation location,
                                                const VariableReference& reference, Diagnostics& diagnostics);

/// Sets the values of a range, [count x n_components]; threads share long ranges, with the same bits for any
/// number of them.
void fill(const VariableSelection& selection, const OutputContext& context, const EntityRange& range,
          std::span<double> values);

/// The same of entities that need not follow each other, of the mesh or of a block of the model.
///   entities  positions
void fill(const VariableSelection& selection, const OutputContext& context, std::size_t block,
          std::span<const std::uint32_t> entities, std::span<double> values);

}  // namespace contactsim
