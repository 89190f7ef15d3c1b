// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/indices.hpp"
#include "core/mesh/entity_names.hpp"
#include "core/mesh/id_lookup.hpp"
#include "core/mesh/mesh_entities.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

/// The parts of a mesh, before they are joined into an immutable Mesh.
struct MeshParts {
  std::string path;  ///< of the file, for messages
  std::string title;
  Eigen::Matrix3Xd coordinates;  ///< 3 x n_nodes [length]
  std::vector<ElementBlock> blocks;
  std::vector<SideSet> side_sets;
  std::vector<NodeSet> node_sets;
  std::vector<Assembly> assemblies;
  std::vector<std::int64_t> node_ids;     ///< empty when they are 1..n in the order of the file
  std::vector<std::int64_t> element_ids;  ///< the same
  /// Where the file has each node and each element; those beyond the end, and all of none, as here.
  std::vector<std::uint32_t> node_places, element_places;
};

/// One mesh entity that a name means.
struct Entity {
  EntityKind kind = EntityKind::block;
  std::uint32_t index = 0;  ///< position in the mesh's list of that kind
  auto operator<=>(const Entity&) const = default;
};

/// The facets of one element side by their corners; of a face of second order that moves by its midside nodes
/// there are four, of any other one.
struct SideFacets {
  std::array<std::array<NodeIndex, 4>, 4> corners;  ///< outward; one of fewer than four repeats its last
  std::size_t n = 0;

  auto begin() const { return corners.begin(); }
  auto end() const { return corners.begin() + static_cast<std::ptrdiff_t>(n); }
};

/// A three-dimensional finite element mesh. Immutable.
class Mesh {
 public:
  Mesh() = default;
  /// Sets first_element of every block, and drops id maps that are 1..n in the order of the file.
  /// Preconditions: connectivity, sets and assemblies name nodes, elements and members that exist.
  explicit Mesh(MeshParts parts);
  /// What it is made of, which it has no longer.
  MeshParts release() &&;
  /// A copy whose nodes stand elsewhere.
  ///   coordinates  [3 x n_nodes] [length]
  Mesh with_coordinates(Eigen::Matrix3Xd coordinates) const;

  /// A copy in which blocks of HEX8 and WEDGE6 are of cohesive elements; others stay.
  ///   blocks  positions
  Mesh with_cohesive_blocks(std::span<const std::uint32_t> blocks) const;

  const std::string& path() const { return parts_.path; }
  const std::string& title() const { return parts_.title; }
  const Eigen::Matrix3Xd& coordinates() const { return parts_.coordinates; }
  std::uint32_t n_nodes() const { return static_cast<std::uint32_t>(parts_.coordinates.cols()); }
  std::uint32_t n_elements() const { return n_elements_; }
  std::span<const ElementBlock> blocks() const { return parts_.blocks; }
  std::span<const SideSet> side_sets() const { return parts_.side_sets; }
  std::span<const NodeSet> node_sets() const { return parts_.node_sets; }
  std::span<const Assembly> assemblies() const { return parts_.assemblies; }

  /// The user's ids (Exodus number maps).
  std::int64_t node_id(NodeIndex node) const;
  std::int64_t element_id(ElementIndex element) const;
  /// Positions in the order of the file, in which results and tables show them.
  std::uint32_t node_place(NodeIndex node) const { return place_of(parts_.node_places, node.value); }
  std::uint32_t element_place(ElementIndex element) const {
    return place_of(parts_.element_places, element.value);
  }
  /// The element or node of a user id, if there is one; the first of a repeated id. In a mesh that is not in
  /// the order of its file and has no id maps all are looked through: for the few that a deck names.
  std::optional<ElementIndex> find_element(std::int64_t id) const;
  std::optional<NodeIndex> find_node(std::int64_t id) const;

  /// Position of the block that holds the element.
  std::uint32_t block_of(ElementIndex element) const;
  /// Connectivity of one element. Precondition: its block has a known shape.
  std::span<const NodeIndex> element_nodes(ElementIndex element) const;
  /// Mesh nodes of one side's corners; a side of fewer than four repeats its last. Precondition: the
  /// element's shape has the side.
  std::array<NodeIndex, 4> side_nodes(ElementSide side) const;
  /// The facets of one side, which together have all nodes that move it. Precondition: as side_nodes.
  SideFacets side_facets(ElementSide side) const;

  /// The name to show for an entity: the stored one, else block_<id>, surface_<id>, nodelist_<id>,
  /// assembly_<id>.
  std::string name(Entity entity) const;
  /// Every entity that a deck name means, at most one of a kind, in the order of EntityKind. Case is ignored,
  /// a blank equals an underscore; block_<id>, surface_<id>, sideset_<id>, nodelist_<id>, nodeset_<id> and
  /// assembly_<id> always work.
  std::vector<Entity> find(std::string_view name) const;
  std::optional<std::uint32_t> find(EntityKind kind, std::string_view name) const;
  /// All names of a kind as name() gives them, for suggestions.
  std::vector<std::string> names(EntityKind kind) const;

  /// The blocks, side sets or node sets of an assembly, nested ones opened, each once, in order of first
  /// mention. A nest that holds itself is opened once.
  std::vector<Entity> members(std::uint32_t assembly) const;

 private:
  static std::uint32_t place_of(const std::vector<std::uint32_t>& places, std::uint32_t position) {
    return position < places.size() ? places[position] : position;
  }
  std::uint32_t count(EntityKind kind) const;

  MeshParts parts_;
  std::uint32_t n_elements_ = 0;
  std::array<EntityLookup, n_entity_kinds> by_name_;  ///< of each EntityKind
  IdLookup node_by_id_, element_by_id_;
};

}  // namespace contactsim
