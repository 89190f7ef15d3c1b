// SPDX-License-Identifier: BSD-3-Clause
// Which lofts lie in each other only because the mesh joins them near by.
#include "contact/mesh/adjacent_faces.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_death.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double thick = 0.5;

/// Ten shells along x that end at the origin and ten up along z, all 0.1 long; joined there or `apart`.
MeshBuilder folded_strip(double apart = 0.0) {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {10, 1}, .origin = {-1, 0, 0}, .v = {0, 0.2, 0}}, thick);
  add_plate(b,
            {.id = 2,
             .cells = {10, 1},
             .origin = {apart, 0, 0},
             .u = Vector3d::UnitZ(),
             .v = {0, 0.2, 0},
             .share_nodes = apart == 0.0},
            thick);
  return b;
}

/// A strip around z from 5 to 355 degrees, of radius 1, 36 shells.
MeshBuilder open_ring() {
  MeshBuilder b;
  constexpr std::uint32_t n = 36;
  for (std::uint32_t k = 0; k <= n; ++k) {
    const double angle = std::numbers::pi / 180.0 * (5.0 + 350.0 * k / n);
    for (const double z : {0.0, 0.2}) b.add_node({std::cos(angle), std::sin(angle), z});
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t k = 0; k < n; ++k) nodes.insert(nodes.end(), {2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
  b.add_block(1, "", Shape::shell4, nodes);
  return b.set_attributes(1, {"thickness"}, std::vector<double>(n, thick));
}

/// The top of a shell's brick.
FaceIndex top_of(const ContactParts& parts, std::uint32_t element) {
  for (const FaceIndex i : indices(parts.contact_mesh.faces)) {
    const ElementSide side = parts.contact_mesh.faces[i].side;
    if (side.element().value == element && side.side() == 1) return i;
  }
  throw std::logic_error("there is no such face");
}

const std::string to_itself = general_contact("self contact = on\n");

}  // namespace

TEST_CASE("at a fold thick shells are adjacent as far as they lie in each other",
          "[contact][adjacent_faces]") {
  const ContactParts parts(folded_strip(), to_itself);
  const AdjacentFaces adjacent(parts.contact_mesh, parts.mesh);
  // Elements 0 to 9 end at the fold, 10 to 19 begin there; lofts stand off by a half of 0.5 each.
  const auto are = [&](std::uint32_t a, std::uint32_t b) {
    CHECK(adjacent.are_adjacent(top_of(parts, a), top_of(parts, b)) ==
          adjacent.are_adjacent(top_of(parts, b), top_of(parts, a)));
    return adjacent.are_adjacent(top_of(parts, a), top_of(parts, b));
  };
  CHECK(are(9, 10));
  CHECK(are(7, 12));        // 0.2 and 0.2 away from the fold: apart by 0.283
  CHECK(are(9, 14));        // 0.4 away
  CHECK_FALSE(are(5, 14));  // 0.4 and 0.4: by 0.566
  CHECK_FALSE(are(0, 19));
  CHECK(are(2, 6));  // of one plate, 0.3 apart
  CHECK_FALSE(are(2, 9));
}

TEST_CASE("lofts that nothing joins are not adjacent however near they are", "[contact][adjacent_faces]") {
  const ContactParts parts(folded_strip(0.01), to_itself);
  const AdjacentFaces adjacent(parts.contact_mesh, parts.mesh);
  CHECK_FALSE(adjacent.are_adjacent(top_of(parts, 9), top_of(parts, 10)));
  CHECK_FALSE(adjacent.are_adjacent(top_of(parts, 7), top_of(parts, 12)));
  CHECK(adjacent.are_adjacent(top_of(parts, 7), top_of(parts, 9)));
}

TEST_CASE("lofts that are joined by a long way round are not adjacent", "[contact][adjacent_faces]") {
  const ContactParts parts(open_ring(), to_itself);
  const AdjacentFaces adjacent(parts.contact_mesh, parts.mesh);
  CHECK_FALSE(adjacent.are_adjacent(top_of(parts, 0), top_of(parts, 35)));  // the ends are 0.174 apart
  CHECK(adjacent.are_adjacent(top_of(parts, 0), top_of(parts, 2)));
  CHECK_FALSE(adjacent.are_adjacent(top_of(parts, 0), top_of(parts, 18)));
}

TEST_CASE("solids have no lofts that could lie in each other", "[contact][adjacent_faces]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 1, 1}, .size = {0.3, 1, 1}});
  const bool has_a_loft = GENERATE(false, true);
  if (has_a_loft) add_plate(b, {.id = 2, .origin = {0, 0, 9}}, thick);
  const ContactParts parts(b, to_itself);
  const AdjacentFaces adjacent(parts.contact_mesh, parts.mesh);
  for (const FaceIndex a : indices(parts.contact_mesh.faces)) {
    for (const FaceIndex c : indices(parts.contact_mesh.faces)) {
      if (parts.contact_mesh.is_lofted(parts.contact_mesh.faces[a])) continue;
      if (parts.contact_mesh.is_lofted(parts.contact_mesh.faces[c])) continue;
      CHECK_FALSE(adjacent.are_adjacent(a, c));
    }
  }
}

TEST_CASE("nodes and edges of lofts are adjacent as faces are", "[contact][adjacent_faces]") {
  const ContactParts parts(folded_strip(), to_itself);
  const AdjacentFaces adjacent(parts.contact_mesh, parts.mesh);
  for (const SurfaceNode& node : parts.contact_mesh.surface_nodes) {
    const Vector3d x = parts.mesh.coordinates().col(parts.contact_mesh.mesh_nodes[node.node].value);
    // Of a node on the strip from the element up along z from 0.3 to 0.4; points of joints stand on the fold.
    const double distance = std::hypot(x.x(), std::max({0.0, 0.3 - x.z(), x.z() - 0.4}));
    const double offset = (parts.kinematics.x(node.node) - x).norm() + 0.5 * thick;
    if (std::abs(distance - offset) < 1e-9) continue;
    CHECK(adjacent.are_adjacent(node, top_of(parts, 13)) == (distance < offset));
  }
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 20, .from = {0, 0, 0}, .to = {1, 0, 0}});  // of radius 0.1, 0.05 long
  add_rod(b, {.id = 2, .cells = 1, .from = {0, 0.01, 0}, .to = {0.05, 0.01, 0}});
  const ContactParts rods(b, to_itself);
  const AdjacentFaces of_rods(rods.contact_mesh, rods.mesh);
  const auto& edges = rods.contact_mesh.edges;
  REQUIRE(edges.size() == 21);
  CHECK(of_rods.are_adjacent(edges[{0}], edges[{4}]));        // 0.15 apart, radii of 0.1 each
  CHECK_FALSE(of_rods.are_adjacent(edges[{0}], edges[{6}]));  // 0.25
  CHECK_FALSE(of_rods.are_adjacent(edges[{0}], edges[{20}]));
}

TEST_CASE("lofts that a death has parted are adjacent no more", "[contact][adjacent_faces]") {
  ContactParts parts(folded_strip(), to_itself);
  AdjacentFaces adjacent(parts.contact_mesh, parts.mesh);
  CHECK(adjacent.are_adjacent(top_of(parts, 8), top_of(parts, 11)));
  let_die(parts, to_itself, {10, 11});  // those at the fold
  adjacent.renew(parts.mesh);
  CHECK_FALSE(adjacent.are_adjacent(top_of(parts, 8), top_of(parts, 11)));
  CHECK(adjacent.are_adjacent(top_of(parts, 11), top_of(parts, 13)));
}
