// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/base/names.hpp"
#include "core/definition/finite_element_model.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Looks up the mesh names of a deck and reports what is wrong with them at their place in the deck. Every
/// function takes the command that uses the name, for messages.
class NameLookup {
 public:
  /// aliases        further names that the deck gives to parts of the mesh
  /// node_set_hint  what to do with a node set where none is taken; "": nothing to say
  NameLookup(const Mesh& mesh, std::span<const MeshAlias> aliases, Diagnostics& diagnostics,
             std::string node_set_hint = "")
      : mesh_(mesh), aliases_(aliases), diagnostics_(diagnostics), node_set_hint_(std::move(node_set_hint)) {}

  /// The entity of one of the kinds that the name means. Unknown names and names of two of the kinds are
  /// errors.
  std::optional<Entity> find(const DeckName& name, std::span<const EntityKind> kinds,
                             std::string_view command);
  std::optional<Entity> find(const DeckName& name, std::initializer_list<EntityKind> kinds,
                             std::string_view command) {
    return find(name, std::span(kinds.begin(), kinds.size()), command);
  }

  /// The same, an assembly opened into its members. Members of a kind that is not listed are errors that name
  /// the assembly; kinds that hold only `assembly` take blocks and side sets.
  std::vector<Entity> find_members(const DeckName& name, std::span<const EntityKind> kinds,
                                   std::string_view command);
  std::vector<Entity> find_members(const DeckName& name, std::initializer_list<EntityKind> kinds,
                                   std::string_view command) {
    return find_members(name, std::span(kinds.begin(), kinds.size()), command);
  }

 private:
  std::vector<Entity> find_all(const DeckName& name) const;
  void report_unknown(const DeckName& name, std::span<const EntityKind> kinds, std::string_view command);
  void add_error(const DeckName& name, std::string text, std::string hint = "");

  const Mesh& mesh_;
  std::span<const MeshAlias> aliases_;
  Diagnostics& diagnostics_;
  std::string node_set_hint_;
};

}  // namespace contactsim
