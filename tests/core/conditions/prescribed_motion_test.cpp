// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/prescribed_motion.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Node 1 of a cube, from (1 0 0) of the mesh, between steps of 0.2 and 0.4 at the time 3.
struct OneNode {
  Mesh mesh = MeshBuilder().add_hexes({}).build();
  Eigen::Matrix3Xd x = mesh.coordinates(), v = Eigen::Matrix3Xd::Zero(3, 8);
  BetweenSteps now{3.0, 0.2, 0.4, x, v};

  OneNode(const Eigen::Vector3d& displacement, const Eigen::Vector3d& velocity) {
    x.col(1) += displacement;
    v.col(1) = velocity;
  }

  Eigen::Vector3d accelerated(const PrescribedMotion& motion, const Eigen::Vector3d& free) const {
    Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Constant(3, 8, 77.0);
    a.col(1) = free;
    motion.set_acceleration(now, mesh, a);
    const Eigen::Vector3d found = a.col(1);
    a.col(1).setConstant(77.0);
    CHECK((a.array() == 77.0).all());  // other nodes are left alone
    return found;
  }
  Eigen::Vector3d started(const PrescribedMotion& motion, const Eigen::Vector3d& free) const {
    Eigen::Matrix3Xd start = Eigen::Matrix3Xd::Zero(3, 8);
    start.col(1) = free;
    motion.set_velocity(now, mesh, start);
    return start.col(1);
  }
};

PrescribedMotion moves(MotionType type, const Direction& direction, double value) {
  PrescribedMotion motion;
  motion.type = type;
  motion.direction = direction;
  motion.value = ConditionFunction(value);
  motion.nodes = {{1}};
  return motion;
}

const Axis along_z{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()};

}  // namespace

TEST_CASE("accelerations bring about what is prescribed along components", "[core][conditions]") {
  const OneNode node({0.5, 0.5, 0.5}, {1, 2, 3});
  const Components yz{{false, true, true}};
  // The velocity of the coming half step minus that of the last, over (0.2 + 0.4) / 2 = 0.3.
  CHECK(node.accelerated(moves(MotionType::fixed, yz, 0), {9, 9, 9})
            .isApprox(Eigen::Vector3d(9, -2 / 0.3, -10)));
  CHECK(node.accelerated(moves(MotionType::velocity, yz, 5), {9, 9, 9})
            .isApprox(Eigen::Vector3d(9, 10, 2 / 0.3)));
  CHECK(node.accelerated(moves(MotionType::acceleration, yz, 5), {9, 9, 9}) == Eigen::Vector3d(9, 5, 5));
  // From 0.5 to 0.9 in 0.4 is a velocity of 1.
  CHECK(node.accelerated(moves(MotionType::displacement, yz, 0.9), {9, 9, 9})
            .isApprox(Eigen::Vector3d(9, -1 / 0.3, -2 / 0.3)));
}

TEST_CASE("accelerations along a unit vector leave what is across it", "[core][conditions]") {
  const OneNode node({1, 0, 2}, {5, 0, 0});
  const Eigen::Vector3d unit(0.6, 0.8, 0.0), free(1, 1, 1);
  for (const auto& [type, value, wanted] :
       {std::tuple{MotionType::fixed, 0.0, -3.0 / 0.3}, std::tuple{MotionType::velocity, 6.0, 3.0 / 0.3},
        std::tuple{MotionType::acceleration, 7.0, 7.0},
        std::tuple{MotionType::displacement, 0.6 + 0.4 * 6.0, 3.0 / 0.3}}) {
    const Eigen::Vector3d found = node.accelerated(moves(type, unit, value), free);
    CHECK(found.dot(unit) == Approx(wanted));
    CHECK((found - found.dot(unit) * unit).isApprox(free - free.dot(unit) * unit, 1e-14));
  }
}

TEST_CASE("about an axis the coming step ends on the arc, at the angle that is prescribed",
          "[core][conditions]") {
  const double pi = std::acos(-1.0);
  // From (1 0 0) the node has been taken to (0 2 0.5); it has moved by (-0.2 0 1) x 0.2 in the step before.
  const OneNode node({-1, 2, 0.5}, {-0.2, 0, 1});
  const auto end_of_step = [&](const PrescribedMotion& motion) -> Eigen::Vector3d {
    const Eigen::Vector3d velocity = node.v.col(1) + 0.3 * node.accelerated(motion, {4, 4, 4});
    return node.x.col(1) + 0.4 * velocity;
  };
  const double z = 0.5 + 0.4 * (1 + 0.3 * 4);  // free along the axis
  // An angle counts from the mesh, at the radius that the node had there.
  CHECK(end_of_step(moves(MotionType::displacement, along_z, pi / 6))
            .isApprox(Eigen::Vector3d(std::cos(pi / 6), 0.5, z), 1e-14));
  // A rate of 2 is 0.8 radians beyond the right angle of now; half a turn and more is no trouble.
  CHECK(end_of_step(moves(MotionType::velocity, along_z, 2.0))
            .isApprox(Eigen::Vector3d(-2 * std::sin(0.8), 2 * std::cos(0.8), z), 1e-14));
  CHECK(end_of_step(moves(MotionType::velocity, along_z, 10.0))
            .isApprox(Eigen::Vector3d(-2 * std::sin(4.0), 2 * std::cos(4.0), z), 1e-14));
  // Held, it stays, however it moved.
  CHECK(end_of_step(moves(MotionType::velocity, along_z, 0.0)).isApprox(Eigen::Vector3d(0, 2, z), 1e-14));
  // In the step before it has turned by the angle between (0.04 2) and (0 2); 3 more each unit of time.
  const double rate = std::atan2(0.04, 2.0) / 0.2 + 0.3 * 3.0;
  CHECK(end_of_step(moves(MotionType::acceleration, along_z, 3.0))
            .isApprox(Eigen::Vector3d(-2 * std::sin(0.4 * rate), 2 * std::cos(0.4 * rate), z), 1e-13));
}

TEST_CASE("a node on the axis stays there", "[core][conditions]") {
  const OneNode node({-1, 0, 0}, {0, 0, 3});
  for (const MotionType type : {MotionType::velocity, MotionType::acceleration})
    CHECK(node.accelerated(moves(type, along_z, 2.0), {1, 1, 1}).isApprox(Eigen::Vector3d(0, 0, 1)));
}

TEST_CASE("at the start velocities are those of now, of displacements the mean over the step",
          "[core][conditions]") {
  const OneNode node({0.5, 0.5, 0.5}, {8, 8, 8});  // this velocity is not looked at
  const Components y{{false, true, false}};
  CHECK(node.started(moves(MotionType::fixed, y, 0), {1, 2, 3}) == Eigen::Vector3d(1, 0, 3));
  CHECK(node.started(moves(MotionType::velocity, y, 5), {1, 2, 3}) == Eigen::Vector3d(1, 5, 3));
  CHECK(node.started(moves(MotionType::acceleration, y, 5), {1, 2, 3}) == Eigen::Vector3d(1, 2, 3));
  CHECK(node.started(moves(MotionType::displacement, y, 0.9), {1, 2, 3}).isApprox(Eigen::Vector3d(1, 1, 3)));
  const Eigen::Vector3d unit(0.6, 0.8, 0.0);
  CHECK(
      node.started(moves(MotionType::velocity, unit, 5), {1, 2, 3}).isApprox(Eigen::Vector3d(2.68, 4.24, 3)));
  // At (1.5 0.5 0.5) about z; the free part along the axis stays.
  CHECK(node.started(moves(MotionType::velocity, along_z, 2), {1, 2, 3}).isApprox(Eigen::Vector3d(-1, 3, 3)));
  const Eigen::Vector3d arc =
      (Eigen::Vector3d(std::cos(0.2), std::sin(0.2), 0) - Eigen::Vector3d(1.5, 0.5, 0)) / 0.4;
  CHECK(node.started(moves(MotionType::displacement, along_z, 0.2), {1, 2, 3})
            .isApprox(arc + Eigen::Vector3d(0, 0, 3), 1e-14));
}

TEST_CASE("rotations count how far a node has turned, not where it is", "[core][conditions]") {
  OneNode node({7, 7, 7}, {1, 1, 1});
  Eigen::Matrix3Xd angle = Eigen::Matrix3Xd::Zero(3, 8);
  angle.col(1) = Eigen::Vector3d(0.1, 0.2, 0.3);
  const BetweenSteps turning{3.0, 0.2, 0.4, node.x, node.v, &angle};
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 8);
  moves(MotionType::displacement, Components{{true, false, true}}, 0.5)
      .set_acceleration(turning, node.mesh, a);
  CHECK(a.col(1).isApprox(Eigen::Vector3d((0.4 / 0.4 - 1) / 0.3, 0, (0.2 / 0.4 - 1) / 0.3), 1e-14));
}

TEST_CASE("a value at nodes that is not finite ends the run at the first of them", "[core][conditions]") {
  const OneNode node({0, 0, 0}, {0, 0, 0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PrescribedMotion motion = moves(MotionType::velocity, Components{{true, false, false}}, 0.0);
  motion.nodes = {{1}, {4}, {6}};
  motion.value =
      ConditionFunction({{0.0}, motion.nodes, {1.0, nan, nan}}, 1.0, {"the prescribed velocity", {}});
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 8);
  CHECK_THROWS_WITH(motion.set_acceleration(node.now, node.mesh, a),
                    "time 3.2: the function of the prescribed velocity has no finite value at node 5");
}
