// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// The skinning examples of Sierra/SM 5.22, 8.4.8.2 to 8.4.8.4, each as a small mesh whose faces are counted
// by hand. Sides of a hexahedron: 1 looks along -y, 2 along +x, 3 along +y, 4 along -x, 5 along -z, 6 along
// +z.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// block_1 and block_2, 2 x 2 x 1 cells each, stand side by side on block_3, a row of 4 cells. All share
/// nodes.
///   3 4 | 7 8
///   1 2 | 5 6
///   9 10 11 12
MeshBuilder three_blocks() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .origin = {0, 1, 0}, .size = {2, 2, 1}});
  b.add_hexes({.id = 2, .cells = {2, 2, 1}, .origin = {2, 1, 0}, .size = {2, 2, 1}});
  b.add_hexes({.id = 3, .cells = {4, 1, 1}, .size = {4, 1, 1}});
  b.add_assembly(5, "lower", EntityKind::block, {3});
  b.add_assembly(6, "upper", EntityKind::block, {1, 2});
  return b;
}

/// Two blocks of 3 x 2 x 2 cells that meet at x = 3. surface_3: the tops of 9, 12 (block_1) and 19, 22
/// (block_2), beside the joint.
MeshBuilder joined_bar() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 2, 2}, .size = {3, 2, 2}});
  b.add_hexes({.id = 2, .cells = {3, 2, 2}, .origin = {3, 0, 0}, .size = {3, 2, 2}});
  b.add_side_set(3, "", [](const CandidateSide& c) {
    return c.centroid.z() > 1.9 && c.centroid.x() > 2 && c.centroid.x() < 4;
  });
  return b;
}

bool is_outside_of_bar(const CandidateSide& c) {
  const auto& x = c.centroid;
  return x.x() < 0.1 || x.x() > 5.9 || x.y() < 0.1 || x.y() > 1.9 || x.z() < 0.1 || x.z() > 1.9;
}

bool is_surface_3(const CandidateSide& c) {
  return c.centroid.z() > 1.9 && c.centroid.x() > 2 && c.centroid.x() < 4;
}

}  // namespace

TEST_CASE("8.4.8.2: faces between two blocks that share nodes are in no surface", "[contact][examples]") {
  // 2 x 2 x 2 cells have 24 faces, 3 x 2 x 2 have 32; 4 of each are at the joint.
  const std::string lines =
      "contact surface block_1 contains block_1\n"
      "contact surface block_2 contains block_2\n";
  const bool share = GENERATE(true, false);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}, .share_nodes = share});
  b.add_hexes({.id = 2, .cells = {3, 2, 2}, .origin = {2, 0, 0}, .size = {3, 2, 2}, .share_nodes = share});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, lines);
  CHECK(result["block_1"].faces.size() == (share ? 20u : 24u));
  CHECK(result["block_2"].faces.size() == (share ? 28u : 32u));
  const auto at_joint =
      faces_where(b, [](const CandidateSide& c) { return std::abs(c.centroid.x() - 2) < 0.1; });
  REQUIRE(at_joint.size() == 8);
  for (const ContactSurface& surface : result.surfaces) {
    for (const ElementSide face : at_joint) {
      const bool is_other = (face.element().value < 8) != (surface.name == "block_1");
      const auto& faces = surface.faces;
      const bool is_owned = std::find(faces.begin(), faces.end(), face) != faces.end();
      CHECK(is_owned == (!share && !is_other));
    }
  }
  CHECK(describe(mesh, resolve(mesh, "skin all blocks = on\n")) == describe(mesh, result));
  const auto both = resolve(mesh, "contact surface s contains block_1 block_2\n");
  CHECK(both["s"].faces.size() == (share ? 48u : 56u));
}

TEST_CASE("8.4.8.3 (A): three blocks in contact cover one another", "[contact][examples]") {
  const Mesh mesh = three_blocks().build();
  const auto result = resolve(mesh,
                              "contact surface block_1 contains block_1\n"
                              "contact surface block_2 contains block_2\n"
                              "contact surface block_3 contains block_3\n");
  REQUIRE(result.messages.empty());
  CHECK(describe(mesh, result) ==
        "block_1 | 1:4 1:5 1:6 2:5 2:6 3:3 3:4 3:5 3:6 4:3 4:5 4:6 |  |  | \n"
        "block_2 | 5:5 5:6 6:2 6:5 6:6 7:3 7:5 7:6 8:2 8:3 8:5 8:6 |  |  | \n"
        "block_3 | 9:1 9:4 9:5 9:6 10:1 10:5 10:6 11:1 11:5 11:6 12:1 12:2 12:5 12:6 |  |  | \n");
  CHECK(result.warnings.empty());
  CHECK(describe(mesh, resolve(mesh, "skin all blocks = on\n")) == describe(mesh, result));
}

TEST_CASE("8.4.8.3 (B): faces towards a block that is not in contact are exterior", "[contact][examples]") {
  const Mesh mesh = three_blocks().build();
  // As in (A), and the faces towards block_3: 1:1, 2:1 and 5:1, 6:1.
  const std::string expected =
      "block_1 | 1:1 1:4 1:5 1:6 2:1 2:5 2:6 3:3 3:4 3:5 3:6 4:3 4:5 4:6 |  |  | \n"
      "block_2 | 5:1 5:5 5:6 6:1 6:2 6:5 6:6 7:3 7:5 7:6 8:2 8:3 8:5 8:6 |  |  | \n";
  const std::string lines =
      GENERATE(as<std::string>{},
               "contact surface block_1 contains block_1\n"
               "contact surface block_2 contains block_2\n",
               "skin all blocks = on exclude block_3\n", "skin all blocks = on exclude lower\n");
  const auto result = resolve(mesh, lines);
  CHECK(result.messages.empty());
  CHECK(describe(mesh, result) == expected);
}

TEST_CASE("8.4.8.3 (B) as one surface: 28 faces, by every way to say it", "[contact][examples]") {
  const Mesh mesh = three_blocks().build();
  const std::string lines = GENERATE(
      as<std::string>{}, "contact surface s contains upper\n", "contact surface s contains block_2 block_1\n",
      "begin contact surface s\n block = block_1 block_2\nend\n",
      "begin contact surface s\n assembly = upper\nend\n",
      "begin contact surface s\n include all blocks\n remove block = block_3\nend\n",
      "begin contact surface s\n assembly = upper lower\n remove block = block_3\nend\n");
  const auto result = resolve(mesh, lines);
  REQUIRE(result.messages.empty());
  CHECK(list_faces(mesh, result["s"]) ==
        "1:1 1:4 1:5 1:6 2:1 2:5 2:6 3:3 3:4 3:5 3:6 4:3 4:5 4:6 "
        "5:1 5:5 5:6 6:1 6:2 6:5 6:6 7:3 7:5 7:6 8:2 8:3 8:5 8:6");
}

TEST_CASE("8.4.8.4 (B): a side set over two blocks comes first", "[contact][examples]") {
  const MeshBuilder b = joined_bar();
  const Mesh mesh = b.build();
  const auto result = resolve(mesh,
                              "contact surface c3 contains surface_3\n"
                              "contact surface c1 contains block_1\n"
                              "contact surface c2 contains block_2\n");
  REQUIRE(result.messages.empty());
  CHECK(list_faces(mesh, result["c3"]) == "9:6 12:6 19:6 22:6");
  // Each block has 32 faces alone, 4 of them at the joint, 2 in c3.
  CHECK(result["c1"].faces.size() == 26);
  CHECK(result["c2"].faces.size() == 26);
  for (const std::int64_t block : {1, 2}) {
    CHECK(result[block == 1 ? "c1" : "c2"].faces == faces_where(b, [&](const CandidateSide& c) {
            return c.block_id == block && is_outside_of_bar(c) && !is_surface_3(c);
          }));
  }
}

TEST_CASE("8.4.8.4 (C): a side set over two blocks comes between them", "[contact][examples]") {
  const MeshBuilder b = joined_bar();
  const Mesh mesh = b.build();
  const auto result = resolve(mesh,
                              "contact surface c1 contains block_1\n"
                              "contact surface c3 contains surface_3\n"
                              "contact surface c2 contains block_2\n");
  REQUIRE(result.messages.empty());
  CHECK(result["c1"].faces ==
        faces_where(b, [](const CandidateSide& c) { return c.block_id == 1 && is_outside_of_bar(c); }));
  CHECK(result["c1"].faces.size() == 28);
  CHECK(list_faces(mesh, result["c3"]) == "19:6 22:6");
  CHECK(result["c2"].faces.size() == 26);
  CHECK(list_lost(result, result["c3"]) == "c1 2 faces");
  CHECK(list_lost(result, result["c2"]) == "c3 2 faces");
}

TEST_CASE("8.4.8.4 (D): the death of an element exposes its neighbours to their own blocks' surfaces",
          "[contact][examples][death]") {
  const MeshBuilder b = joined_bar();
  const Mesh mesh = b.build();
  const std::string lines =
      "contact surface c3 contains surface_3\n"
      "contact surface c1 contains block_1\n"
      "contact surface c2 contains block_2\n";
  // Element 9 is the one of block_1 at the joint, the front and the top. Its death takes 9:6 from c3 and 9:1
  // from c1, and exposes 3:6 below it, 8:2 and 12:1 beside it, and 19:4 of block_2.
  const auto result = resolve(mesh, lines, all_but(mesh, {9}));
  REQUIRE(result.messages.empty());
  CHECK(list_faces(mesh, result["c3"]) == "12:6 19:6 22:6");
  const auto is_of_9 = [](const CandidateSide& c) { return c.side.element().value == 8; };
  const ElementSide exposed_1[] = {{{2}, 6}, {{7}, 2}, {{11}, 1}}, exposed_2{{18}, 4};
  CHECK(result["c1"].faces == faces_where(b, [&](const CandidateSide& c) {
          const bool is_new =
              std::find(std::begin(exposed_1), std::end(exposed_1), c.side) != std::end(exposed_1);
          const bool was_there = c.block_id == 1 && is_outside_of_bar(c) && !is_surface_3(c);
          return is_new || (was_there && !is_of_9(c));
        }));
  CHECK(result["c1"].faces.size() == 28);  // 26 - 1 + 3
  CHECK(result["c2"].faces == faces_where(b, [&](const CandidateSide& c) {
          return c.side == exposed_2 || (c.block_id == 2 && is_outside_of_bar(c) && !is_surface_3(c));
        }));
  CHECK(result["c2"].faces.size() == 27);  // 26 + 1
}

TEST_CASE("8.4.8.4: a side-set surface whose elements are all dead is empty", "[contact][examples][death]") {
  const Mesh mesh = joined_bar().build();
  const auto result = resolve(mesh,
                              "contact surface c3 contains surface_3\n"
                              "contact surface c1 contains block_1\n"
                              "contact surface c2 contains block_2\n",
                              all_but(mesh, {9, 12, 19, 22}));
  CHECK(result["c3"].faces.empty());
  // Half of the bar, with a step of height 1 cut into its top: bottom 6, tops 4 + 2, end 4, sides 5 + 5,
  // step 2.
  CHECK(result["c1"].faces.size() == 28);
  CHECK(result["c2"].faces.size() == 28);
  CHECK(list_warnings(result) ==
        "surface-empty, line 1, c3, 0: surface 'c3' owns nothing and takes no part in contact\n");
}
