// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// Sides of a hexahedron: 1 looks along -y, 2 along +x, 3 along +y, 4 along -x, 5 along -z, 6 along +z.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two hexahedra along x, one block each, that share the face 1:2 = 2:4. surface_1: both sides of that face.
/// surface_2: the tops. surface_3: the end 2:2.
MeshBuilder pair_of_hexes() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 0, 0}});
  b.add_side_set(1, "joint", {{{0}, 2}, {{1}, 4}});
  b.add_side_set(2, "tops", {{{0}, 6}, {{1}, 6}});
  b.add_side_set(3, "end", {{{1}, 2}});
  return b;
}

}  // namespace

TEST_CASE("both sides of an interior face in one side set are two faces", "[contact][resolve]") {
  const Mesh mesh = pair_of_hexes().build();
  const auto result = resolve(mesh, "skin all blocks = on\ncontact surface s contains joint\n");
  CHECK(list_faces(mesh, result["s"]) == "1:2 2:4");
  CHECK(list_faces(mesh, result["block_1"]) == "1:1 1:3 1:4 1:5 1:6");
}

TEST_CASE("a block that is named only through a side set is not present", "[contact][resolve]") {
  const Mesh mesh = pair_of_hexes().build();
  const auto result = resolve(mesh,
                              "contact surface a contains block_1\n"
                              "contact surface b contains end\n");
  CHECK(list_faces(mesh, result["a"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
  CHECK(list_faces(mesh, result["b"]) == "2:2");
}

TEST_CASE("a block that gives only nodes is not present", "[contact][resolve]") {
  const Mesh mesh = pair_of_hexes().build();
  const auto result = resolve(mesh,
                              "contact node set n contains block_2\n"
                              "contact surface a contains block_1\n");
  CHECK(list_faces(mesh, result["a"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
  CHECK(result["n"].nodes.size() == 8);
  CHECK(result["n"].faces.empty());
}

TEST_CASE("the block form unites skins and side sets", "[contact][resolve]") {
  // 2 x 2 x 2 cells alone in contact: 24 faces. surface_1 repeats two of them, surface_2 adds two of block_2.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}});
  b.add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {2, 0, 0}, .size = {2, 2, 2}});
  b.add_side_set(1, "", {{{0}, 1}, {{0}, 5}});
  b.add_side_set(2, "", {{{9}, 1}, {{9}, 5}});
  const Mesh mesh = b.build();
  const auto same = resolve(mesh, "begin contact surface s\n block = block_1\n surface = surface_1\nend\n");
  const auto more = resolve(mesh, "begin contact surface s\n block = block_1\n surface = surface_2\nend\n");
  CHECK(same["s"].faces.size() == 24);
  CHECK(more["s"].faces.size() == 26);
  CHECK(same.warnings.empty());
}

TEST_CASE("one line may mix side sets, blocks and assemblies", "[contact][resolve]") {
  MeshBuilder b = pair_of_hexes();
  b.add_assembly(7, "ends", EntityKind::side_set, {3, 2});
  b.add_assembly(8, "all", EntityKind::assembly, {7});
  const Mesh mesh = b.build();
  const std::string line =
      GENERATE(as<std::string>{}, "contact surface s contains block_1 tops end\n",
               "contact surface s contains ends block_1 ends\n", "contact surface s contains block_1, all\n",
               "begin contact surface s\n assembly = all\n block = block_1\nend\n");
  const auto result = resolve(mesh, line);
  CHECK(result.messages.empty());
  CHECK(list_faces(mesh, result["s"]) == "1:1 1:2 1:3 1:4 1:5 1:6 2:2 2:6");
  CHECK(result.warnings.empty());
}

TEST_CASE("REMOVE SURFACE leaves faces for a later surface", "[contact][resolve]") {
  // A bar of 6 x 2 x 2 cells has 56 faces; surface_3 holds 4 tops.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {6, 2, 2}, .size = {6, 2, 2}});
  const auto is_middle = [](const CandidateSide& c) {
    return c.centroid.z() > 1.9 && c.centroid.x() > 2 && c.centroid.x() < 4;
  };
  b.add_side_set(3, "", is_middle);
  const Mesh mesh = b.build();
  const std::string block =
      "begin contact surface s\n include all blocks\n remove surface = surface_3\nend contact surface s\n";
  const auto alone = resolve(mesh, block);
  CHECK(alone["s"].faces.size() == 52);
  CHECK(alone.warnings.empty());
  const auto both = resolve(mesh, block + "contact surface later contains block_1\n");
  CHECK(both["s"].faces.size() == 52);
  CHECK(both["later"].faces == faces_where(b, is_middle));
  CHECK(list_lost(both, both["later"]) == "s 52 faces");
}

TEST_CASE("REMOVE SURFACE acts on the side sets of its surface too", "[contact][resolve]") {
  const Mesh mesh = pair_of_hexes().build();
  const auto result =
      resolve(mesh, "begin contact surface s\n surface = tops end joint\n remove surface = tops\nend\n");
  CHECK(list_faces(mesh, result["s"]) == "1:2 2:2 2:4");
}

TEST_CASE("faces between present blocks are counted for block forms, and in no surface",
          "[contact][resolve]") {
  MeshBuilder b;  // 2 x 2 faces at the joint: four on either side
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}});
  b.add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {2, 0, 0}, .size = {2, 2, 2}});
  const Mesh mesh = b.build();
  const std::string block_1 = "begin contact surface a\n block = block_1\nend\n";
  const std::string block_2 = "begin contact surface b\n block = block_2\nend\n";
  const auto both = resolve(mesh, block_1 + block_2);
  CHECK(both.interior_faces_ignored == 8);
  CHECK(both["a"].faces.size() == 20);
  CHECK(both["b"].faces.size() == 20);
  CHECK(resolve(mesh, block_1 + "contact surface b contains block_2\n").interior_faces_ignored == 4);
  CHECK(resolve(mesh, block_1).interior_faces_ignored == 0);
  CHECK(resolve(mesh, "skin all blocks = on\n").interior_faces_ignored == 0);
}

TEST_CASE("what is claimed is owned or lost, to each winner in its place", "[contact][resolve]") {
  const Mesh mesh = pair_of_hexes().build();
  const auto result = resolve(mesh,
                              "contact surface a contains end\n"
                              "contact surface b contains tops\n"
                              "contact surface c contains block_2 block_1\n"
                              "contact surface d contains block_2\n");
  CHECK(describe(mesh, result) ==
        "a | 2:2 |  |  | \n"
        "b | 1:6 2:6 |  |  | \n"
        "c | 1:1 1:3 1:4 1:5 2:1 2:3 2:5 |  |  | a 1 faces, b 2 faces\n"
        "d |  |  |  | a 1 faces, b 1 faces, c 3 faces\n");
  CHECK(result["c"].lost_to[1].winner == SurfaceIndex{1});
  CHECK(list_warnings(result) ==
        "surface-overlap, line 3, c, 1: surface 'c': 1 face already in surface 'a'\n"
        "surface-overlap, line 3, c, 2: surface 'c': 2 faces already in surface 'b'\n"
        "surface-overlap, line 4, d, 1: surface 'd': 1 face already in surface 'a'\n"
        "surface-overlap, line 4, d, 1: surface 'd': 1 face already in surface 'b'\n"
        "surface-overlap, line 4, d, 3: surface 'd': 3 faces already in surface 'c'\n"
        "surface-empty, line 4, d, 0: surface 'd' owns nothing and takes no part in contact\n");
}

TEST_CASE("names keep the deck's spelling, blocks of SKIN ALL BLOCKS the mesh's", "[contact][resolve]") {
  MeshBuilder b;
  b.add_hexes({.id = 7, .name = "Upper Plate"});
  b.add_hexes({.id = 9, .origin = {5, 0, 0}});
  const Mesh mesh = b.build();
  const auto line = resolve(mesh, "contact surface MySurf contains UPPER_plate\n");
  CHECK(line["MySurf"].faces.size() == 6);
  const auto skin = resolve(mesh, "skin all blocks = on\n");
  REQUIRE(skin.surfaces.size() == 2);
  CHECK(skin.surfaces[{0}].name == "Upper Plate");
  CHECK(skin.surfaces[{1}].name == "block_9");
}

TEST_CASE("tetrahedra, wedges and pyramids are skinned", "[contact][resolve]") {
  // Two cells in a row have 10 quadrilaterals outside. Tetrahedra cut each into two triangles; wedges only
  // the two tops and the two bottoms: 6 quadrilaterals and 8 triangles; pyramids none.
  MeshBuilder b;
  b.add_tets({.id = 1, .cells = {2, 1, 1}}, 6);
  b.add_tets({.id = 2, .cells = {2, 1, 1}, .origin = {0, 2, 0}}, 5);
  b.add_wedges({.id = 3, .cells = {2, 1, 1}, .origin = {0, 4, 0}});
  b.add_pyramids({.id = 4, .cells = {2, 1, 1}, .origin = {0, 6, 0}});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "skin all blocks = on\n");
  CHECK(result["block_1"].faces.size() == 20);
  CHECK(result["block_2"].faces.size() == 20);
  CHECK(result["block_3"].faces.size() == 14);
  CHECK(result["block_4"].faces.size() == 10);
  for (const ElementSide face : result["block_4"].faces) CHECK(face.side() == 5);  // the base
}

TEST_CASE("a block with elements of an unknown type matters only in contact", "[contact][resolve]") {
  MeshBuilder b = pair_of_hexes();
  MeshParts parts = b.parts();
  ElementBlock odd;
  odd.id = 9;
  odd.type_name = "NFACED";
  odd.n_elements = 3;
  odd.nodes_per_element = 11;
  parts.blocks.push_back(odd);
  parts.path = "m.g";
  parts.side_sets.push_back({4, "on_odd", {ElementSide({3}, 1)}, {}});
  const Mesh mesh(parts);
  const std::string unused = GENERATE(
      as<std::string>{}, "contact surface s contains block_1\n", "skin all blocks = on exclude block_9\n",
      "begin contact surface s\n include all blocks\n remove block = block_9\nend\n",
      "begin contact surface s\n block = block_9 block_1\n remove block = block_9\nend\n",
      "begin contact surface s\n block = block_1\n remove surface = on_odd\nend\n",
      "begin contact surface s\n block = block_1\n remove surface = on_odd\nend\n"
      "restrict contact to subdomain defined by radius 1 and point 0 0 0\n");
  CHECK(resolve(mesh, unused).messages.empty());
  const std::string used = GENERATE(
      as<std::string>{}, "contact surface s contains block_9\n", "skin all blocks = on\n",
      "contact surface s contains on_odd\n", "contact node set s contains on_odd\n",
      "contact node set s contains block_9\n", "begin contact surface s\n include all blocks\nend\n");
  try {
    resolve(mesh, used);
    FAIL("no error for: " << used);
  } catch (const std::exception& error) {
    CHECK(std::string(error.what())
              .rfind("m.g: block 9 (block_9): element type 'NFACED' with 11 nodes per "
                     "element, which contact at c.i:1:",
                     0) == 0);
  }
}

TEST_CASE("an empty block makes an empty surface", "[contact][resolve]") {
  MeshParts parts = pair_of_hexes().parts();
  ElementBlock none;
  none.id = 9;
  none.type_name = "NFACED";
  parts.blocks.push_back(none);
  const Mesh mesh(parts);
  const auto result = resolve(mesh, "skin all blocks = on\n");
  REQUIRE(result.messages.empty());
  CHECK(result["block_9"].is_empty());
  CHECK(list_warnings(result) ==
        "surface-empty, line 1, block_9, 0: surface 'block_9' owns nothing and takes no part in contact\n");
}

TEST_CASE("an analytic object is a surface's own", "[contact][resolve]") {
  const Mesh mesh = pair_of_hexes().build();
  const Region region = parse_region(
      "begin analytic object Floor\n type = plane\n normal direction = 0 0 1\nend\n"
      "begin analytic object wall\n type = plane\n normal direction = 1 0 0\nend\n"
      "begin contact definition\n"
      "  contact surface ground contains wall FLOOR\n"
      "  contact surface rest contains block_1\n"
      "end\n");
  const auto result = resolve(mesh, region);
  REQUIRE(result.messages.empty());
  CHECK(result["ground"].analytic_planes == std::vector<std::uint32_t>{1, 0});
  CHECK(result["ground"].faces.empty());
  CHECK(result["rest"].faces.size() == 6);
  CHECK(result.warnings.empty());
}

TEST_CASE("INCLUDE ALL BLOCKS leaves out blocks of particles and says so", "[contact][resolve]") {
  MeshBuilder b = pair_of_hexes();
  b.add_spheres(5, "dust", {{0, 5, 0}, {1, 5, 0}});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh,
                              "contact surface first contains block_1\n"
                              "begin contact surface s\n include all blocks\nend\n"
                              "contact surface last contains block_2\n");
  CHECK(result["s"].lofted_elements.empty());
  CHECK(list_warnings(result) ==
        "surface-particles-left-out, line 2, s, 1: surface 's': INCLUDE ALL BLOCKS leaves out blocks of "
        "particles only: dust\n"
        "surface-overlap, line 2, s, 5: surface 's': 5 faces already in surface 'first'\n"
        "surface-overlap, line 5, last, 5: surface 'last': 5 faces already in surface 's'\n"
        "surface-empty, line 5, last, 0: surface 'last' owns nothing and takes no part in contact\n");
  const auto removed =
      resolve(mesh, "begin contact surface s\n include all blocks\n remove block = dust\nend\n");
  CHECK(removed.warnings.empty());
}
