// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim::test {

/// A box of equal cells, numbered with x running fastest and z slowest.
struct Box {
  std::int64_t id = 1;
  std::string name = {};
  std::array<int, 3> cells{1, 1, 1};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< of the whole box
  bool share_nodes = true;  ///< with what was added before and also shares; else the box stands alone
};

/// A flat sheet of cells; its top (side 1) looks along u x v.
struct Sheet {
  std::int64_t id = 1;
  std::string name = {};
  std::array<int, 2> cells{1, 1};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX();  ///< the whole first edge
  Eigen::Vector3d v = Eigen::Vector3d::UnitY();  ///< the whole second edge
  bool share_nodes = true;
};

/// A straight row of line elements.
struct Row {
  std::int64_t id = 1;
  std::string name = {};
  int cells = 1;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::UnitX();
  bool share_nodes = true;
};

/// A face of a solid or a shell, as a side set's condition sees it.
struct CandidateSide {
  std::int64_t block_id = 0;
  ElementSide side;
  Eigen::Vector3d centroid;  ///< mean of the corners [length]
  Eigen::Vector3d normal;    ///< unit, outward [1]
};

using SideCondition = std::function<bool(const CandidateSide&)>;
using NodeCondition = std::function<bool(const Eigen::Vector3d& position)>;

/// Makes meshes in code. Blocks stand in the order in which they are added; sets and attributes see only what
/// was added before them.
class MeshBuilder {
 public:
  MeshBuilder& add_hexes(const Box& box);
  /// Each cell becomes 5 tetrahedra (mirrored from cell to cell so that they fit) or 6.
  MeshBuilder& add_tets(const Box& box, int tets_per_cell = 6);
  /// As add_tets of 6, with midside nodes.
  MeshBuilder& add_ten_node_tets(const Box& box);
  /// Each cell becomes 2 wedges whose triangles look along z.
  MeshBuilder& add_wedges(const Box& box);
  /// Each cell becomes 6 pyramids about a node in its middle.
  MeshBuilder& add_pyramids(const Box& box);
  MeshBuilder& add_shells(const Sheet& sheet);
  /// Each cell becomes 2 triangular shells.
  MeshBuilder& add_triangles(const Sheet& sheet);
  MeshBuilder& add_bars(const Row& row);
  MeshBuilder& add_beams(const Row& row);
  /// One sphere element at each centre; nodes are shared with what stands there.
  MeshBuilder& add_spheres(std::int64_t id, const std::string& name,
                           const std::vector<Eigen::Vector3d>& centres);

  /// A node that no later block shares.
  NodeIndex add_node(const Eigen::Vector3d& position);
  /// Elements from explicit nodes, n_elements x nodes of the shape.
  MeshBuilder& add_block(std::int64_t id, const std::string& name, Shape shape,
                         const std::vector<std::uint32_t>& nodes);
  /// values: n_elements x names.size(), element by element.
  MeshBuilder& set_attributes(std::int64_t block_id, const std::vector<std::string>& names,
                              const std::vector<double>& values);

  /// Every face, interior ones included, that satisfies the condition, in order of element and side.
  MeshBuilder& add_side_set(std::int64_t id, const std::string& name, const SideCondition& condition);
  MeshBuilder& add_side_set(std::int64_t id, const std::string& name, const std::vector<ElementSide>& sides);
  MeshBuilder& add_node_set(std::int64_t id, const std::string& name, const NodeCondition& condition);
  MeshBuilder& add_node_set(std::int64_t id, const std::string& name,
                            const std::vector<std::uint32_t>& nodes);
  /// Members by their ids; they must have been added, nested assemblies too.
  MeshBuilder& add_assembly(std::int64_t id, const std::string& name, EntityKind kind,
                            const std::vector<std::int64_t>& member_ids);

  MeshBuilder& set_node_ids(std::vector<std::int64_t> ids);
  MeshBuilder& set_element_ids(std::vector<std::int64_t> ids);

  /// The mesh so far as open parts, for tests that change them.
  MeshParts parts() const;
  Mesh build() const { return Mesh(parts()); }

 private:
  NodeIndex node_at(const Eigen::Vector3d& position, bool share);
  ElementBlock& open_block(std::int64_t id, const std::string& name, Shape shape);
  void close_block();
  /// Calls make(corners of the cell in HEX8 order, i + j + k) for each cell.
  void for_each_cell(const Box& box, const std::function<void(const std::array<NodeIndex, 8>&, int)>& make);
  void for_each_cell(const Sheet& sheet, const std::function<void(const std::array<NodeIndex, 4>&)>& make);
  void append(std::initializer_list<NodeIndex> nodes);
  void append_tet(std::array<NodeIndex, 4> nodes);
  MeshBuilder& add_row(const Row& row, Shape shape);

  MeshParts parts_;
  std::vector<Eigen::Vector3d> positions_;
  std::map<std::array<long long, 3>, NodeIndex> shared_nodes_;
};

}  // namespace contactsim::test
