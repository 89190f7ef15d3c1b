// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_detection.hpp"

#include <Eigen/Geometry>

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::OverlappingBodies;

namespace {

/// A square sheet of one shell, 0.2 thick, over a cube.
test::MeshBuilder sheet_over_cube(double middle) {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .size = {3, 3, 1}});
  test::add_plate(b, {.id = 2, .origin = {1, 1, middle}}, 0.2);
  return b;
}

/// A unit cube over a plane whose normal is up and not of unit length.
OverlappingBodies cube_over_plane(double bottom) {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .origin = {0, 0, bottom}});
  return {b, test::parse_region("begin analytic object ground\nnormal direction = 0 0 2\nend\n"
                                "begin contact definition\nskin all blocks = on\n"
                                "contact surface floor contains ground\n"
                                "begin interaction defaults\ngeneral contact = on\nend\nend\n")};
}

}  // namespace

TEST_CASE("nodes behind a face go out along its normal by their depth", "[contact][overlap]") {
  OverlappingBodies cubes(OverlappingBodies::cubes(0.1));
  const std::vector<Overlap> found = cubes.overlaps();
  REQUIRE(found.size() == 4);  // corners of the upper cube; those of the lower one are beside
  for (const Overlap& overlap : found) {
    CHECK(overlap.first.is_node());
    CHECK(overlap.depth == Approx(0.1));
    CHECK(overlap.distance == Approx(0.1));
    CHECK(overlap.normal.isApprox(Vector3d(0, 0, 1)));
    CHECK(overlap.mover == OverlapMover::first);
    // The point of the face is below the node.
    Vector3d at = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      at += overlap.second.weights[static_cast<Eigen::Index>(k)] * cubes.points.at(overlap.second.nodes[k]);
    CHECK(at.isApprox(cubes.points.at(overlap.first.nodes[0]) + Vector3d(0, 0, 0.1)));
  }
}

TEST_CASE("what touches, or lies in front, overlaps nowhere", "[contact][overlap]") {
  CHECK(OverlappingBodies(OverlappingBodies::cubes(0.0)).overlaps().empty());
  CHECK(OverlappingBodies(OverlappingBodies::cubes(-0.1)).overlaps().empty());
  CHECK(OverlappingBodies(OverlappingBodies::cubes(1e-12)).overlaps().empty());
  CHECK(OverlappingBodies(OverlappingBodies::cubes(1e-6)).overlaps().size() == 4);
}

TEST_CASE("deeper than half the element, or than the pair says, a node is not in by accident",
          "[contact][overlap]") {
  CHECK(OverlappingBodies(OverlappingBodies::cubes(0.49)).overlaps().size() == 4);
  CHECK(OverlappingBodies(OverlappingBodies::cubes(0.51)).overlaps().empty());
  const auto with = [](const std::string& tolerance) {
    return test::general_contact("overlap normal tolerance = " + tolerance + "\n");
  };
  CHECK(OverlappingBodies(OverlappingBodies::cubes(0.1), with("0.05")).overlaps().empty());
  CHECK(OverlappingBodies(OverlappingBodies::cubes(0.6), with("0.7")).overlaps().size() == 4);
}

TEST_CASE("overlaps turn with the bodies and scale with them", "[contact][overlap]") {
  const double scale = GENERATE(1e-3, 1.0, 1e3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  MeshParts moved = OverlappingBodies::cubes(0.1).parts();
  test::MeshBuilder b;
  std::vector<std::uint32_t> first, second;
  const std::array<std::uint32_t, 8> hex{0, 1, 3, 2, 4, 5, 7, 6};
  for (Eigen::Index i = 0; i < 16; ++i) b.add_node(scale * (turn * moved.coordinates.col(i)));
  for (const std::uint32_t k : hex) {
    first.push_back(k);
    second.push_back(k + 8);
  }
  b.add_block(1, "", Shape::hex8, first).add_block(2, "", Shape::hex8, second);
  OverlappingBodies cubes(b);
  const std::vector<Overlap> found = cubes.overlaps();
  REQUIRE(found.size() == 4);
  for (const Overlap& overlap : found) {
    CHECK(overlap.depth == Approx(0.1 * scale));
    CHECK(overlap.normal.isApprox(turn.col(2)));
  }
}

TEST_CASE("a corner that has passed an edge goes out the shorter way", "[contact][overlap]") {
  // The upper cube stands over an edge of the lower one by 0.05 only, and is 0.2 deep.
  OverlappingBodies cubes(OverlappingBodies::cubes(0.2, 0.95));
  for (const Overlap& overlap : cubes.overlaps()) CHECK(overlap.depth == Approx(0.05));
}

TEST_CASE("a sheet is in a solid by its lofted face", "[contact][overlap]") {
  OverlappingBodies bodies(sheet_over_cube(1.06));
  const std::vector<Overlap> found = bodies.overlaps();
  REQUIRE(found.size() == 4);
  for (const Overlap& overlap : found) {
    CHECK(overlap.depth == Approx(0.04));
    CHECK(overlap.normal.isApprox(Vector3d(0, 0, 1)));
  }
  // Of lofts the tolerance is left.
  CHECK(OverlappingBodies(sheet_over_cube(1.06)).overlaps({0}, 0.03).size() == 4);
  CHECK(OverlappingBodies(sheet_over_cube(1.06)).overlaps({0}, 0.05).empty());
  CHECK(OverlappingBodies(sheet_over_cube(1.11)).overlaps().empty());
}

TEST_CASE("a sphere is in a face by its radius, and gives way to what is held", "[contact][overlap]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .size = {3, 3, 1}});
  const double middle = GENERATE(1.2, 0.9);  // before and behind the face
  test::add_balls(b, 2, {{1.4, 1.6, middle}}, 0.25);
  OverlappingBodies bodies(b);
  const std::vector<Overlap> found = bodies.overlaps();
  REQUIRE(found.size() == 1);
  CHECK(found[0].depth == Approx(1.25 - middle));
  CHECK(found[0].distance == Approx(std::abs(middle - 1.0)));
  CHECK(found[0].mover == OverlapMover::ball);
}

TEST_CASE("rods in each other part along the way between their axes", "[contact][overlap]") {
  test::MeshBuilder b;
  test::add_rod(b, {.id = 1, .from = {-1, 0, 0}, .to = {1, 0, 0}});
  test::add_rod(b, {.id = 2, .from = {0.5, -1, 0.17}, .to = {0.5, 1, 0.17}});
  OverlappingBodies rods(b);
  const std::vector<Overlap> found = rods.overlaps();
  REQUIRE(found.size() == 1);
  CHECK(found[0].depth == Approx(0.03));
  CHECK(std::abs(found[0].normal.z()) == Approx(1.0));
  CHECK(found[0].mover == OverlapMover::both);
  // The first is below or above the other by its own normal.
  const Vector3d first = rods.points.at(found[0].first.nodes[0]),
                 second = rods.points.at(found[0].second.nodes[0]);
  CHECK(found[0].normal.z() * (first.z() - second.z()) > 0.0);
  CHECK(found[0].first.weights.sum() == Approx(1.0));
}

TEST_CASE("edges of sheets cross though no node is in the other", "[contact][overlap]") {
  // Two strips across each other, 0.2 thick, whose skins are 0.05 in each other.
  test::MeshBuilder b;
  test::add_plate(b, {.id = 1, .origin = {-2, -0.5, 0}, .u = {4, 0, 0}, .v = {0, 1, 0}}, 0.2);
  test::add_plate(b, {.id = 2, .origin = {-0.5, -2, 0.15}, .u = {1, 0, 0}, .v = {0, 4, 0}}, 0.2);
  OverlappingBodies strips(b);
  const std::vector<Overlap> found = strips.overlaps();
  REQUIRE(found.size() == 4);  // two edges with two
  for (const Overlap& overlap : found) {
    CHECK(overlap.mover == OverlapMover::both);
    CHECK(overlap.depth == Approx(0.05));
    CHECK(std::abs(overlap.normal.z()) == Approx(1.0));
    CHECK(overlap.first.weights.maxCoeff() == Approx(0.625));
  }
}

TEST_CASE("nodes in front of faces are found as far as one reaches for them", "[contact][overlap]") {
  OverlappingBodies cubes(OverlappingBodies::cubes(-0.1));
  cubes.search.widen(0.2);
  cubes.search.find(cubes.points.renewed());
  const OverlapDetection detection(cubes.model, cubes.parts, cubes.search, cubes.points, 0.0);
  const SurfacePair& pair = cubes.model.pairs[{0}];
  std::size_t n_found = 0;
  const auto& near = cubes.search.sites()[{0}].meshed.faces;
  for (std::size_t begin = 0, end = 0; begin < near.size(); begin = end) {
    while (end < near.size() && near[end].entity == near[begin].entity) ++end;
    const auto of_node = std::span(near).subspan(begin, end - begin);
    CHECK_FALSE(detection.find_before_faces(pair, of_node, 0.09));
    const auto found = detection.find_before_faces(pair, of_node, 0.11);
    if (!found) continue;
    ++n_found;
    CHECK(found->depth == Approx(-0.1));
    CHECK(found->normal.isApprox(Vector3d(0, 0, 1)));
  }
  CHECK(n_found == 4);
}

TEST_CASE("nodes behind a plane go out along its normal, those in front are found by a reach",
          "[contact][overlap]") {
  OverlappingBodies low = cube_over_plane(-0.02);
  const std::vector<Overlap> found = low.overlaps();
  REQUIRE(found.size() == 4);
  for (const Overlap& overlap : found) {
    CHECK(overlap.depth == Approx(0.02));
    CHECK(overlap.normal == Vector3d(0, 0, 1));
    CHECK(overlap.second.weights.isZero(0.0));
  }
  CHECK(cube_over_plane(0.0).overlaps().empty());
  CHECK(cube_over_plane(-0.6).overlaps().empty());  // deeper than half the element
  OverlappingBodies high = cube_over_plane(0.1);
  CHECK(high.overlaps().empty());
  const OverlapDetection detection(high.model, high.parts, high.search, high.points, 0.0);
  const auto& planes = high.search.sites()[{0}].meshed.planes;
  CHECK(planes.size() == 8);
  std::size_t n_before = 0;
  for (const NodePlaneCandidate& candidate : planes) {
    CHECK_FALSE(detection.find_before_plane(candidate, 0.09));
    const auto before = detection.find_before_plane(candidate, 2.0);
    if (!before) continue;  // the top looks away
    ++n_before;
    CHECK(before->depth == Approx(-0.1));
  }
  CHECK(n_before == 4);
}
