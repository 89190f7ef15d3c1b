// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "contact/surfaces/surface_request.hpp"
#include "core/mesh/name_lookup.hpp"

namespace contactsim {

/// A request that asks for nothing yet.
SurfaceRequest make_request(std::string name, SurfaceKind kind, std::string command,
                            const DeckLocation& location);

/// The mesh parts that commands name: looks them up, reports those that contact cannot take, and puts the
/// others into a request.
class RequestParts {
 public:
  /// All must outlive this.
  RequestParts(const RegionNames& names, const Mesh& mesh, Diagnostics& diagnostics)
      : sizeless_(names.sizeless_blocks),
        mesh_(mesh),
        names_(mesh, names.aliases, diagnostics, "nodes go into CONTACT NODE SET"),
        diagnostics_(diagnostics) {}

  /// Adds all that a name of one of the kinds means, assemblies opened.
  void add_item(const DeckName& item, std::span<const EntityKind> kinds, SurfaceRequest& request);
  /// Adds one of them.
  ///   item  its name in the deck
  void add_entity(const Entity& entity, const DeckName& item, SurfaceRequest& request);
  /// Throws FileError when the block's element type is not known.
  void add_block(std::uint32_t block, const DeckLocation& location, SurfaceRequest& request);

  /// Whether the block holds point masses, springs or dampers.
  bool is_sizeless(std::uint32_t block) const { return std::ranges::binary_search(sizeless_, block); }
  const Mesh& mesh() const { return mesh_; }
  NameLookup& names() { return names_; }
  Diagnostics& diagnostics() { return diagnostics_; }

 private:
  void add_side_set(std::uint32_t side_set, const DeckName& item, SurfaceRequest& request);

  std::span<const std::uint32_t> sizeless_;
  const Mesh& mesh_;
  NameLookup names_;
  Diagnostics& diagnostics_;
};

}  // namespace contactsim
