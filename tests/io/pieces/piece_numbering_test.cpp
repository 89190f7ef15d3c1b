// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/piece_numbering.hpp"

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("nodes and elements that no piece has are named", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  // The last node of the last piece is number 36 of the whole: it becomes one that is there already.
  const auto n = integers_of(mesh.piece(1), "node_num_map").size();
  const auto other = integers_of(mesh.piece(0), "node_num_map").front();
  ExodusEditor(mesh.piece(1)).set_value("node_num_map", n - 1, static_cast<double>(other));
  CHECK(mesh.refusal() == "m.g.2.0: node 36 of the 36 of the whole mesh is in none of the 2 pieces");

  const SplitMesh twice(row_of_hexes().build(), 2);
  ExodusEditor(twice.piece(1)).set_value("elem_num_map", 3, 1);
  CHECK(twice.refusal() == "m.g.2.1: element 1 of the whole mesh is in m.g.2.0 as well");
  const SplitMesh own(row_of_hexes().build(), 2);
  ExodusEditor(own.piece(1)).set_value("elem_num_map", 3, 7);
  CHECK(own.refusal() == "m.g.2.1: element 7 of the whole mesh is in m.g.2.1 twice");
  const SplitMesh nodes(row_of_hexes().build(), 2);
  const auto first = integers_of(nodes.piece(1), "node_num_map").front();
  ExodusEditor(nodes.piece(1)).set_value("node_num_map", 1, static_cast<double>(first));
  CHECK(nodes.refusal() == "m.g.2.1: node " + std::to_string(first) + " of the whole mesh is in it twice");
}

TEST_CASE("pieces without maps are refused", "[io][pieces]") {
  const SplitMesh nodes(row_of_hexes().build(), 2);
  ExodusEditor(nodes.piece(1)).rename_variable("node_num_map", "other");
  CHECK(nodes.refusal() ==
        "m.g.2.1: has no node_num_map, the numbers of its nodes in the whole mesh: it cannot be joined");
  const SplitMesh elements(row_of_hexes().build(), 2);
  ExodusEditor(elements.piece(0)).rename_variable("elem_num_map", "other");
  CHECK(elements.refusal() ==
        "m.g.2.0: has no elem_num_map, the numbers of its elements in the whole mesh: it cannot be joined");
}

TEST_CASE("maps of the user's ids give their order and stay the ids", "[io][pieces]") {
  // As a program that runs on pieces writes its results: ids, and no further maps.
  const SplitMesh mesh(row_of_hexes().build(), 2);
  for (const std::size_t piece : {0u, 1u}) {
    const auto nodes = integers_of(mesh.piece(piece), "node_num_map");
    const auto elements = integers_of(mesh.piece(piece), "elem_num_map");
    ExodusEditor file(mesh.piece(piece));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      file.set_value("node_num_map", i, static_cast<double>(1000 + 10 * nodes[i]));
    // Those of the second block come first.
    for (std::size_t i = 0; i < elements.size(); ++i)
      file.set_value("elem_num_map", i,
                     static_cast<double>(elements[i] > 5 ? elements[i] - 5 : elements[i] + 3));
  }
  const Mesh joined = mesh.read(), expected = row_of_hexes().build();
  CHECK(joined.coordinates() == expected.coordinates());
  CHECK(joined.node_id({0}) == 1010);
  CHECK(joined.node_id({35}) == 1360);
  CHECK(joined.element_id({0}) == 4);
  CHECK(joined.element_id({5}) == 1);
  CHECK(joined.blocks()[0].nodes == expected.blocks()[0].nodes);
}

TEST_CASE("ids of the whole survive in pieces, repeated ones too", "[io][pieces]") {
  MeshBuilder builder = row_of_hexes();
  std::vector<std::int64_t> nodes, elements{40, 30, 20, 10, 10, 7, 8, 9};
  for (std::int64_t i = 0; i < 36; ++i) nodes.push_back(7 * i % 36 + 500);
  builder.set_node_ids(nodes).set_element_ids(elements);
  const SplitMesh mesh(builder.build(), 3);
  const Mesh joined = mesh.read();
  for (std::uint32_t i = 0; i < 36; ++i) CHECK(joined.node_id({i}) == nodes[i]);
  for (std::uint32_t i = 0; i < 8; ++i) CHECK(joined.element_id({i}) == elements[i]);
}

TEST_CASE("elements of a piece may stand in another order than in the whole", "[io][pieces]") {
  // nem_spread writes those at other pieces behind the others.
  const SplitMesh mesh(row_of_hexes().build(), 2);
  const auto nodes = integers_of(mesh.piece(0), "connect1");
  const auto numbers = integers_of(mesh.piece(0), "elem_num_map");
  const auto members = integers_of(mesh.piece(0), "elem_ss1");
  REQUIRE(numbers.size() == 4);
  {
    ExodusEditor file(mesh.piece(0));
    for (std::size_t e = 0; e < 4; ++e) {
      file.set_value("elem_num_map", e, static_cast<double>(numbers[3 - e]));
      file.set_value("elem_ss1", e, static_cast<double>(5 - members[e]));
      for (std::size_t n = 0; n < 8; ++n)
        file.set_value("connect1", 8 * e + n, static_cast<double>(nodes[8 * (3 - e) + n]));
    }
  }
  check_same(mesh.read(), row_of_hexes().build());
}
