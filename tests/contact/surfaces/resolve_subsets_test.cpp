// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

// SUBSET and RESTRICT. Sides of a hexahedron: 1 looks along -y, 2 along +x, 3 along +y, 4 along -x, 5 along
// -z, 6 along +z.

using namespace contactsim;
using namespace contactsim::test;

namespace {

Mesh lone_hex() { return MeshBuilder().add_hexes({.id = 1}).build(); }

/// A block form over block_1 with these SUBSET lines.
std::string with_subsets(const std::string& lines) {
  return "begin contact surface s\n block = block_1\n" + lines + "end\n";
}

/// 2 x 3 x 4 cells with a corner in the origin, and contact within a sphere about that corner.
Resolved restricted_brick(const Mesh& mesh, double radius, const std::string& surface) {
  return resolve(mesh, surface + "restrict contact to subdomain defined by radius " + std::to_string(radius) +
                           " and point 0 0 0\n");
}

}  // namespace

TEST_CASE("a face moves when its normal's dot product is above 0.45", "[contact][subset]") {
  // n = (1, 0, 2): 1/sqrt(5) = 0.447 with +x, 0.894 with +z. n = (9, 0, 17): 9/sqrt(370) = 0.468 with +x.
  const Mesh mesh = lone_hex();
  const auto below = resolve(mesh, with_subsets("subset t with normal 1 0 2\n"));
  CHECK(list_faces(mesh, below["s_t"]) == "1:6");
  const auto above = resolve(mesh, with_subsets("subset t with normal 9 0 17\n"));
  CHECK(list_faces(mesh, above["s_t"]) == "1:2 1:6");
  CHECK(list_faces(mesh, above["s"]) == "1:1 1:3 1:4 1:5");
}

TEST_CASE("the threshold lies at 0.45", "[contact][subset]") {
  // The cosine with +x of (c, 0, sqrt(1 - c^2)) is c.
  const Mesh mesh = lone_hex();
  const auto is_moved = [&](double c) {
    const std::string normal = std::to_string(c) + " 0 -" + std::to_string(std::sqrt(1 - c * c));
    const auto result = resolve(mesh, with_subsets("subset t with normal " + normal + "\n"));
    return list_faces(mesh, result["s_t"]) == "1:2 1:5";
  };
  CHECK_FALSE(is_moved(0.4499));
  CHECK(is_moved(0.4501));
}

TEST_CASE("the length of a subset's normal does not matter", "[contact][subset]") {
  const Mesh mesh = lone_hex();
  const std::string normal = GENERATE(as<std::string>{}, "1e-180 0 0", "3 0 0", "1e160 0 0", "1e-3 1e-9 0");
  const auto result = resolve(mesh, with_subsets("subset t with normal " + normal + "\n"));
  CHECK(list_faces(mesh, result["s_t"]) == "1:2");
}

TEST_CASE("a face that fits two subsets goes to the larger dot product", "[contact][subset]") {
  // With +x: 0.8 in far, 1 in near, whatever their order; with +z: 0.6 in far, 0 in near.
  const Mesh mesh = lone_hex();
  const std::string far = "subset far with normal 4 0 3\n", near = "subset near with normal 1 0 0\n";
  for (const std::string& lines : {far + near, near + far}) {
    const auto result = resolve(mesh, with_subsets(lines));
    CHECK(list_faces(mesh, result["s_near"]) == "1:2");
    CHECK(list_faces(mesh, result["s_far"]) == "1:6");
  }
}

TEST_CASE("the first listed subset wins a tie", "[contact][subset]") {
  // (1, 0, 1) and (1, 0, -1) have 0.707 with +x both; the third is nearer by less than the tie's 1e-9.
  const Mesh mesh = lone_hex();
  const std::string up = "subset up with normal 1 0 1\n", down = "subset down with normal 1 0 -1\n";
  const std::string hair = "subset hair with normal 1.0000000002 0 -1\n";
  CHECK(list_faces(mesh, resolve(mesh, with_subsets(up + down))["s_up"]) == "1:2 1:6");
  CHECK(list_faces(mesh, resolve(mesh, with_subsets(down + up))["s_down"]) == "1:2 1:5");
  CHECK(list_faces(mesh, resolve(mesh, with_subsets(up + hair))["s_up"]) == "1:2 1:6");
}

TEST_CASE("a warped face looks along the cross product of its diagonals", "[contact][subset]") {
  // The cube's corner (1,1,1) is lifted to z = 4. The top's diagonals are (1,1,4) - (0,0,1) = (1,1,3) and
  // (0,1,1) - (1,0,1) = (-1,1,0); their cross product (-3,-3,2) has length sqrt(22) = 4.690. With
  // n = (-1,-1,0): 6 / (4.690 sqrt(2)) = 0.905; with +z: 2 / 4.690 = 0.426 < 0.45.
  MeshParts parts = MeshBuilder().add_hexes({.id = 1}).parts();
  const NodeIndex top = parts.blocks[0].nodes[6];
  REQUIRE(parts.coordinates.col(top.value) == Eigen::Vector3d(1, 1, 1));
  parts.coordinates(2, top.value) = 4;
  const Mesh mesh(parts);
  const auto result =
      resolve(mesh, with_subsets("subset up with normal 0 0 1\nsubset side with normal -1 -1 0\n"));
  CHECK(list_faces(mesh, result["s_up"]).empty());
  CHECK(list_faces(mesh, result["s_side"]) == "1:1 1:4 1:6");  // 1:1 and 1:4 by 0.707
}

TEST_CASE("a subset takes from its own surface only, and its surface keeps the losses", "[contact][subset]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_side_set(1, "", {{{0}, 2}, {{0}, 6}});
  const Mesh mesh = b.build();
  const auto result =
      resolve(mesh, "contact surface a contains surface_1\n" +
                        with_subsets("subset x with normal 1 0 0\nsubset y with normal 0 1 0\n") +
                        "contact surface c contains block_1\n");
  CHECK(describe(mesh, result) ==
        "a | 1:2 1:6 |  |  | \n"
        "s | 1:1 1:4 1:5 |  |  | a 2 faces\n"
        "s_x |  |  |  | \n"
        "s_y | 1:3 |  |  | \n"
        "c |  |  |  | a 2 faces, s 3 faces, s_y 1 faces\n");
  CHECK(list_warnings(result) ==
        "surface-overlap, line 2, s, 2: surface 's': 2 faces already in surface 'a'\n"
        "surface-empty, line 4, s_x, 0: surface 's_x' owns nothing and takes no part in contact\n"
        "surface-overlap, line 7, c, 2: surface 'c': 2 faces already in surface 'a'\n"
        "surface-overlap, line 7, c, 3: surface 'c': 3 faces already in surface 's'\n"
        "surface-overlap, line 7, c, 1: surface 'c': 1 face already in surface 's_y'\n"
        "surface-empty, line 7, c, 0: surface 'c' owns nothing and takes no part in contact\n");
}

TEST_CASE("lofted elements stay in the surface that subsets are cut from", "[contact][subset]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).add_shells({.id = 2, .origin = {0, 0, 5}}).build();
  const auto result =
      resolve(mesh, "begin contact surface s\n block = block_1 block_2\n subset up with normal 0 0 1\nend\n");
  CHECK(list_faces(mesh, result["s_up"]) == "1:6");
  CHECK(list_lofted(mesh, result["s"]) == "2");
  CHECK(result["s_up"].lofted_elements.empty());
}

TEST_CASE("RESTRICT keeps the faces with all their nodes within the sphere", "[contact][restrict]") {
  // The three faces at the corner have their far nodes at sqrt(2) = 1.414; the next faces at sqrt(5) = 2.236.
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {2, 3, 4}, .size = {2, 3, 4}}).build();
  const std::string surface = "contact surface s contains block_1\n";
  CHECK(list_faces(mesh, restricted_brick(mesh, 2.2, surface)["s"]) == "1:1 1:4 1:5");
  CHECK(list_faces(mesh, restricted_brick(mesh, 1.42, surface)["s"]) == "1:1 1:4 1:5");
  CHECK(restricted_brick(mesh, 1.41, surface)["s"].faces.empty());
  // Within 2.24 each of the three planes at the corner gains the two faces at its axes.
  CHECK(restricted_brick(mesh, 2.24, surface)["s"].faces.size() == 9);
  CHECK(list_warnings(restricted_brick(mesh, 1.41, surface)) ==
        "surface-empty, line 1, s, 0: surface 's' owns nothing and takes no part in contact\n");
}

TEST_CASE("RESTRICT keeps what touches the sphere from inside", "[contact][restrict]") {
  // About the middle of the top face: its nodes at sqrt(1/2), those of the bottom at sqrt(3/2). Moved by the
  // 3-4-5 triangle: nodes 5 away exactly.
  MeshBuilder b;
  b.add_hexes({.id = 1, .origin = {-3, -4, 0}, .size = {6, 8, 7}});
  b.add_node_set(1, "", [](const Eigen::Vector3d& x) { return x.z() < 0.1; });
  const Mesh mesh = b.build();
  const std::string surfaces =
      "contact surface s contains block_1\n"
      "contact node set n contains nodelist_1\n"
      "restrict contact to subdomain defined by radius ";
  const auto on = resolve(mesh, surfaces + "5 and point 0 0 0\n");
  CHECK(list_faces(mesh, on["s"]) == "1:5");
  CHECK(on["n"].nodes.size() == 4);
  const auto inside = resolve(mesh, surfaces + "4.9999 and point 0 0 0\n");
  CHECK(inside["s"].faces.empty());
  CHECK(inside["n"].nodes.empty());
}

TEST_CASE("RESTRICT to a box keeps what has all its nodes in it or on it", "[contact][restrict]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 3, 4}, .size = {2, 3, 4}});
  b.add_node_set(1, "", [](const Eigen::Vector3d& x) { return x.z() == 4.0; });
  const Mesh mesh = b.build();
  const auto n_in = [&](const std::string& box) {
    const auto result = resolve(mesh,
                                "contact surface s contains block_1\ncontact node set n contains nodelist_1\n"
                                "restrict contact to box defined by " +
                                    box + "\n");
    CHECK(result.messages == "");
    return std::pair(result["s"].faces.size(), result["n"].nodes.size());
  };
  using Counts = std::pair<std::size_t, std::size_t>;
  CHECK(n_in("-0.1 -0.1 -0.1 and 1.1 1.1 1.1") ==
        Counts(3, 0));  // the three outer faces of the cube in the corner
  CHECK(n_in("-0.1 -0.1 -0.1 and 2.1 3.1 4.1") == Counts(52, 12));
  CHECK(n_in("0 0 0 and 2 3 4") == Counts(52, 12));
  CHECK(n_in("2 3 4 and 0 0 0.1") == Counts(36, 12));  // 52 less the bottom's 6 and the lowest ring's 10
  CHECK(n_in("0 0 3.9 and 1 2 4.1") == Counts(2, 6));
}

TEST_CASE("RESTRICT keeps lofted elements and nodes by their own nodes", "[contact][restrict]") {
  MeshBuilder b;
  b.add_beams({.id = 1, .cells = 4, .from = {0, 0, 0}, .to = {4, 0, 0}});
  b.add_node_set(1, "", [](const Eigen::Vector3d&) { return true; });
  const Mesh mesh = b.build();
  const auto result = resolve(mesh,
                              "contact surface s contains block_1\n"
                              "contact node set n contains nodelist_1\n"
                              "restrict contact to subdomain defined by radius 2.5 and point 0 0 0\n");
  CHECK(list_lofted(mesh, result["s"]) == "1 2");
  CHECK(list_nodes(mesh, result["n"]) == "1 2 3");
}

TEST_CASE("what lies outside of the sphere still covers its neighbours", "[contact][restrict]") {
  // The second hexahedron is outside; the face between the two stays interior.
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}}).build();
  const auto result = resolve(mesh,
                              "contact surface s contains block_1\n"
                              "restrict contact to subdomain defined by radius 0.9 and point 0.5 0.5 0.5\n");
  CHECK(list_faces(mesh, result["s"]) == "1:1 1:3 1:4 1:5 1:6");  // half a space diagonal is 0.866
}
