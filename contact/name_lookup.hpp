// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/definition/finite_element_model.hpp"
#include "core/diagnostics.hpp"
#include "core/mesh/mesh.hpp"
#include "core/names.hpp"

namespace contactsim {

/// Looks up the mesh names of a deck and reports what is wrong with them at their place in the deck. Every
/// function takes the command that uses the name, for messages.
class NameLookup {
 public:
  /// `aliases` are further names that the deck gives to parts of the mesh.
  NameLookup(const Mesh& mesh, std::span<const MeshAlias> aliases, Diagnostics& diagnostics)
      : mesh_(mesh), aliases_(aliases), diagnostics_(diagnostics) {}

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

  /// Reports a block of particles where the command cannot take one; returns whether the entity may be used.
  bool check_not_particles(const Entity& entity, const DeckName& name, std::string_view command);
  /// Reports a side set that holds edges or nodes; returns whether all its sides are faces.
  bool check_faces(std::uint32_t side_set, const DeckName& item);
  /// Throws FileError for a block with elements of a type that is not known.
  ///   location  of the command that puts it into contact
  void check_shape(std::uint32_t block, const DeckLocation& location) const;

 private:
  std::vector<Entity> find_all(const DeckName& name) const;
  void report_unknown(const DeckName& name, std::span<const EntityKind> kinds, std::string_view command);
  void add_error(const DeckName& name, std::string text, std::string hint = "");

  const Mesh& mesh_;
  std::span<const MeshAlias> aliases_;
  Diagnostics& diagnostics_;
};

}  // namespace contactsim
