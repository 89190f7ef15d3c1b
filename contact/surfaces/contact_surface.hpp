// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/contact_indices.hpp"
#include "core/base/deck_location.hpp"
#include "core/base/indexed_vector.hpp"
#include "core/base/indices.hpp"

namespace contactsim {

/// What a contact surface is made of. A surface of nodes meets faces only.
enum class SurfaceKind : std::uint8_t { face, node };

/// What a surface claimed in vain, because one other surface, earlier in the deck, has it.
struct LostClaims {
  SurfaceIndex winner;
  std::uint32_t faces = 0, lofted = 0, nodes = 0;
};

/// One contact surface and all that it owns. A face, a lofted element and (among surfaces of nodes) a node
/// belong to one surface only.
struct ContactSurface {
  std::string name;  ///< deck spelling; of SKIN ALL BLOCKS the block's name
  SurfaceKind kind = SurfaceKind::face;
  std::string command;                         ///< that made it: "CONTACT SURFACE"
  DeckLocation location;                       ///< of that command
  std::vector<ElementSide> faces;              ///< of solids, and of shells through side sets; ascending
  std::vector<ElementIndex> lofted_elements;   ///< shells, lines and particles; ascending
  std::vector<NodeIndex> nodes;                ///< of surfaces of nodes only; ascending
  std::vector<std::uint32_t> analytic_planes;  ///< positions in the list given to resolve_surfaces
  std::vector<LostClaims> lost_to;             ///< in surface order of the winners
  bool may_gain_faces = false;                 ///< it skins blocks whose elements may die

  bool is_empty() const {
    return faces.empty() && lofted_elements.empty() && nodes.empty() && analytic_planes.empty();
  }
};

using SurfaceList = IndexedVector<SurfaceIndex, ContactSurface>;

/// Something about a surface that the user should decide about.
struct SurfaceWarning {
  std::string id;  ///< stable: "surface-empty", "surface-overlap", ...
  DeckLocation location;
  std::string surface;
  std::uint32_t count = 0;
  std::string text;
};

/// All contact surfaces of a definition, subsets right after the surface that they were cut from.
struct ContactSurfaces {
  SurfaceList surfaces;  ///< deck order
  /// Faces that block forms would build from single skins and then ignore: they lie between present blocks.
  /// Source: Sierra/SM 5.22, 8.4.4.2.
  std::uint32_t interior_faces_ignored = 0;
  /// Blocks of point masses, springs, dampers and cohesive elements that SKIN ALL BLOCKS or INCLUDE ALL
  /// BLOCKS passes over.
  std::vector<std::uint32_t> blocks_passed_over;
  std::vector<SurfaceWarning> warnings;  ///< in surface order
};

}  // namespace contactsim
