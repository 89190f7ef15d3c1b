// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// Rules of element death beyond the examples. Sides of a hexahedron: 1 looks along -y, 2 along +x, 3 along
// +y, 4 along -x, 5 along -z, 6 along +z.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A row of three hexahedra along x, the third a block of its own. surface_1: the face 1:2 between the first
/// two, on the first one's side. surface_2: the tops.
MeshBuilder row_of_three() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  b.add_hexes({.id = 2, .origin = {2, 0, 0}});
  b.add_side_set(1, "", {{{0}, 2}});
  b.add_side_set(2, "", {{{0}, 6}, {{1}, 6}, {{2}, 6}});
  return b;
}

const std::string interior_set =
    "contact surface inner contains surface_1\n"
    "contact surface a contains block_1\n";

}  // namespace

TEST_CASE("an interior side-set face goes with its own element, and its neighbour's face is exposed",
          "[contact][death]") {
  const Mesh mesh = row_of_three().build();
  const auto before = resolve(mesh, interior_set);
  CHECK(list_faces(mesh, before["inner"]) == "1:2");
  CHECK(list_faces(mesh, before["a"]) == "1:1 1:3 1:4 1:5 1:6 2:1 2:2 2:3 2:5 2:6");
  const auto after = resolve(mesh, interior_set, all_but(mesh, {1}));
  CHECK(after["inner"].faces.empty());
  CHECK(list_faces(mesh, after["a"]) == "2:1 2:2 2:3 2:4 2:5 2:6");
}

TEST_CASE("an interior side-set face outlives its neighbour and stays in its surface", "[contact][death]") {
  const Mesh mesh = row_of_three().build();
  const auto after = resolve(mesh, interior_set, all_but(mesh, {2}));
  CHECK(list_faces(mesh, after["inner"]) == "1:2");
  CHECK(list_faces(mesh, after["a"]) == "1:1 1:3 1:4 1:5 1:6");
  CHECK(list_lost(after, after["a"]) == "inner 1 faces");
}

TEST_CASE("a surface of side sets gains nothing from death", "[contact][death]") {
  const Mesh mesh = row_of_three().build();
  const std::string lines = "contact surface tops contains surface_2\n";
  CHECK(list_faces(mesh, resolve(mesh, lines)["tops"]) == "1:6 2:6 3:6");
  CHECK(list_faces(mesh, resolve(mesh, lines, all_but(mesh, {2}))["tops"]) == "1:6 3:6");
}

TEST_CASE("death in one block exposes the other block's face to the other block's surface",
          "[contact][death]") {
  const Mesh mesh = row_of_three().build();
  const auto after = resolve(mesh, "skin all blocks = on\n", all_but(mesh, {2}));
  CHECK(list_faces(mesh, after["block_1"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
  CHECK(list_faces(mesh, after["block_2"]) == "3:1 3:2 3:3 3:4 3:5 3:6");
}

TEST_CASE("a surface whose elements are all dead stays in the list, with a warning", "[contact][death]") {
  const Mesh mesh = row_of_three().build();
  const auto after = resolve(mesh, "skin all blocks = on\n", all_but(mesh, {3}));
  REQUIRE(after.surfaces.size() == 2);
  CHECK(after.surfaces[{1}].is_empty());
  CHECK(list_warnings(after) ==
        "surface-empty, line 1, block_2, 0: surface 'block_2' owns nothing and takes no part in contact\n");
}

TEST_CASE("a cavity inside a block is skinned", "[contact][death]") {
  // 3 x 3 x 3 cells have 54 faces; the middle cell is the 14th and shows its 6 neighbours' faces.
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {3, 3, 3}}).build();
  const auto after = resolve(mesh, "skin all blocks = on\n", all_but(mesh, {14}));
  CHECK(after["block_1"].faces.size() == 60);
}

TEST_CASE("a hole through a plate is skinned", "[contact][death]") {
  // 7 x 3 x 1 cells: 2 (21 + 7 + 3) = 62 faces; the middle cell, the 11th, takes 2 and shows 4.
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {7, 3, 1}}).build();
  const auto after = resolve(mesh, "skin all blocks = on\n", all_but(mesh, {11}));
  CHECK(after["block_1"].faces.size() == 64);
}

TEST_CASE("dead lofted elements are gone, those that ELEMENT picked too", "[contact][death]") {
  MeshBuilder b;
  b.add_beams({.id = 1, .cells = 3, .to = {3, 0, 0}});
  b.add_spheres(2, "", {{0, 5, 0}, {1, 5, 0}});
  const Mesh mesh = b.build();
  const auto after = resolve(mesh,
                             "begin contact surface picked\n element = 1 2\nend\n"
                             "contact surface dust contains block_2\n",
                             all_but(mesh, {1, 5}));
  REQUIRE(after.messages.empty());
  CHECK(list_lofted(mesh, after["picked"]) == "2");
  CHECK(list_lofted(mesh, after["dust"]) == "4");
}

TEST_CASE("faces exposed by death go into subsets by their normals", "[contact][death][subset]") {
  const Mesh mesh = row_of_three().build();
  const std::string lines =
      "begin contact surface s\n block = block_1\n subset right with normal 1 0 0\nend\n"
      "contact surface rest contains block_2\n";
  CHECK(resolve(mesh, lines)["s_right"].faces.empty());
  CHECK(list_faces(mesh, resolve(mesh, lines, all_but(mesh, {3}))["s_right"]) == "2:2");
}
