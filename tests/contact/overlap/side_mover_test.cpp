// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/side_mover.hpp"

#include "contact/overlap/body_parting.hpp"
#include "support/catch.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A corner of a cube that is 0.1 deep in the top of another one, and what moves them apart.
struct MovedCubes {
  test::OverlappingBodies bodies;
  std::vector<std::uint8_t> is_held;
  SideMover mover{bodies.model, bodies.parts.contact_mesh, is_held, bodies.points};

  explicit MovedCubes(std::vector<std::uint32_t> held = {},
                      const std::string& lines = test::general_contact())
      : bodies(test::OverlappingBodies::cubes(0.1), lines), is_held(16, 0) {
    for (const std::uint32_t node : held) is_held[node] = held_fully;
  }
  static Overlap overlap(OverlapMover which) {
    Overlap found;
    found.first.nodes.fill({8});
    found.first.weights = Eigen::Vector4d::UnitX();
    found.second = {{4, 5, 7, 6}, {0.4, 0.4, 0.1, 0.1}};
    found.depth = 0.1;
    found.normal = Vector3d::UnitZ();
    found.mover = which;
    return found;
  }
  double way_of_first(OverlapMover which) const { return bodies.points.way_of(overlap(which).first).z(); }
  double way_of_second(OverlapMover which) const { return bodies.points.way_of(overlap(which).second).z(); }
};

}  // namespace

TEST_CASE("the side that goes out of an overlap goes by all of the way", "[contact][overlap]") {
  const OverlapMover which = GENERATE(OverlapMover::first, OverlapMover::ball);
  MovedCubes cubes;
  CHECK(cubes.mover.resolve({0}, MovedCubes::overlap(which), 0.1));
  CHECK(cubes.way_of_first(which) == Approx(0.1));
  CHECK(cubes.way_of_second(which) == 0.0);
}

TEST_CASE("both sides go half the way where both can", "[contact][overlap]") {
  MovedCubes cubes;
  CHECK(cubes.mover.resolve({0}, MovedCubes::overlap(OverlapMover::both), 0.1));
  CHECK(cubes.way_of_first(OverlapMover::both) == Approx(0.05));
  CHECK(cubes.way_of_second(OverlapMover::both) == Approx(-0.05));
  // Nodes that have more of the side go farther, by w / sum w^2.
  const Eigen::Matrix3Xd& before = cubes.bodies.mesh.coordinates();
  const Eigen::Matrix3Xd moved = cubes.bodies.points.coordinates() - before;
  CHECK(moved(2, 4) == Approx(-0.05 * 0.4 / 0.34));
  CHECK(moved(2, 6) == Approx(-0.05 * 0.1 / 0.34));
  CHECK(moved.topRows<2>().isZero(0.0));
}

TEST_CASE("where one side is held the other goes all the way, unless it goes out alone",
          "[contact][overlap]") {
  const OverlapMover which = GENERATE(OverlapMover::ball, OverlapMover::both);
  MovedCubes cubes({8});
  CHECK(cubes.mover.resolve({0}, MovedCubes::overlap(which), 0.1));
  CHECK(cubes.way_of_first(which) == 0.0);
  CHECK(cubes.way_of_second(which) == Approx(-0.1));
  MovedCubes alone({8});
  CHECK_FALSE(alone.mover.resolve({0}, MovedCubes::overlap(OverlapMover::first), 0.1));
  CHECK(alone.bodies.points.coordinates() == alone.bodies.mesh.coordinates());
  MovedCubes face_held({4, 5, 6, 7});
  CHECK(face_held.mover.resolve({0}, MovedCubes::overlap(OverlapMover::both), 0.1));
  CHECK(face_held.way_of_first(OverlapMover::both) == Approx(0.1));
  MovedCubes all_held({4, 5, 6, 7, 8});
  CHECK_FALSE(all_held.mover.resolve({0}, MovedCubes::overlap(OverlapMover::both), 0.1));
}

TEST_CASE("a side goes by its free nodes, unless they have too little of it", "[contact][overlap]") {
  MovedCubes cubes({4});  // 0.4 of the face
  CHECK(cubes.mover.resolve({0}, MovedCubes::overlap(OverlapMover::both), 0.1));
  CHECK(cubes.way_of_second(OverlapMover::both) == Approx(-0.05));
  CHECK(cubes.bodies.points.coordinates().col(4) == cubes.bodies.mesh.coordinates().col(4));
  MovedCubes less({4, 5});  // what is free would have to go seven times the way
  CHECK(less.mover.resolve({0}, MovedCubes::overlap(OverlapMover::both), 0.1));
  CHECK(less.way_of_first(OverlapMover::both) == Approx(0.1));
  CHECK(less.way_of_second(OverlapMover::both) == 0.0);
}

TEST_CASE("what is held in part moves: only its body does not go as a whole", "[contact][overlap]") {
  MovedCubes cubes;
  cubes.is_held[8] = held_in_part;
  CHECK(cubes.mover.resolve({0}, MovedCubes::overlap(OverlapMover::first), 0.1));
  CHECK(cubes.way_of_first(OverlapMover::first) == Approx(0.1));
}

TEST_CASE("what sides have gone already is not gone twice", "[contact][overlap]") {
  MovedCubes cubes;
  cubes.bodies.points.shift(NodeIndex{8}, {3, 0, 0.06});
  CHECK(cubes.mover.resolve_rest({0}, MovedCubes::overlap(OverlapMover::first), 1.0));
  CHECK(cubes.way_of_first(OverlapMover::first) == Approx(0.1));
  CHECK_FALSE(cubes.mover.resolve_rest({0}, MovedCubes::overlap(OverlapMover::first), 1.0));
  CHECK_FALSE(cubes.mover.resolve_rest({0}, MovedCubes::overlap(OverlapMover::first), 0.5));
  // Of both the way is that of one against the other.
  MovedCubes both;
  for (std::uint32_t node = 4; node < 8; ++node) both.bodies.points.shift(NodeIndex{node}, {0, 0, -0.04});
  CHECK(both.mover.resolve_rest({0}, MovedCubes::overlap(OverlapMover::both), 1.0));
  CHECK(both.way_of_first(OverlapMover::both) == Approx(0.03));
  CHECK(both.way_of_second(OverlapMover::both) == Approx(-0.07));
  // A node that goes alone does not count the way of the face.
  MovedCubes alone;
  for (std::uint32_t node = 4; node < 8; ++node) alone.bodies.points.shift(NodeIndex{node}, {0, 0, -0.04});
  CHECK(alone.mover.resolve_rest({0}, MovedCubes::overlap(OverlapMover::first), 0.5));
  CHECK(alone.way_of_first(OverlapMover::first) == Approx(0.05));
}

TEST_CASE("a node goes half the way where the nodes of the other side go theirs", "[contact][overlap]") {
  const Overlap first = MovedCubes::overlap(OverlapMover::first);
  CHECK(MovedCubes().mover.share_of_first({0}, first) == 0.5);
  CHECK(MovedCubes({4, 5, 6}).mover.share_of_first({0}, first) == 0.5);
  CHECK(MovedCubes({4, 5, 6, 7}).mover.share_of_first({0}, first) == 1.0);
  CHECK(MovedCubes().mover.share_of_first({0}, MovedCubes::overlap(OverlapMover::ball)) == 1.0);
  Overlap of_plane = first;
  of_plane.second.weights.setZero();
  CHECK(MovedCubes().mover.share_of_first({0}, of_plane) == 1.0);
}

TEST_CASE("the culprit of an element is the pair that has moved its nodes farthest", "[contact][overlap]") {
  MovedCubes cubes({}, test::general_contact("self contact = on\n"));
  REQUIRE(cubes.bodies.model.pairs.size() > 1);
  cubes.mover.move({1}, NodeIndex{9}, {0, 0, 0.3});
  cubes.mover.move({1}, NodeIndex{9}, {0, 0, -0.1});
  cubes.mover.move({0}, NodeIndex{9}, {0.25, 0, 0});
  cubes.mover.move({1}, NodeIndex{12}, {0.4, 0, 0});
  CHECK(cubes.mover.moved({1}).at(9).isApprox(Vector3d(0, 0, 0.2)));
  CHECK(cubes.mover.moved({1}).size() == 2);
  CHECK(cubes.mover.culprit_of(std::vector<NodeIndex>{{8}, {9}}) == PairIndex{0});
  CHECK(cubes.mover.culprit_of(std::vector<NodeIndex>{{8}, {9}, {12}}) == PairIndex{1});
}
