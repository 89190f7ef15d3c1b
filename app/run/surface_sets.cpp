// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/surface_sets.hpp"

#include <algorithm>
#include <utility>

namespace contactsim {

namespace {

/// Whether Exodus counts the top and the bottom of such elements as their first two sides.
bool has_two_faces(Shape shape) {
  const Topology& facts = topology(shape);
  return facts.family == Family::shell && facts.sides.size() > 1 && facts.sides[0].kind == SideKind::face &&
         facts.sides[1].kind == SideKind::face;
}

Shape shape_of(const Mesh& mesh, ElementIndex element) { return mesh.blocks()[mesh.block_of(element)].shape; }

}  // namespace

std::vector<ElementSide> sides_of_surface(const ContactSurface& surface, const Mesh& mesh) {
  std::vector<ElementSide> sides = surface.faces;
  for (const ElementIndex element : surface.lofted_elements) {
    if (!has_two_faces(shape_of(mesh, element))) continue;
    sides.emplace_back(element, 1);
    sides.emplace_back(element, 2);
  }
  std::ranges::sort(sides, {}, [&](ElementSide side) {
    return std::pair(mesh.element_place(side.element()), side.side());
  });
  return sides;
}

std::vector<NodeIndex> nodes_of_surface(const ContactSurface& surface, const Mesh& mesh) {
  std::vector<NodeIndex> nodes = surface.nodes;
  for (const ElementIndex element : surface.lofted_elements) {
    if (has_two_faces(shape_of(mesh, element))) continue;
    const auto own = mesh.element_nodes(element);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  std::ranges::sort(nodes, {}, [&](NodeIndex node) { return mesh.node_place(node); });
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace contactsim
