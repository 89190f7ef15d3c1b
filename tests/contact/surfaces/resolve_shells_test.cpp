// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// Shells, lines and particles. Sides of a hexahedron: 1 looks along -y, 2 along +x, 3 along +y, 4 along -x, 5
// along -z, 6 along +z. Of a shell: 1 is its top, 2 its bottom, 3 and up its edges.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// 8.4.8.5: a brick of 4 x 2 x 2 cells (40 faces), its top covered by 2 x 2 shells for x < 2. Top layer:
///   13 14 15 16    shells on it:  19 20
///    9 10 11 12                   17 18
MeshBuilder clad_brick() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 2, 2}, .size = {4, 2, 2}});
  b.add_shells({.id = 2, .cells = {2, 2}, .origin = {0, 0, 2}, .u = {2, 0, 0}, .v = {0, 2, 0}});
  return b;
}

bool is_outside(const CandidateSide& c) {
  const auto& x = c.centroid;
  const bool is_top = x.z() > 1.9;
  return c.block_id == 1 &&
         (x.x() < 0.1 || x.x() > 3.9 || x.y() < 0.1 || x.y() > 1.9 || x.z() < 0.1 || is_top);
}

bool is_clad(const CandidateSide& c) { return c.centroid.z() > 1.9 && c.centroid.x() < 2; }

/// One hexahedron (element 1) with a shell on its top (2), and a shell by itself (3). surface_1: the
/// hexahedron's top; surface_2: the tops of both shells; surface_3: the bottom of the lone shell.
MeshBuilder capped_hex() {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .origin = {0, 0, 1}});
  b.add_shells({.id = 3, .origin = {5, 0, 0}});
  b.add_side_set(1, "", {{{0}, 6}});
  b.add_side_set(2, "", {{{1}, 1}, {{2}, 1}});
  b.add_side_set(3, "", {{{2}, 2}});
  return b;
}

}  // namespace

TEST_CASE("8.4.8.5 (B): shells lie outside of the solid in either order", "[contact][shells]") {
  const MeshBuilder b = clad_brick();
  const Mesh mesh = b.build();
  const std::string c1 = "contact surface c1 contains block_1\n",
                    c2 = "contact surface c2 contains block_2\n";
  for (const std::string& lines : {c1 + c2, c2 + c1}) {
    const auto result = resolve(mesh, lines);
    REQUIRE(result.messages.empty());
    CHECK(result["c1"].faces ==
          faces_where(b, [](const CandidateSide& c) { return is_outside(c) && !is_clad(c); }));
    CHECK(result["c1"].faces.size() == 36);  // 40 - 4
    CHECK(list_lofted(mesh, result["c2"]) == "17 18 19 20");
    CHECK(result["c2"].faces.empty());
    CHECK(result.warnings.empty());
  }
}

TEST_CASE("8.4.8.5 (C): a dead shell exposes the solid face under it", "[contact][shells][death]") {
  const MeshBuilder b = clad_brick();
  const Mesh mesh = b.build();
  const auto result = resolve(mesh,
                              "contact surface c1 contains block_1\n"
                              "contact surface c2 contains block_2\n",
                              all_but(mesh, {17}));
  CHECK(result["c1"].faces == faces_where(b, [](const CandidateSide& c) {
          const bool is_under_17 = c.side == ElementSide({8}, 6);
          return is_outside(c) && (!is_clad(c) || is_under_17);
        }));
  CHECK(result["c1"].faces.size() == 37);
  CHECK(list_lofted(mesh, result["c2"]) == "18 19 20");
}

TEST_CASE("8.4.8.5 (C): a shell outlives the solid element under it", "[contact][shells][death]") {
  const Mesh mesh = clad_brick().build();
  // Element 9 shows 9:1 and 9:4 (its top is covered) and hides 1:6, 10:4 and 13:1: 36 - 2 + 3.
  const auto result = resolve(mesh,
                              "contact surface c1 contains block_1\n"
                              "contact surface c2 contains block_2\n",
                              all_but(mesh, {9}));
  CHECK(result["c1"].faces.size() == 37);
  for (const ElementSide exposed : {ElementSide({0}, 6), ElementSide({9}, 4), ElementSide({12}, 1)}) {
    const auto& faces = result["c1"].faces;
    CHECK(std::find(faces.begin(), faces.end(), exposed) != faces.end());
  }
  CHECK(list_lofted(mesh, result["c2"]) == "17 18 19 20");
}

TEST_CASE("shells that are not in contact leave the solid its faces", "[contact][shells]") {
  const Mesh mesh = clad_brick().build();
  CHECK(resolve(mesh, "contact surface c1 contains block_1\n")["c1"].faces.size() == 40);
  CHECK(resolve(mesh, "skin all blocks = on exclude block_2\n")["block_1"].faces.size() == 40);
}

TEST_CASE("ELEMENT picks single shells, which alone are present", "[contact][shells]") {
  const Mesh mesh = clad_brick().build();
  const auto result = resolve(mesh,
                              "contact surface c1 contains block_1\n"
                              "begin contact surface c2\n"
                              "  element = 20 18\n"
                              "  element = 18\n"
                              "end\n");
  REQUIRE(result.messages.empty());
  CHECK(list_lofted(mesh, result["c2"]) == "18 20");
  CHECK(result["c1"].faces.size() == 38);  // 40 - 2
}

TEST_CASE("ELEMENT picks lines and particles too, by the user's ids", "[contact][shells]") {
  MeshBuilder b;
  b.add_beams({.id = 1, .cells = 2});
  b.add_spheres(2, "", {{0, 5, 0}, {1, 5, 0}});
  b.set_element_ids({40, 30, 20, 10});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "begin contact surface s\n element = 10, 40\nend\n");
  REQUIRE(result.messages.empty());
  CHECK(list_lofted(mesh, result["s"]) == "40 10");
}

TEST_CASE("a side-set face under a shell stays in the side set's surface", "[contact][shells]") {
  const Mesh mesh = capped_hex().build();
  const std::string side_set = "contact surface a contains surface_1\n";
  for (const std::string& lines :
       {side_set + "skin all blocks = on\n", "skin all blocks = on\n" + side_set}) {
    const auto result = resolve(mesh, lines);
    CHECK(list_faces(mesh, result["a"]) == "1:6");
    CHECK(list_faces(mesh, result["block_1"]) == "1:1 1:2 1:3 1:4 1:5");
    CHECK(list_lofted(mesh, result["block_2"]) == "2");
    CHECK(result.warnings.empty());
  }
}

TEST_CASE("a lofted element belongs to the first surface that claims it", "[contact][shells]") {
  const Mesh mesh = capped_hex().build();
  const auto result = resolve(mesh,
                              "begin contact surface picked\n element = 3\nend\n"
                              "contact surface s contains block_3 block_2\n"
                              "contact surface t contains block_2\n");
  CHECK(describe(mesh, result) ==
        "picked |  | 3 |  | \n"
        "s |  | 2 |  | picked 1 lofted\n"
        "t |  |  |  | s 1 lofted\n");
  CHECK(list_warnings(result) ==
        "surface-overlap, line 4, s, 1: surface 's': 1 lofted element already in surface 'picked'\n"
        "surface-overlap, line 5, t, 1: surface 't': 1 lofted element already in surface 's'\n"
        "surface-empty, line 5, t, 0: surface 't' owns nothing and takes no part in contact\n");
}

TEST_CASE("a shell's face in a side set and its loft are one thing to contact", "[contact][shells]") {
  const Mesh mesh = capped_hex().build();
  const auto faces_first = resolve(mesh,
                                   "contact surface faces contains surface_2\n"
                                   "contact surface lofts contains block_3\n"
                                   "contact surface more contains surface_3\n");
  // The other side of shell 3 is still free.
  CHECK(describe(mesh, faces_first) ==
        "faces | 2:1 3:1 |  |  | \n"
        "lofts |  |  |  | faces 1 lofted\n"
        "more | 3:2 |  |  | \n");
  const auto bottom_first = resolve(mesh,
                                    "contact surface more contains surface_3\n"
                                    "contact surface lofts contains block_3\n");
  CHECK(describe(mesh, bottom_first) ==
        "more | 3:2 |  |  | \n"
        "lofts |  |  |  | more 1 lofted\n");
  const auto lofts_first = resolve(mesh,
                                   "contact surface lofts contains block_3\n"
                                   "contact surface faces contains surface_2 surface_3\n");
  CHECK(describe(mesh, lofts_first) ==
        "lofts |  | 3 |  | \n"
        "faces | 2:1 |  |  | lofts 2 faces\n");
  const auto together = resolve(mesh, "contact surface both contains surface_2 block_3 surface_3\n");
  CHECK(describe(mesh, together) == "both | 2:1 | 3 |  | \n");
}

TEST_CASE("a shell whose face is in a side set alone covers no solid", "[contact][shells]") {
  const Mesh mesh = capped_hex().build();
  const auto result =
      resolve(mesh, "contact surface shells contains surface_2\ncontact surface solid contains block_1\n");
  CHECK(list_faces(mesh, result["solid"]) == "1:1 1:2 1:3 1:4 1:5 1:6");
}

TEST_CASE("REMOVE SURFACE takes shells of its side sets out, and they stay present", "[contact][shells]") {
  const Mesh mesh = capped_hex().build();
  const auto result = resolve(mesh,
                              "begin contact surface s\n"
                              "  include all blocks\n"
                              "  remove surface = surface_2\n"
                              "end\n"
                              "contact surface t contains block_3\n");
  CHECK(describe(mesh, result) ==
        "s | 1:1 1:2 1:3 1:4 1:5 |  |  | \n"
        "t |  | 3 |  | \n");
}

TEST_CASE("one surface may hold faces and lofts of every kind", "[contact][shells]") {
  MeshBuilder b = capped_hex();
  b.add_bars({.id = 4, .cells = 2, .from = {0, 5, 0}, .to = {2, 5, 0}});
  b.add_spheres(5, "", {{0, 8, 0}});
  b.add_triangles({.id = 6, .origin = {0, 9, 0}});
  const Mesh mesh = b.build();
  const auto result =
      resolve(mesh, "contact surface s contains block_6 block_5 block_4 block_3 block_2 block_1\n");
  CHECK(describe(mesh, result) == "s | 1:1 1:2 1:3 1:4 1:5 | 2 3 4 5 6 7 8 |  | \n");
}

TEST_CASE("triangular shells cover the faces of tetrahedra", "[contact][shells]") {
  // One tetrahedron; shells on side 1 (1 2 4), and on its base with the nodes turned round.
  MeshBuilder b;
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                   Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    b.add_node(x);
  }
  b.add_block(1, "", Shape::tet4, {0, 1, 2, 3});
  b.add_block(2, "", Shape::shell3, {0, 1, 3, 2, 0, 1});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "skin all blocks = on\n");
  CHECK(list_faces(mesh, result["block_1"]) == "1:2 1:3");
  CHECK(list_lofted(mesh, result["block_2"]) == "2 3");
}
