// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/contact_surfaces.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/finite_element_model.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A subset that a request asks for, its full name made.
struct SubsetRequest {
  std::string name;  ///< <surface>_<subset>
  DeckLocation location;
  Eigen::Vector3d normal;  ///< unit vector [1]
};

/// What one command asks to have in its surface: deck names turned into positions in the mesh. Lists of
/// blocks and sets ascend and hold each entry once.
struct SurfaceRequest {
  std::string name;
  SurfaceKind kind = SurfaceKind::face;
  std::string command;
  DeckLocation location;
  SurfaceIndex first_surface;         ///< the first that it makes; its subsets follow
  std::vector<std::uint32_t> blocks;  ///< skinned or lofted; of a surface of nodes: all their nodes
  std::vector<std::uint32_t> side_sets;
  std::vector<std::uint32_t> node_sets;       ///< of surfaces of nodes only
  std::vector<ElementIndex> elements;         ///< single lofted elements, in the order named; may repeat
  std::vector<std::uint32_t> removed_blocks;  ///< none of them is in `blocks`
  std::vector<std::uint32_t> removed_side_sets;
  std::vector<std::uint32_t> analytic_planes;
  std::vector<SubsetRequest> subsets;
  bool is_block_form = false;
  std::vector<std::uint32_t> particle_blocks_left_out;  ///< by INCLUDE ALL BLOCKS

  /// The surfaces that it makes: its own and its subsets.
  IndexRange<SurfaceIndex> surfaces() const {
    return {first_surface, {first_surface.value + 1 + static_cast<std::uint32_t>(subsets.size())}};
  }
};

/// Names that a region adds to those of the mesh.
struct RegionNames {
  std::span<const AnalyticPlane> planes;
  std::span<const MeshAlias> aliases;
  /// Blocks of point masses, springs, dampers and cohesive elements, ascending: they have no surface, and
  /// what takes all blocks passes over them.
  std::vector<std::uint32_t> sizeless_blocks = {};
};

/// Looks up every name of the surface-making commands, SKIN ALL BLOCKS taken apart into one request per
/// block. Wrong names, wrong kinds, names taken twice, side sets of edges and block forms that name
/// nothing are errors in `diagnostics`.
/// Throws FileError when contact needs a block whose element type is not known.
/// Source: Sierra/SM 5.22, 8.4.
std::vector<SurfaceRequest> make_surface_requests(const ContactDefinition& contact, const RegionNames& names,
                                                  const Mesh& mesh, Diagnostics& diagnostics);

}  // namespace contactsim
