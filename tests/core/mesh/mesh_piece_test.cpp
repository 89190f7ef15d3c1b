// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_piece.hpp"

#include <algorithm>
#include <set>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Blocks of six and two hexahedra that share no node, and a node of no element; files have all of it the
/// other way round.
Mesh turned_mesh() {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {6, 1, 1}});
  builder.add_hexes({.id = 2, .cells = {2, 1, 1}, .origin = {9, 0, 0}, .share_nodes = false});
  builder.add_node({0, 0, 7});
  MeshParts parts = builder.parts();
  const auto n = static_cast<std::uint32_t>(parts.coordinates.cols());
  for (std::uint32_t i = 0; i < n; ++i) parts.node_places.push_back(n - 1 - i);
  for (const std::uint32_t place : {5, 4, 3, 2, 1, 0, 7, 6}) parts.element_places.push_back(place);
  return Mesh(std::move(parts));
}

}  // namespace

TEST_CASE("pieces have their elements and their nodes, in the order of files", "[core][mesh]") {
  const Mesh mesh = turned_mesh();
  const std::vector<std::uint32_t> piece_of{0, 2, 0, 0, 2, 2, 2, 0};
  std::vector<int> n_pieces(mesh.n_nodes(), 0);
  for (std::uint32_t number = 0; number < 3; ++number) {
    const MeshPiece piece = find_piece(mesh, piece_of, number);
    REQUIRE(piece.elements.size() == 2);
    std::set<std::uint32_t> nodes;
    for (std::uint32_t b = 0; b < 2; ++b) {
      const ElementBlock& block = mesh.blocks()[b];
      CHECK(std::ranges::is_sorted(piece.elements[b], std::greater<>()));
      for (const std::uint32_t e : piece.elements[b]) {
        CHECK(piece_of[block.first_element.value + e] == number);
        for (const NodeIndex node : block.element_nodes(e)) nodes.insert(node.value);
      }
    }
    if (number == 0) nodes.insert(mesh.n_nodes() - 1);
    CHECK(piece.nodes == std::vector<std::uint32_t>(nodes.rbegin(), nodes.rend()));
    for (const std::uint32_t node : piece.nodes) ++n_pieces[node];
  }
  CHECK(find_piece(mesh, piece_of, 0).elements[0] == std::vector<std::uint32_t>{3, 2, 0});
  CHECK(find_piece(mesh, piece_of, 1).nodes.empty());
  CHECK(std::ranges::count(n_pieces, 0) == 0);
  CHECK(std::ranges::count(n_pieces, 2) == 16);  // four faces between pieces
}
