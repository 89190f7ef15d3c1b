// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/conditions/condition_function.hpp"
#include "core/conditions/condition_scope.hpp"

namespace contactsim {

/// The components of a variable as READ VARIABLE reads them at one time: [n_components][n_nodes or
/// n_elements].
using StoredComponents = std::vector<std::vector<double>>;

/// Reads a variable of the mesh file at the time that the TIME line says; without one at the start of the
/// run. Between stored times values are interpolated linearly. Nothing when an error was added: the file has
/// no results, or no such variable. Throws FileError.
///   n_components  1, 3 or 6
std::optional<StoredComponents> read_stored(const MeshVariable& variable, bool is_element,
                                            std::size_t n_components, const ConditionScope& scope);

/// Who asks for the values of a condition.
struct ValueTarget {
  std::array<bool, 3> components{};  ///< along which it acts; none of them: one value is asked for
  std::vector<NodeIndex> nodes;      ///< on which it acts, ascending
  ConditionLabel label;
};

/// The values of a condition, by its FUNCTION line or READ VARIABLE line, times the scale factor: one for all
/// of its components, or one for each. A variable of the mesh file serves all components when it has the very
/// name that is asked for, else each reads its own, name_x or namex and so on. Without a TIME line it is
/// interpolated linearly as the run goes.
/// Nothing when an error was added: as make_condition_function and read_stored; values of faces; more numbers
/// than memory should hold. Throws FileError.
std::optional<std::vector<ConditionFunction>> find_condition_values(const ScaledFunction& function,
                                                                    const MeshVariable& variable,
                                                                    const ValueTarget& target,
                                                                    const ConditionScope& scope);

}  // namespace contactsim
