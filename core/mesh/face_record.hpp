// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/mesh/mesh.hpp"

/// The records by which equal faces are found: what the skin of a whole mesh and that around one element have
/// in common.
namespace contactsim::element_faces {

/// A face by its corner nodes; a triangle repeats its last node.
using Corners = std::array<std::uint32_t, 4>;

/// One face of one element by all corners but the smallest, ascending.
struct FaceRecord {
  std::uint32_t b, c, d;
  ElementSide side;

  auto operator<=>(const FaceRecord&) const = default;
  bool has_nodes_of(const FaceRecord& other) const { return b == other.b && c == other.c && d == other.d; }
};

/// The record of a face of at least three different nodes, the same whatever the order of its corners.
inline FaceRecord make_record(Corners c, ElementSide side) {
  constexpr std::uint32_t behind_all_nodes = UINT32_MAX;  // so that a triangle's record is like no other's
  if (c[3] == c[2]) c[3] = behind_all_nodes;
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
  return {c[1], c[2], c[3], side};
}

/// Calls visit(block) for each solid of a group of at least two faces with the same corner nodes that is the
/// only one of its block: its face is exterior to the block alone and interior to all.
///   block_of  (ElementIndex) -> position of its block
///   group     ascending
template <class BlockOf, class Visit>
void visit_in_between(const Mesh& mesh, std::span<const ElementSide> group, const BlockOf& block_of,
                      const Visit& visit) {
  const auto is_of = [&](std::size_t i, std::uint32_t block) {
    return i < group.size() && block_of(group[i].element()) == block;
  };
  for (std::size_t i = 0; i < group.size(); ++i) {
    const std::uint32_t block = block_of(group[i].element());
    const bool is_solid = topology(mesh.blocks()[block].shape).family == Family::solid;
    if (is_solid && !is_of(i - 1, block) && !is_of(i + 1, block)) visit(block);
  }
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

}  // namespace contactsim::element_faces
