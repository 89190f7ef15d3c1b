// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/hanging_faces.hpp"

#include <algorithm>
#include <vector>

#include "core/mesh/face_groups.hpp"

namespace contactsim {

namespace {

/// The nodes that move a side, ascending, each once.
std::vector<NodeIndex> nodes_of(const Mesh& mesh, ElementSide side) {
  std::vector<NodeIndex> nodes;
  for (const auto& facet : mesh.side_facets(side)) nodes.insert(nodes.end(), facet.begin(), facet.end());
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

std::optional<HangingFaces> find_hanging_faces(const Mesh& mesh) {
  const auto is_split = [](const ElementBlock& block) {
    return block.n_elements > 0 && !topology(block.shape).split_faces.empty();
  };
  if (std::ranges::none_of(mesh.blocks(), is_split)) return std::nullopt;
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  HangingFaces found;
  std::vector<ElementSide> own, group;
  for (const ElementBlock& block : mesh.blocks()) {
    for (std::uint32_t e = 0; is_split(block) && e < block.n_elements; ++e) {
      faces.find_faces({block.first_element.value + e}, own);
      for (const ElementSide side : own) {
        faces.find_group(side, group);
        const auto differs = [&](ElementSide other) { return nodes_of(mesh, other) != nodes_of(mesh, side); };
        const auto other = std::ranges::find_if(group, differs);
        if (other == group.end()) continue;
        if (found.n++ == 0) found = {1, side, *other};
      }
    }
  }
  return found.n > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace contactsim
