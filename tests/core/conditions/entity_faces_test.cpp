// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_faces.hpp"

#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

Mesh two_cubes() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}});
  b.add_beams({.id = 3, .cells = 1, .from = {0, 0, 5}, .to = {1, 0, 5}});
  b.add_side_set(10, "between", {{{1}, 4}, {{0}, 2}, {{0}, 2}});
  b.add_side_set(11, "line", {{{2}, 1}});
  b.add_node_set(20, "corner", std::vector<std::uint32_t>{0});
  return b.build();
}

/// The faces that a pressure with the set lines acts on, as "1:4", or what is wrong with them.
std::string faces_of(const std::string& lines) {
  const Mesh mesh = two_cubes();
  ConditionDeck deck(mesh, "begin pressure\n" + lines + "end\n");
  const Pressure& pressure = deck.region().pressures.at(0);
  const auto faces = find_faces(pressure.set, {"the pressure", pressure.name.location}, deck.scope());
  std::string text = deck.messages();
  for (const ElementSide face : faces)
    text += std::to_string(mesh.element_id(face.element())) + ":" + std::to_string(face.side()) + " ";
  return text;
}

}  // namespace

TEST_CASE("a side set gives its faces, a block those on the outside of the mesh", "[core][conditions]") {
  CHECK(faces_of("surface = between\n") == "1:2 2:4 ");
  CHECK(faces_of("block = block_1\n") == "1:1 1:3 1:4 1:5 1:6 ");
  CHECK(faces_of("block = block_1\nsurface = between\nremove block = block_2\n") ==
        "1:1 1:2 1:3 1:4 1:5 1:6 ");
  CHECK(faces_of("block = block_1 block_2\nsurface = between\nremove surface = between\n") ==
        "1:1 1:3 1:4 1:5 1:6 2:1 2:2 2:3 2:5 2:6 ");
}

TEST_CASE("what has no faces cannot take a pressure", "[core][conditions]") {
  CHECK(faces_of("node set = corner\n") ==
        "c.i:2:12: error: the pressure acts on faces, which the node set 'corner' does not have\n");
  CHECK(faces_of("node = 1\nelement = 2\n") ==
        "c.i:2:8: error: the pressure takes no NODE line; use SURFACE or BLOCK\n"
        "c.i:3:11: error: the pressure takes no ELEMENT line; use SURFACE or BLOCK\n");
  CHECK(faces_of("block = block_3\n") ==
        "c.i:1:1: warning: the pressure acts on no face [condition-empty]\n");
  CHECK(faces_of("surface = line\n") ==
        "c.i:2:11: error: the pressure acts on faces, but side 1 of element 3 (BEAM2) in the side set 'line' "
        "is none\n");
}
