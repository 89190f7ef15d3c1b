// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/conditions/variable_name.hpp"
#include "core/definition/condition_initial.hpp"
#include "core/dynamics/initial_state.hpp"

namespace contactsim {

/// Carries out one INITIAL CONDITION after the other; see make_initial_state.
class InitialConditionSetter {
 public:
  InitialConditionSetter(const ConditionScope& scope, std::span<const ModelBlock> blocks, InitialState& state)
      : scope_(scope), blocks_(blocks), state_(state) {}

  void set(const InitialCondition& condition);

 private:
  /// The components of a variable that a condition sets.
  struct Wanted {
    VariableName variable;
    std::size_t n_components = 0;         ///< of the whole variable
    std::vector<std::size_t> components;  ///< that are set
  };
  /// One column per component: a number for all, or one for each node or element.
  using Columns = std::vector<std::vector<double>>;

  void set_nodal(const InitialCondition& condition);
  void set_element(const InitialCondition& condition);
  std::size_t count_components(const std::string& element_variable) const;
  std::vector<std::string> element_variables() const;
  std::optional<Wanted> find_wanted(const DeckName& variable, std::size_t n_components) const;
  std::optional<Columns> find_columns(const InitialCondition& condition, const Wanted& wanted) const;
  std::optional<Columns> read_columns(const InitialCondition& condition, const Wanted& wanted) const;
  void check_has(const std::string& variable, std::span<const ElementIndex> elements,
                 const DeckName& name) const;
  void report(const DeckName& name, std::string text, std::string hint = "") const;

  const ConditionScope& scope_;
  std::span<const ModelBlock> blocks_;
  InitialState& state_;
};

}  // namespace contactsim
