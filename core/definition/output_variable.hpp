// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// A variable as decks name it: name, name(component) or name(component,integration point).
/// Source: Sierra/SM 5.22, 9.1.
struct VariableReference {
  DeckName name;                                  ///< without the parentheses
  std::string component;                          ///< "x", "xy", "2", lower case; "" for all of them
  std::optional<std::int64_t> integration_point;  ///< from 1; absent: all
};

/// Where a variable that is asked for lives.
enum class VariableLocation : std::uint8_t {
  any,  ///< the command does not say
  global,
  nodal,
  element,
  edge,
  face,
  node_set,
  side_set
};

/// The whole of what an output covers.
struct WholeModel {};

/// The mesh parts to which a variable is restricted: these only, or all but these.
struct NamedParts {
  bool are_excluded = false;
  std::vector<DeckName> names;
};

/// AT NODE <id>, AT ELEMENT <id>, ...: one entity by its Exodus id.
struct SingleEntity {
  std::int64_t id = 0;
  DeckLocation location;
};

/// NEAREST LOCATION <x> <y> <z>: the entity nearest to a point at the start.
struct NearestEntity {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [length]
};

/// One variable of an output.
struct VariableRequest {
  VariableLocation location = VariableLocation::any;
  VariableReference variable;
  std::string alias;  ///< name on the file, in the deck's spelling; "": the variable's own
  std::variant<WholeModel, NamedParts, SingleEntity, NearestEntity> place;
};

/// The name under which a request goes to the file, before components are appended.
inline const std::string& output_name(const VariableRequest& request) {
  return request.alias.empty() ? request.variable.name.text : request.alias;
}

/// The name by which contactsim knows a variable: lower case, spellings of older decks replaced
/// (kineticenergy is kinetic_energy). Files keep the deck's spelling, see output_name().
std::string canonical_variable_name(std::string_view name);

}  // namespace contactsim
