// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_piece.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// Whether a node has elements, and whether the piece has one of them.
enum class NodeUse : std::uint8_t { alone, of_others, of_piece };

/// The nodes of a piece, in the order of the mesh.
std::vector<std::uint32_t> find_nodes_of_piece(const Mesh& mesh, std::span<const std::uint32_t> piece_of,
                                               std::uint32_t piece) {
  std::vector<NodeUse> uses(mesh.n_nodes(), NodeUse::alone);
  for (const ElementBlock& block : mesh.blocks()) {
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      const bool is_own = piece_of[block.first_element.value + e] == piece;
      for (const NodeIndex node : block.element_nodes(e)) {
        NodeUse& use = uses[node.value];
        use = std::max(use, is_own ? NodeUse::of_piece : NodeUse::of_others);
      }
    }
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < uses.size(); ++node) {
    if (uses[node] == NodeUse::of_piece || (uses[node] == NodeUse::alone && piece == 0))
      nodes.push_back(node);
  }
  return nodes;
}

}  // namespace

MeshPiece find_piece(const Mesh& mesh, std::span<const std::uint32_t> piece_of, std::uint32_t piece) {
  MeshPiece found{find_nodes_of_piece(mesh, piece_of, piece), {}};
  std::ranges::sort(found.nodes, {}, [&](std::uint32_t node) { return mesh.node_place({node}); });
  for (const ElementBlock& block : mesh.blocks()) {
    const std::uint32_t first = block.first_element.value;
    std::vector<std::uint32_t>& elements = found.elements.emplace_back();
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      if (piece_of[first + e] == piece) elements.push_back(e);
    }
    std::ranges::sort(elements, {}, [&](std::uint32_t e) { return mesh.element_place({first + e}); });
  }
  return found;
}

}  // namespace contactsim
