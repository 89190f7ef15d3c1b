// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/mesh/skin.hpp"

namespace contactsim::test {

/// The faces of present solids and shells by their corner nodes; faces of less than three nodes are left out.
inline std::map<std::set<NodeIndex>, std::vector<ElementSide>> group_faces(
    const Mesh& mesh, std::span<const std::uint8_t> present) {
  std::map<std::set<NodeIndex>, std::vector<ElementSide>> groups;
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) {
    const Topology& shape = topology(mesh.blocks()[mesh.block_of({i})].shape);
    const bool has_faces = shape.family == Family::solid || shape.family == Family::shell;
    if (present[i] == 0 || !has_faces) continue;
    const int n_sides = shape.family == Family::shell ? 1 : static_cast<int>(shape.sides.size());
    for (int s = 1; s <= n_sides; ++s) {
      const auto nodes = mesh.side_nodes(ElementSide({i}, s));
      const std::set<NodeIndex> corners(nodes.begin(), nodes.end());
      if (corners.size() > 2) groups[corners].push_back(ElementSide({i}, s));
    }
  }
  return groups;
}

/// The slow and obvious skin, to compare others with: a map from corner nodes to the faces that have them.
///   present  [n_elements] 0 or 1
inline Skin make_slow_skin(const Mesh& mesh, std::span<const std::uint8_t> present) {
  Skin skin;
  skin.in_between.assign(mesh.blocks().size(), 0);
  const auto block_of = [&](ElementSide face) { return mesh.block_of(face.element()); };
  const auto is_solid = [&](ElementSide face) {
    return topology(mesh.blocks()[block_of(face)].shape).family == Family::solid;
  };
  std::set<ElementSide> exterior;
  for (const auto& [corners, group] : group_faces(mesh, present)) {
    std::multiset<std::uint32_t> blocks;
    for (const ElementSide face : group) blocks.insert(block_of(face));
    for (const ElementSide face : group) {
      if (!is_solid(face)) continue;
      if (group.size() == 1) {
        exterior.insert(face);
      } else if (blocks.count(block_of(face)) == 1) {
        ++skin.in_between[block_of(face)];
      }
    }
  }
  skin.exterior.assign(exterior.begin(), exterior.end());
  return skin;
}

}  // namespace contactsim::test
