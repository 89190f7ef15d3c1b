// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_search.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;
using test::OverlappingBodies;

namespace {

/// The nodes of the mesh, and the elements, of candidates.
std::set<std::pair<std::uint32_t, std::uint32_t>> nodes_and_elements(
    const OverlappingBodies& bodies, const std::vector<NodeFaceCandidate>& candidates) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  const ContactMesh& contact_mesh = bodies.parts.contact_mesh;
  for (const NodeFaceCandidate& candidate : candidates) {
    found.emplace(contact_mesh.mesh_nodes[contact_mesh.surface_nodes[candidate.entity].node].value,
                  contact_mesh.faces[candidate.partner].side.element().value);
  }
  return found;
}

/// A plate 0.2 thick whose middle is at a height, over the top of a cube at 1.
test::MeshBuilder plate_over_cube(double middle) {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .size = {3, 3, 1}});
  test::add_plate(b, {.id = 2, .origin = {1, 1, middle}}, 0.2);
  return b;
}

}  // namespace

TEST_CASE("nodes are near faces that either may reach, and never those of their own element",
          "[contact][overlap]") {
  OverlappingBodies near(OverlappingBodies::cubes(-0.9), test::general_contact("self contact = on\n"));
  near.search.find(near.points.renewed());
  for (const PairIndex pair : indices(near.search.sites())) {
    const PairSites& sites = near.search.sites()[pair];
    CHECK_FALSE(sites.has_lofts());
    for (const auto& [node, element] : nodes_and_elements(near, sites.meshed.faces))
      CHECK((node < 8 ? 0u : 1u) != element);
    const auto& faces = sites.meshed.faces;
    CHECK(std::ranges::is_sorted(faces, [](const NodeFaceCandidate& a, const NodeFaceCandidate& b) {
      return std::pair(a.entity, a.partner) < std::pair(b.entity, b.partner);
    }));
  }
  // The boxes of faces are wider by twice half their thickness: the bottom nodes of the upper cube at 1.9.
  std::set<std::uint32_t> nodes;
  for (const PairSites& sites : near.search.sites()) {
    for (const auto& [node, element] : nodes_and_elements(near, sites.meshed.faces)) {
      if (node >= 8) nodes.insert(node);
    }
  }
  CHECK(nodes == std::set<std::uint32_t>{8, 9, 10, 11});
}

TEST_CASE("far apart nothing is near until the search is reported to look farther", "[contact][overlap]") {
  const auto n_near = [](double widened) {
    OverlappingBodies far(OverlappingBodies::cubes(-1.2));
    far.search.widen(widened);
    far.search.find(far.points.renewed());
    return far.search.sites()[{0}].meshed.faces.size();
  };
  CHECK(n_near(0.0) == 0);
  CHECK(n_near(0.55) == 0);  // less than half the thickness that counts anyway
  CHECK(n_near(0.65) > 0);
  OverlappingBodies tolerant(OverlappingBodies::cubes(-1.2),
                             test::general_contact("overlap normal tolerance = 0.65\n"));
  tolerant.search.find(tolerant.points.renewed());
  CHECK(tolerant.search.sites()[{0}].meshed.faces.size() > 0);
}

TEST_CASE("lofts are looked at apart from solids, with the edges that may cross", "[contact][overlap]") {
  OverlappingBodies bodies(plate_over_cube(1.05));
  bodies.search.find(bodies.points.renewed());
  const PairSites& sites = bodies.search.sites()[{0}];
  CHECK(sites.meshed.faces.empty());
  CHECK(sites.lofted.faces.size() > 0);
  CHECK(sites.has_lofts());
  for (const FacePairCandidate& rim : sites.rims) {
    const ContactMesh& contact_mesh = bodies.parts.contact_mesh;
    const Eigen::Vector3d first = bodies.points.renewed().area(contact_mesh.faces[rim.entity]),
                          second = bodies.points.renewed().area(contact_mesh.faces[rim.partner]);
    CHECK(first.dot(second) < 0.0);
  }
  CHECK(sites.rims.size() > 0);
}

TEST_CASE("sites of lofts are found anew once something has gone far", "[contact][overlap]") {
  OverlappingBodies bodies(plate_over_cube(1.9));
  bodies.search.find(bodies.points.renewed());
  const PairSites& sites = bodies.search.sites()[{0}];
  const auto move_plate = [&](double by) {
    for (std::uint32_t node = 8; node < 12; ++node) bodies.points.shift(NodeIndex{node}, {0, 0, by});
    bodies.points.renew();
    bodies.search.renew_lofts(bodies.points.renewed());
  };
  const std::size_t before = sites.lofted.faces.size(), rims = sites.rims.size();
  move_plate(10.0);
  CHECK(sites.lofted.faces.empty());
  CHECK(sites.rims.empty());
  move_plate(-10.0);
  CHECK(sites.lofted.faces.size() == before);
  CHECK(sites.rims.size() == rims);
  REQUIRE(before > 0);
  move_plate(0.04);  // less than a quarter of its thickness: nothing is looked for
  CHECK(sites.lofted.faces.size() == before);
}

TEST_CASE("rods are near rods, but sharp edges among each other are not looked at", "[contact][overlap]") {
  test::MeshBuilder b;
  test::add_rod(b, {.id = 1, .from = {-1, 0, 0}, .to = {1, 0, 0}});
  test::add_rod(b, {.id = 2, .from = {0.5, -1, 0.17}, .to = {0.5, 1, 0.17}});
  OverlappingBodies rods(b);
  rods.search.find(rods.points.renewed());
  CHECK(rods.search.sites()[{0}].edges.size() == 1);
  rods.search.renew_lofts(rods.points.renewed());
  CHECK(rods.search.sites()[{0}].edges.size() == 1);
  OverlappingBodies bars(test::crossed_bars(-0.01), test::general_contact());
  bars.search.find(bars.points.renewed());
  for (const PairSites& sites : bars.search.sites()) CHECK(sites.edges.empty());
}

TEST_CASE("a mesh without faces has nothing near", "[contact][overlap]") {
  test::MeshBuilder b;
  test::add_balls(b, 1, {{0, 0, 0}}, 0.3);
  test::add_balls(b, 2, {{0, 0, 5}}, 0.3);
  OverlappingBodies balls(b);
  balls.search.find(balls.points.renewed());
  CHECK_FALSE(balls.search.sites()[{0}].has_lofts());
  CHECK(balls.overlaps().empty());
}
