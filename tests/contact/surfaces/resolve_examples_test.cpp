// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// The examples of Sierra/SM 5.22, 8.4.4 to 8.4.8 (without skinning), each as a small mesh whose faces are
// counted by hand. Sides of a hexahedron: 1 looks along -y, 2 along +x, 3 along +y, 4 along -x, 5 along -z, 6
// along +z.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// 2 x 3 x 4 cells: 2 (2*3 + 3*4 + 2*4) = 52 faces. Elements 19 to 22 are those of the top layer with y < 2;
/// surface_2 holds their tops.
MeshBuilder example_1() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 3, 4}, .size = {2, 3, 4}});
  b.add_side_set(2, "", [](const CandidateSide& c) { return c.centroid.z() > 3.9 && c.centroid.y() < 2; });
  return b;
}

/// Two blocks of 2 x 2 x 1 cells side by side along x, with common nodes. Elements, seen from above:
///   3 4 | 7 8
///   1 2 | 5 6
/// surface_2: the tops of 1 and 3. surface_4: the tops of 2, 4, 5, 7, beside the joint.
MeshBuilder example_2() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
  b.add_hexes({.id = 2, .cells = {2, 2, 1}, .origin = {2, 0, 0}, .size = {2, 2, 1}});
  b.add_side_set(2, "", {{{0}, 6}, {{2}, 6}});
  b.add_side_set(4, "", {{{1}, 6}, {{3}, 6}, {{4}, 6}, {{6}, 6}});
  return b;
}

MeshBuilder single_hex() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_side_set(1, "", {{{0}, 6}});
  return b;
}

}  // namespace

TEST_CASE("example 1 of 8.4.6: the side set comes first and keeps its faces", "[contact][examples]") {
  const MeshBuilder b = example_1();
  const Mesh mesh = b.build();
  const auto result = resolve(mesh,
                              "contact surface surfB contains surface_2\n"
                              "contact surface surfA contains block_1\n");
  REQUIRE(result.messages.empty());
  CHECK(list_faces(mesh, result["surfB"]) == "19:6 20:6 21:6 22:6");
  CHECK(result["surfA"].faces == faces_where(b, [](const CandidateSide& c) {
          const auto& x = c.centroid;
          const bool is_outside =
              x.x() < 0.1 || x.x() > 1.9 || x.y() < 0.1 || x.y() > 2.9 || x.z() < 0.1 || x.z() > 3.9;
          return is_outside && !(x.z() > 3.9 && x.y() < 2);
        }));
  CHECK(result["surfA"].faces.size() == 48);  // 52 - 4
  CHECK(list_warnings(result) ==
        "surface-overlap, line 2, surfA, 4: surface 'surfA': 4 faces already in surface 'surfB'\n");
}

TEST_CASE("example 1 of 8.4.6 the other way round leaves the side set nothing", "[contact][examples]") {
  const Mesh mesh = example_1().build();
  const auto result = resolve(mesh,
                              "contact surface surfA contains block_1\n"
                              "contact surface surfB contains surface_2\n");
  REQUIRE(result.messages.empty());
  CHECK(result["surfA"].faces.size() == 52);
  CHECK(result["surfB"].faces.empty());
  CHECK(list_warnings(result) ==
        "surface-overlap, line 2, surfB, 4: surface 'surfB': 4 faces already in surface 'surfA'\n"
        "surface-empty, line 2, surfB, 0: surface 'surfB' owns nothing and takes no part in contact\n");
}

TEST_CASE("example 2 of 8.4.6, definition 1: the spanning side set comes first", "[contact][examples]") {
  const Mesh mesh = example_2().build();
  const auto result = resolve(mesh,
                              "contact surface surfD contains surface_4\n"
                              "contact surface surfB contains surface_2\n"
                              "contact surface surfA contains block_1\n"
                              "contact surface surfC contains block_2\n");
  REQUIRE(result.messages.empty());
  // Of the 16 faces of a block alone 2 are interior at the joint. Of its 14, A has lost all 4 tops, C 2 of 4.
  CHECK(describe(mesh, result) ==
        "surfD | 2:6 4:6 5:6 7:6 |  |  | \n"
        "surfB | 1:6 3:6 |  |  | \n"
        "surfA | 1:1 1:4 1:5 2:1 2:5 3:3 3:4 3:5 4:3 4:5 |  |  | surfD 2 faces, surfB 2 faces\n"
        "surfC | 5:1 5:5 6:1 6:2 6:5 6:6 7:3 7:5 8:2 8:3 8:5 8:6 |  |  | surfD 2 faces\n");
}

TEST_CASE("example 2 of 8.4.6, definition 2: the spanning side set comes last", "[contact][examples]") {
  const Mesh mesh = example_2().build();
  const auto result = resolve(mesh,
                              "contact surface surfB contains surface_2\n"
                              "contact surface surfA contains block_1\n"
                              "contact surface surfC contains block_2\n"
                              "contact surface surfD contains surface_4\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) ==
        "surfB | 1:6 3:6 |  |  | \n"
        "surfA | 1:1 1:4 1:5 2:1 2:5 2:6 3:3 3:4 3:5 4:3 4:5 4:6 |  |  | surfB 2 faces\n"
        "surfC | 5:1 5:5 5:6 6:1 6:2 6:5 6:6 7:3 7:5 7:6 8:2 8:3 8:5 8:6 |  |  | \n"
        "surfD |  |  |  | surfA 2 faces, surfC 2 faces\n");
  CHECK(list_warnings(result) ==
        "surface-overlap, line 2, surfA, 2: surface 'surfA': 2 faces already in surface 'surfB'\n"
        "surface-overlap, line 4, surfD, 2: surface 'surfD': 2 faces already in surface 'surfA'\n"
        "surface-overlap, line 4, surfD, 2: surface 'surfD': 2 faces already in surface 'surfC'\n"
        "surface-empty, line 4, surfD, 0: surface 'surfD' owns nothing and takes no part in contact\n");
}

TEST_CASE("SKIN ALL BLOCKS stands for the block surfaces of example 2, definition 2", "[contact][examples]") {
  const Mesh mesh = example_2().build();
  const auto result = resolve(mesh,
                              "contact surface surfB contains surface_2\n"
                              "skin all blocks = on\n"
                              "contact surface surfD contains surface_4\n");
  const auto by_hand = resolve(mesh,
                               "contact surface surfB contains surface_2\n"
                               "contact surface block_1 contains block_1\n"
                               "contact surface block_2 contains block_2\n"
                               "contact surface surfD contains surface_4\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) == describe(mesh, by_hand));
  CHECK(result["block_2"].command == "SKIN ALL BLOCKS");
  CHECK(result["block_2"].location.line == 2);
  CHECK(by_hand["block_2"].command == "CONTACT SURFACE");
}

TEST_CASE("a spanning side set takes its interior faces in any place of the deck", "[contact][examples]") {
  // surface_4 of example 2 and the two faces of block_1 at the joint, 2:2 and 4:2: six faces.
  MeshBuilder b = example_2();
  b.add_side_set(14, "", {{{1}, 6}, {{3}, 6}, {{4}, 6}, {{6}, 6}, {{1}, 2}, {{3}, 2}});
  const Mesh mesh = b.build();
  const auto first = resolve(mesh, "contact surface d contains surface_14\nskin all blocks = on\n");
  const auto last = resolve(mesh, "skin all blocks = on\ncontact surface d contains surface_14\n");
  REQUIRE(first.messages + last.messages == "");
  CHECK(list_faces(mesh, first["d"]) == "2:2 2:6 4:2 4:6 5:6 7:6");
  CHECK(list_faces(mesh, last["d"]) == "2:2 4:2");
}

TEST_CASE("8.4.8.1: the skin of one block is all of its outside", "[contact][examples]") {
  const Mesh mesh = example_1().build();
  const auto line = resolve(mesh, "contact surface block_1 contains block_1\n");
  const auto skin = resolve(mesh, "skin all blocks = on\n");
  CHECK(line["block_1"].faces.size() == 52);
  CHECK(describe(mesh, skin) == describe(mesh, line));
}

TEST_CASE("8.4.8.6: SKIN ALL BLOCKS before a side set takes all six faces", "[contact][examples]") {
  const Mesh mesh = single_hex().build();
  const auto result = resolve(mesh,
                              "skin all blocks = on\n"
                              "contact surface surf_1 contains surface_1\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) ==
        "block_1 | 1:1 1:2 1:3 1:4 1:5 1:6 |  |  | \n"
        "surf_1 |  |  |  | block_1 1 faces\n");
  CHECK(list_warnings(result) ==
        "surface-overlap, line 2, surf_1, 1: surface 'surf_1': 1 face already in surface 'block_1'\n"
        "surface-empty, line 2, surf_1, 0: surface 'surf_1' owns nothing and takes no part in contact\n");
}

TEST_CASE("8.4.8.6: SKIN ALL BLOCKS after a side set takes the other five faces", "[contact][examples]") {
  const Mesh mesh = single_hex().build();
  const auto result = resolve(mesh,
                              "contact surface surf_1 contains surface_1\n"
                              "skin all blocks = on\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) ==
        "surf_1 | 1:6 |  |  | \n"
        "block_1 | 1:1 1:2 1:3 1:4 1:5 |  |  | surf_1 1 faces\n");
}

TEST_CASE("8.4.5: SKIN ALL BLOCKS EXCLUDE makes a surface of every other block", "[contact][examples]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}});
  b.add_tets({.id = 3, .origin = {0, 3, 0}}, 5);
  b.add_shells({.id = 4, .cells = {2, 1}, .origin = {0, 6, 0}});
  b.add_beams({.id = 5, .cells = 3, .from = {0, 9, 0}, .to = {3, 9, 0}});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "skin all blocks = on exclude block_2\n");
  const auto by_hand = resolve(mesh,
                               "contact surface block_1 contains block_1\n"
                               "contact surface block_3 contains block_3\n"
                               "contact surface block_4 contains block_4\n"
                               "contact surface block_5 contains block_5\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) == describe(mesh, by_hand));
  // A cube of 5 tetrahedra has 12 triangles outside; elements 1 and 2 are hexahedra, 3 to 7 tetrahedra.
  CHECK(list_faces(mesh, result["block_1"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
  CHECK(result["block_3"].faces.size() == 12);
  CHECK(list_lofted(mesh, result["block_4"]) == "8 9");
  CHECK(list_lofted(mesh, result["block_5"]) == "10 11 12");
  CHECK(result.warnings.empty());
}

TEST_CASE("SKIN ALL BLOCKS = OFF makes nothing", "[contact][examples]") {
  const Mesh mesh = single_hex().build();
  CHECK(resolve(mesh, "skin all blocks = off\n").surfaces.empty());
  CHECK(resolve(mesh, "").surfaces.empty());
}

TEST_CASE("8.4.4.1: subsets by normal stand behind their surface", "[contact][examples][subset]") {
  const Mesh mesh = single_hex().build();
  const auto result = resolve(mesh,
                              "begin contact surface surf1\n"
                              "  block = block_1\n"
                              "  subset xp with normal 1 0 0\n"
                              "  subset zm with normal 0 0 -1\n"
                              "end\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) ==
        "surf1 | 1:1 1:3 1:4 1:6 |  |  | \n"
        "surf1_xp | 1:2 |  |  | \n"
        "surf1_zm | 1:5 |  |  | \n");
  CHECK(result["surf1"].location.line == 1);
  CHECK(result["surf1_zm"].location.line == 4);
}
