// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "support/mesh_builder.hpp"

namespace contactsim::test {

namespace {

template <class Item>
std::uint32_t position_of(const std::vector<Item>& items, std::int64_t id) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.id == id; });
  if (found == items.end()) throw std::logic_error("the mesh builder has no such id: " + std::to_string(id));
  return static_cast<std::uint32_t>(found - items.begin());
}

CandidateSide make_candidate(const Mesh& mesh, std::int64_t block_id, ElementSide side, int n_corners) {
  const auto nodes = mesh.side_nodes(side);
  const auto x = [&](std::size_t corner) -> Eigen::Vector3d {
    return mesh.coordinates().col(nodes[corner].value);
  };
  Eigen::Vector3d sum = x(0) + x(1) + x(2);
  if (n_corners == 4) sum += x(3);
  return {block_id, side, sum / n_corners, (x(2) - x(0)).cross(x(3) - x(1)).normalized()};
}

}  // namespace

MeshBuilder& MeshBuilder::set_attributes(std::int64_t block_id, const std::vector<std::string>& names,
                                         const std::vector<double>& values) {
  ElementBlock& block = parts_.blocks[position_of(parts_.blocks, block_id)];
  assert(values.size() == names.size() * block.n_elements);
  block.attribute_names = names;
  block.attributes = values;
  return *this;
}

MeshBuilder& MeshBuilder::add_side_set(std::int64_t id, const std::string& name,
                                       const SideCondition& condition) {
  const Mesh mesh = build();
  std::vector<ElementSide> chosen;
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) {
    const ElementBlock& block = mesh.blocks()[mesh.block_of({e})];
    const int n_sides = static_cast<int>(topology(block.shape).sides.size());
    for (int s = 1; s <= n_sides; ++s) {
      const Side& side = topology(block.shape).sides[static_cast<std::size_t>(s) - 1];
      if (side.kind != SideKind::face) continue;
      const CandidateSide candidate = make_candidate(mesh, block.id, {{e}, s}, side.n_corners);
      if (condition(candidate)) chosen.push_back(candidate.side);
    }
  }
  return add_side_set(id, name, chosen);
}

MeshBuilder& MeshBuilder::add_side_set(std::int64_t id, const std::string& name,
                                       const std::vector<ElementSide>& sides) {
  parts_.side_sets.push_back({id, name, sides, {}});
  return *this;
}

MeshBuilder& MeshBuilder::add_node_set(std::int64_t id, const std::string& name,
                                       const NodeCondition& condition) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t n = 0; n < positions_.size(); ++n) {
    if (condition(positions_[n])) chosen.push_back(n);
  }
  return add_node_set(id, name, chosen);
}

MeshBuilder& MeshBuilder::add_node_set(std::int64_t id, const std::string& name,
                                       const std::vector<std::uint32_t>& nodes) {
  NodeSet& set = parts_.node_sets.emplace_back();
  set.id = id;
  set.name = name;
  for (std::uint32_t node : nodes) set.nodes.push_back({node});
  return *this;
}

MeshBuilder& MeshBuilder::add_assembly(std::int64_t id, const std::string& name, EntityKind kind,
                                       const std::vector<std::int64_t>& member_ids) {
  Assembly assembly{id, name, kind, {}};
  for (std::int64_t member : member_ids) {
    assembly.members.push_back(kind == EntityKind::block      ? position_of(parts_.blocks, member)
                               : kind == EntityKind::side_set ? position_of(parts_.side_sets, member)
                               : kind == EntityKind::node_set ? position_of(parts_.node_sets, member)
                                                              : position_of(parts_.assemblies, member));
  }
  parts_.assemblies.push_back(assembly);
  return *this;
}

MeshBuilder& MeshBuilder::set_node_ids(std::vector<std::int64_t> ids) {
  parts_.node_ids = std::move(ids);
  return *this;
}

MeshBuilder& MeshBuilder::set_element_ids(std::vector<std::int64_t> ids) {
  parts_.element_ids = std::move(ids);
  return *this;
}

}  // namespace contactsim::test
