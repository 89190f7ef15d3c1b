// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/mesh/mesh.hpp"
#include "core/mesh/side_tables.hpp"

/// The faces of a mesh one after the other, and the keys by which equal ones are found. Of make_skin only.
namespace contactsim::skin_faces {

/// A face by its corner nodes; a triangle repeats its last node.
using Corners = std::array<std::uint32_t, 4>;

/// Stands for the corner that a triangle lacks.
inline constexpr std::uint32_t no_node = UINT32_MAX;

/// The corners of a face but the smallest, ascending, in 64 bits: for meshes of fewer than 2^21 - 1 nodes.
class ShortKey {
 public:
  static constexpr std::uint32_t max_nodes = (1u << 21) - 1;

  ShortKey() = default;
  ShortKey(std::uint32_t a, std::uint32_t b, std::uint32_t c)
      : low_(a | b << 21), high_(b >> 11 | (c & max_nodes) << 10) {}
  auto operator<=>(const ShortKey&) const = default;

 private:
  std::uint32_t low_, high_;  ///< two words, so that a record takes 12 bytes
};

/// The same for meshes of any size.
class LongKey {
 public:
  LongKey() = default;
  LongKey(std::uint32_t a, std::uint32_t b, std::uint32_t c) : a_(a), b_(b), c_(c) {}
  auto operator<=>(const LongKey&) const = default;

 private:
  std::uint32_t a_, b_, c_;
};

/// One face of one element, filed under its smallest node.
template <class Key>
struct FaceRecord {
  Key others;
  ElementSide side;
};

/// The key of a face of at least three different nodes, whatever the order of its corners.
template <class Key>
Key make_key(Corners c) {
  if (c[3] == c[2]) c[3] = no_node;
  const auto order = [&c](std::size_t i, std::size_t j) {
    const std::uint32_t low = std::min(c[i], c[j]), high = std::max(c[i], c[j]);
    c[i] = low;
    c[j] = high;
  };
  order(0, 1);  // a sorting network: no branch to mispredict
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return {c[1], c[2], c[3]};
}

/// Turns a face with repeated nodes into a triangle, or into nothing (false) when fewer than three nodes are
/// left.
inline bool reduce(Corners& corners) {
  Corners distinct{};
  auto end = distinct.begin();
  for (const std::uint32_t node : corners) {
    if (std::find(distinct.begin(), end, node) == end) *end++ = node;
  }
  const auto n = end - distinct.begin();
  if (n < 3) return false;
  if (n == 3) distinct[3] = distinct[2];
  corners = distinct;
  return true;
}

inline std::uint32_t smallest(const Corners& c) {
  return std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
}

/// Elements of a block, by position in the mesh.
struct ElementRange {
  std::uint32_t begin = 0, end = 0;
};

/// Calls `visit(side, corners)` for the faces of a block's present elements. The sides are known to the
/// compiler, which makes the usual shapes fast.
template <const auto& sides, std::size_t n_faces = sides.size(), class Visit>
void visit_faces_of(const ElementBlock& block, std::span<const std::uint8_t> present, ElementRange range,
                    Visit& visit) {
  const NodeIndex* nodes = block.element_nodes(range.begin - block.first_element.value).data();
  for (std::uint32_t element = range.begin; element < range.end;
       ++element, nodes += block.nodes_per_element) {
    if (!present[element]) continue;
    for (std::size_t face = 0; face < n_faces; ++face) {
      const auto& c = sides[face].corners;
      Corners corners{nodes[c[0]].value, nodes[c[1]].value, nodes[c[2]].value, nodes[c[3]].value};
      if (block.has_repeated_nodes && !reduce(corners)) continue;
      visit(ElementSide({element}, static_cast<int>(face) + 1), corners);
    }
  }
}

/// Every face of a solid matters to a skin, and one of a shell.
template <class Visit>
void visit_faces(const ElementBlock& block, std::span<const std::uint8_t> present, ElementRange range,
                 Visit& visit) {
  using namespace side_tables;
  const Topology& shape = topology(block.shape);
  if (shape.family == Family::shell && shape.n_corners == 4) {
    visit_faces_of<shell_quad_sides, 1>(block, present, range, visit);
  } else if (shape.family == Family::shell) {
    visit_faces_of<shell_tri_sides, 1>(block, present, range, visit);
  } else if (shape.sides.data() == hex_sides.data()) {
    visit_faces_of<hex_sides>(block, present, range, visit);
  } else if (shape.sides.data() == tet_sides.data()) {
    visit_faces_of<tet_sides>(block, present, range, visit);
  } else if (shape.sides.data() == wedge_sides.data()) {
    visit_faces_of<wedge_sides>(block, present, range, visit);
  } else if (shape.sides.data() == pyramid_sides.data()) {
    visit_faces_of<pyramid_sides>(block, present, range, visit);
  }
}

/// The same over all blocks.
template <class Visit>
void visit_faces(const Mesh& mesh, std::span<const std::uint8_t> present, ElementRange range, Visit&& visit) {
  for (const ElementBlock& block : mesh.blocks()) {
    const std::uint32_t first = block.first_element.value;
    const ElementRange part{std::max(range.begin, first), std::min(range.end, first + block.n_elements)};
    if (part.begin < part.end) visit_faces(block, present, part, visit);
  }
}

}  // namespace contactsim::skin_faces
