// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/mesh/face_record.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/side_tables.hpp"

/// The faces of the elements of a mesh, one after the other.
namespace contactsim::element_faces {

/// Calls `visit(side, corners)` for the faces of some elements of a block. The sides are known to the
/// compiler, which makes the usual shapes fast.
///   element_at  (std::uint32_t i) -> position in the mesh of the i-th of n elements
template <const auto& sides, std::size_t n_faces = sides.size(), class ElementAt, class Visit>
void visit_faces_of(const ElementBlock& block, std::uint32_t n, const ElementAt& element_at, Visit& visit) {
  const auto nodes_of = [&block, first_nodes = block.element_nodes(0).data()](std::uint32_t element) {
    const std::size_t in_block = element - block.first_element.value;
    return first_nodes + in_block * static_cast<std::size_t>(block.nodes_per_element);
  };
  constexpr std::uint32_t ahead = 12;  // hides the way to memory when elements stand in no order
  for (std::uint32_t i = 0; i < n; ++i) {
    if (i + ahead < n) __builtin_prefetch(nodes_of(element_at(i + ahead)));
    const std::uint32_t element = element_at(i);
    const NodeIndex* nodes = nodes_of(element);
    for (std::size_t face = 0; face < n_faces; ++face) {
      const auto& c = sides[face].corners;
      Corners corners{nodes[c[0]].value, nodes[c[1]].value, nodes[c[2]].value, nodes[c[3]].value};
      if (block.has_repeated_nodes && !reduce(corners)) continue;
      visit(ElementSide({element}, static_cast<int>(face) + 1), corners);
    }
  }
}

/// Every face of a solid matters to a skin, and one of a shell; none of a cohesive element.
template <class ElementAt, class Visit>
void visit_faces_of_block(const ElementBlock& block, std::uint32_t n, const ElementAt& element_at,
                          Visit& visit) {
  using namespace side_tables;
  const Topology& shape = topology(block.shape);
  if (shape.family == Family::shell && shape.n_corners == 4) {
    visit_faces_of<shell_quad_sides, 1>(block, n, element_at, visit);
  } else if (shape.family == Family::shell) {
    visit_faces_of<shell_tri_sides, 1>(block, n, element_at, visit);
  } else if (shape.family != Family::solid) {
    return;
  } else if (shape.sides.data() == hex_sides.data()) {
    visit_faces_of<hex_sides>(block, n, element_at, visit);
  } else if (shape.sides.data() == tet_sides.data()) {
    visit_faces_of<tet_sides>(block, n, element_at, visit);
  } else if (shape.sides.data() == wedge_sides.data()) {
    visit_faces_of<wedge_sides>(block, n, element_at, visit);
  } else if (shape.sides.data() == pyramid_sides.data()) {
    visit_faces_of<pyramid_sides>(block, n, element_at, visit);
  }
}

/// The same over all elements from `begin` to before `end`.
template <class Visit>
void visit_faces(const Mesh& mesh, std::uint32_t begin, std::uint32_t end, Visit&& visit) {
  for (const ElementBlock& block : mesh.blocks()) {
    const std::uint32_t first = std::max(begin, block.first_element.value);
    const std::uint32_t last = std::min(end, block.first_element.value + block.n_elements);
    if (first >= last) continue;
    visit_faces_of_block(
        block, last - first, [first](std::uint32_t i) { return first + i; }, visit);
  }
}

/// The same over elements of any blocks.
///   elements  ascending positions in the mesh
template <class Visit>
void visit_faces(const Mesh& mesh, std::span<const std::uint32_t> elements, Visit&& visit) {
  while (!elements.empty()) {
    const ElementBlock& block = mesh.blocks()[mesh.block_of({elements.front()})];
    const std::uint32_t end = block.first_element.value + block.n_elements;
    const auto last = std::lower_bound(elements.begin(), elements.end(), end);
    const auto n = static_cast<std::uint32_t>(last - elements.begin());
    visit_faces_of_block(
        block, n, [&](std::uint32_t i) { return elements[i]; }, visit);
    elements = elements.subspan(n);
  }
}

}  // namespace contactsim::element_faces
