// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/mesh_division.hpp"

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Positions = std::vector<std::uint32_t>;

namespace {

MeshDivision divide(const Mesh& mesh, std::uint32_t n_pieces) {
  const TemporaryDirectory directory;
  write_exodus(directory.file("m.g"), mesh);
  return divide_mesh(mesh, ExodusFile(directory.file("m.g")), bisect_elements(mesh, n_pieces), n_pieces);
}

}  // namespace

TEST_CASE("elements, nodes and sets are divided", "[io][decompose]") {
  const MeshDivision made = divide(row_of_hexes().build(), 2);
  CHECK(made.division.at("num_elem").positions[1] == Positions{4, 5, 6, 7});
  CHECK(made.division.at("num_el_in_blk1").positions[0] == Positions{0, 1, 2, 3});
  CHECK(made.division.at("num_el_in_blk1").positions[1] == Positions{4});
  CHECK(made.division.at("num_nodes").positions[0].size() == 20);
  CHECK(made.division.at("num_side_ss1").positions[0] == Positions{0, 1, 2, 3});
  CHECK(made.ordered_sets.empty());
  // The four nodes of the face between them, on either side.
  REQUIRE(made.nodes[0].size() == 4);
  CHECK(made.nodes[0][0].piece == 1);
  REQUIRE(made.sides[0].size() == 1);
  CHECK(made.sides[0][0].element == 3);
  CHECK(made.sides[0][0].side == 2);
  CHECK(made.sides[1][0].element == 0);
  CHECK(made.sides[1][0].side == 4);
}

TEST_CASE("nodes without elements are of the first piece", "[io][decompose]") {
  MeshBuilder builder = row_of_hexes();
  builder.add_node({100, 0, 0});
  const MeshDivision made = divide(builder.build(), 2);
  CHECK(made.division.at("num_nodes").positions[0].back() == 36);
  CHECK(made.nodes[0].size() == 4);
  check_same(SplitMesh(builder.build(), 3).read(), builder.build());
}

TEST_CASE("a shell on a solid is at its face", "[io][decompose]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1}).add_shells({.id = 2, .origin = {0, 0, 1}});
  const MeshDivision made = divide(builder.build(), 2);
  // Its top and bottom are at the face of the hexahedron; edges are no faces.
  REQUIRE(made.sides[1].size() == 2);
  CHECK(made.sides[0].size() == 1);
}

TEST_CASE("elements that are not known are not divided", "[io][decompose]") {
  const TemporaryDirectory directory;
  write_exodus(directory.file("m.g"), two_hexes().build());
  ExodusEditor(directory.file("m.g")).set_attribute("connect2", "elem_type", "BEX_HEX");
  CHECK_THROWS_WITH(split_file(directory.file("m.g"), 2),
                    Catch::Matchers::Contains("block 20: elements of type 'BEX_HEX' cannot be divided"));
}
