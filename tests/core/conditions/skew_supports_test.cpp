// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/skew_supports.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

PrescribedMotion hold(const Direction& direction, std::vector<NodeIndex> nodes) {
  PrescribedMotion motion;
  motion.direction = direction;
  motion.nodes = std::move(nodes);
  return motion;
}

/// Sum of the squares of all unit vectors that are held at a node: the projection on what does not move where
/// they are parallel or at right angles.
Eigen::Matrix3d held_at(NodeIndex node, const std::vector<PrescribedMotion>& motions) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const PrescribedMotion& motion : motions) {
    if (std::find(motion.nodes.begin(), motion.nodes.end(), node) == motion.nodes.end()) continue;
    for (const Eigen::Vector3d& unit : unit_vectors(motion.direction)) sum += unit * unit.transpose();
  }
  return sum;
}

const Eigen::Vector3d slanted_hold(0.6, 0.8, 0.0);

}  // namespace

TEST_CASE("holds at right angles, parallel ones and other motions stay as they are", "[core][conditions]") {
  PrescribedMotion driven = hold(slanted_hold, {{1}});
  driven.type = MotionType::velocity;
  const auto motions = separate_skew_supports({hold(Components{{true, false, false}}, {{1}, {2}}),
                                               hold(Components{{true, false, true}}, {{2}}), driven});
  REQUIRE(motions.size() == 3);
  CHECK(motions[0].nodes == std::vector<NodeIndex>{{1}, {2}});
  CHECK(motions[1].nodes == std::vector<NodeIndex>{{2}});
  CHECK(std::get<Components>(motions[1].direction).is_set == std::array{true, false, true});
  CHECK(std::get<Eigen::Vector3d>(motions[2].direction) == slanted_hold);
  CHECK(separate_skew_supports({}).empty());
}

TEST_CASE("at shared nodes the later hold keeps what is at right angles to the earlier",
          "[core][conditions]") {
  PrescribedMotion later = hold(slanted_hold, {{2}, {3}, {4}});
  later.times = ActiveTimes({{1.0, 2.0}});
  const auto motions =
      separate_skew_supports({hold(Components{{true, false, false}}, {{1}, {2}, {4}}), later});
  REQUIRE(motions.size() == 3);
  CHECK(motions[1].nodes == std::vector<NodeIndex>{{2}, {4}});
  CHECK(std::get<Eigen::Vector3d>(motions[1].direction).isApprox(Eigen::Vector3d::UnitY(), 1e-15));
  CHECK(motions[1].times == later.times);
  CHECK(motions[2].nodes == std::vector<NodeIndex>{{3}});
  CHECK(std::get<Eigen::Vector3d>(motions[2].direction) == slanted_hold);
}

TEST_CASE("a slanted hold in a plane that is held already adds nothing", "[core][conditions]") {
  const auto motions =
      separate_skew_supports({hold(Components{{true, true, false}}, {{1}}), hold(slanted_hold, {{1}})});
  CHECK(motions.size() == 1);
  const auto turned =
      separate_skew_supports({hold(slanted_hold, {{1}}), hold(Components{{true, true, false}}, {{1}})});
  const Eigen::Matrix3d in_plane = Eigen::Vector3d(1, 1, 0).asDiagonal();
  CHECK(held_at({1}, turned).isApprox(in_plane, 1e-14));
}

TEST_CASE("three planes that meet at a slant hold their corner, in any order", "[core][conditions]") {
  std::vector<Eigen::Vector3d> normals{{0, 0, 1}, {0.6, 0.0, 0.8}, Eigen::Vector3d(1, 2, 2) / 3.0};
  std::sort(normals.begin(), normals.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  do {
    std::vector<PrescribedMotion> holds;
    // Node 0 is of all planes, node i + 1 of all but the plane i.
    for (std::uint32_t i = 0; i < 3; ++i) {
      std::vector<NodeIndex> nodes{{0}};
      for (std::uint32_t k = 1; k < 4; ++k) {
        if (k != i + 1) nodes.push_back({k});
      }
      holds.push_back(hold(normals[i], nodes));
    }
    const auto motions = separate_skew_supports(holds);
    CHECK(held_at({0}, motions).isApprox(Eigen::Matrix3d::Identity(), 1e-13));
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d edge = normals[(i + 1) % 3].cross(normals[(i + 2) % 3]).normalized();
      const Eigen::Matrix3d expected = Eigen::Matrix3d::Identity() - edge * edge.transpose();
      CHECK(held_at({i + 1}, motions).isApprox(expected, 1e-13));
    }
  } while (std::next_permutation(normals.begin(), normals.end(),
                                 [](const auto& a, const auto& b) { return a.x() < b.x(); }));
}
