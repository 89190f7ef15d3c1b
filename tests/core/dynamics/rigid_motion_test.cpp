// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rigid_motion.hpp"

#include "core/dynamics/energy_balance.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

/// A cross about (5 0 0): nodes of mass 1 at a distance of 1 along x and of 2 along y, both ways. The moments
/// of inertia are 8, 2 and 10. A fifth node is free.
struct Cross {
  Cross() {
    MeshBuilder builder;
    for (const Vector3d& x : std::vector<Vector3d>{{6, 0, 0}, {4, 0, 0}, {5, 2, 0}, {5, -2, 0}, {9, 9, 9}})
      builder.add_node(x);
    mesh = builder.build();
    model.mesh = &mesh;
    model.mass = Eigen::RowVectorXd::Ones(5);
    RigidBody body;
    body.name = "cross";
    body.nodes = {{0}, {1}, {2}, {3}};
    body.centre = {5, 0, 0};
    body.arms = mesh.coordinates().leftCols(4).colwise() - body.centre;
    body.mass = 4.0;
    body.inertia = Vector3d(8, 2, 10).asDiagonal();
    body.flexible = inverse_where_it_is(body.inertia);
    model.rigid.bodies.push_back(body);
    MeshParts centres;
    centres.coordinates = body.centre;
    model.rigid.nodes.references = std::make_shared<const Mesh>(std::move(centres));
    state = make_state(mesh.coordinates(), {}, 0.0);
    state.next_dt = 0.01;
  }

  void constrain(std::vector<PrescribedMotion> places, std::vector<PrescribedMotion> turns) {
    const Mesh& centres = *model.rigid.nodes.references;
    model.rigid.kinematic_constraints = KinematicConstraints(centres, std::move(places));
    model.rigid.rotation_constraints = KinematicConstraints(centres, std::move(turns));
  }
  void set_velocities(const Vector3d& velocity, const Vector3d& turning) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      const Vector3d arm = mesh.coordinates().col(i) - Vector3d(5, 0, 0);
      state.velocity.col(i) = velocity + turning.cross(arm);
    }
  }
  /// A step as the integrator makes it, with the forces that the state has.
  ///   following  size of the step after it
  void advance(double following = 0.01) {
    const double half = 0.5 * (state.dt + state.next_dt);
    state.velocity += half * state.acceleration;
    state.dt = state.next_dt;
    state.coordinates += state.dt * state.velocity;
    state.time += state.dt;
    state.next_dt = following;
    ++state.step;
    moved = state.coordinates;
    move_rigid_bodies(model, state);
    drive_rigid_bodies(model, state);
  }
  const RigidBodyState& body() const { return state.rigid[0]; }

  Mesh mesh;
  Model model;
  State state;
  Matrix3Xd moved;  ///< where the nodes' own step took them
};

PrescribedMotion of_body(MotionType type, const Direction& direction, double value = 0.0) {
  PrescribedMotion motion;
  motion.type = type;
  motion.direction = direction;
  motion.value = ConditionFunction(value);
  motion.nodes = {NodeIndex{0}};
  return motion;
}

}  // namespace

TEST_CASE("a body starts with the momentum of its nodes, and they with its velocities", "[core][rigid]") {
  Cross cross;
  cross.set_velocities({1, 2, 3}, {0.5, -1, 2});
  cross.state.velocity.col(0) += Vector3d(7, 0, 0);  // apart from each other: no motion of the body
  cross.state.velocity.col(1) -= Vector3d(7, 0, 0);
  cross.state.velocity.col(4) = Vector3d(1, 1, 1);
  start_rigid_bodies(cross.model, cross.state);
  CHECK(cross.body().position == Vector3d(5, 0, 0));
  CHECK(cross.body().before.velocity.isApprox(Vector3d(1, 2, 3), 1e-14));
  CHECK(cross.body().before.turning.isApprox(Vector3d(0.5, -1, 2), 1e-14));
  CHECK(cross.body().before.spin.isApprox(Vector3d(4, -2, 20), 1e-14));
  CHECK(cross.state.velocity.col(0).isApprox(Vector3d(1, 2, 3) +
                                             Vector3d(0.5, -1, 2).cross(Vector3d(1, 0, 0))));
  CHECK(cross.state.velocity.col(4) == Vector3d(1, 1, 1));
  start_rigid_bodies(cross.model, cross.state);  // where it is already
  CHECK(cross.body().before.turning.isApprox(Vector3d(0.5, -1, 2), 1e-14));
}

TEST_CASE("forces on the nodes accelerate and turn the body", "[core][rigid]") {
  Cross cross;
  start_rigid_bodies(cross.model, cross.state);
  cross.state.forces.internal.col(2) = Vector3d(0, 0, 3);  // at (0 2 0) from the centre
  cross.state.forces.external.col(0) = Vector3d(0, 5, 0);  // at (1 0 0)
  cross.state.forces.external.col(4) = Vector3d(99, 99, 99);
  cross.state.forces.contact = Matrix3Xd::Zero(3, 5);
  cross.state.forces.contact.col(1) = Vector3d(1, 0, 0);
  drive_rigid_bodies(cross.model, cross.state);
  CHECK(cross.body().force == Vector3d(1, 5, 3));
  CHECK(cross.body().moment == Vector3d(6, 0, 5));
  CHECK(cross.body().acceleration.isApprox(Vector3d(0.25, 1.25, 0.75)));
  // But for the inertia that has turned by 2e-5 in the middle of the step.
  CHECK(cross.body().angular_acceleration.isApprox(Vector3d(6.0 / 8, 0, 5.0 / 10), 1e-4));
  CHECK(cross.body().after.velocity.isApprox(0.005 * Vector3d(0.25, 1.25, 0.75)));
  CHECK(cross.body().reaction.isZero(1e-15));
  CHECK(cross.body().reaction_moment.isZero(1e-15));
  CHECK(cross.state.acceleration.col(4).isZero(0.0));
}

TEST_CASE("the nodes' own steps take them where the body goes, however far", "[core][rigid]") {
  Cross cross;
  cross.set_velocities({1, 2, 3}, {3, -2, 5});
  start_rigid_bodies(cross.model, cross.state);
  drive_rigid_bodies(cross.model, cross.state);
  const Vector3d spin = cross.body().before.spin;
  double largest = 0.0;
  for (int i = 0; i < 200; ++i) {
    cross.advance(i % 3 == 0 ? 0.02 : 0.01);
    largest = std::max(largest, (cross.moved - cross.state.coordinates).leftCols(4).norm());
  }
  CHECK(largest < 1e-13);
  const Matrix3Xd& x = cross.state.coordinates;
  CHECK((x.col(0) - x.col(1)).norm() == Approx(2.0).epsilon(1e-14));
  CHECK((x.col(2) - x.col(3)).norm() == Approx(4.0).epsilon(1e-14));
  CHECK(std::abs((x.col(0) - x.col(1)).dot(x.col(2) - x.col(3))) < 1e-13);
  CHECK(cross.body().position.isApprox(Vector3d(5, 0, 0) + cross.state.time * Vector3d(1, 2, 3), 1e-13));
  CHECK(cross.body().now.spin.isApprox(spin, 1e-12));  // free, it keeps its angular momentum
  CHECK(cross.state.coordinates.col(4) == Vector3d(9, 9, 9));
}

TEST_CASE("conditions hold and turn a body by reactions", "[core][rigid]") {
  Cross cross;
  cross.constrain({of_body(MotionType::fixed, Components{{true, true, false}})},
                  {of_body(MotionType::fixed, Components{{true, true, false}}),
                   of_body(MotionType::velocity, Components{{false, false, true}}, 2.0)});
  cross.set_velocities({1, 1, 1}, {1, 1, 1});
  start_rigid_bodies(cross.model, cross.state);
  cross.state.forces.external.col(2) = Vector3d(0, 0, 3);
  cross.state.forces.external.col(0) = Vector3d(0, 5, 0);
  drive_rigid_bodies(cross.model, cross.state);
  // Without a jump at the start.
  CHECK(cross.body().now.velocity.isApprox(Vector3d(0, 0, 1)));
  CHECK(cross.body().before.turning.isApprox(Vector3d(0, 0, 2)));
  CHECK(cross.state.velocity.col(0).isApprox(Vector3d(0, 2, 1)));
  CHECK(cross.body().acceleration.isApprox(Vector3d(0, 0, 0.75)));
  CHECK(cross.body().reaction.isApprox(Vector3d(0, -5, 0)));
  CHECK(cross.body().after.turning.isApprox(Vector3d(0, 0, 2), 1e-12));
  CHECK(cross.body().reaction_moment.isApprox(Vector3d(-6, 0, -5), 1e-6));
  for (int i = 0; i < 50; ++i) cross.advance();
  CHECK(cross.body().position.head<2>() == Eigen::Vector2d(5, 0));
  CHECK(cross.body().angle.isApprox(Vector3d(0, 0, 2.0 * cross.state.time), 1e-12));
  const Vector3d arm = cross.state.coordinates.col(0) - cross.body().position;
  CHECK(arm.isApprox(Vector3d(std::cos(1.0), std::sin(1.0), 0), 1e-12));
}

TEST_CASE("the balance of a body has its energy, momentum and the work of what drives it", "[core][rigid]") {
  Cross cross;
  cross.constrain({of_body(MotionType::velocity, Components{{true, false, false}}, 3.0)}, {});
  cross.set_velocities({3, 0, 1}, {0, 0, 2});
  start_rigid_bodies(cross.model, cross.state);
  cross.state.forces.external.col(0) =
      Vector3d(-8, 0, 0);  // against the way it is driven, through the centre
  drive_rigid_bodies(cross.model, cross.state);
  EnergyBalance balance;
  balance.momentum.setZero();
  add_rigid_balance(cross.model, cross.state, balance);
  CHECK(balance.kinetic == Approx(0.5 * 4 * (9 + 1) + 0.5 * 10 * 4));
  CHECK(balance.conserved == Approx(balance.kinetic));  // nothing accelerates
  CHECK(balance.momentum.isApprox(Vector3d(12, 0, 4)));
  CHECK(balance.ended.external == 0.0);  // no step before
  CHECK(balance.begun.external == Approx(0.005 * 8 * 3));
  add_rigid_balance(cross.model, cross.state, balance);
  CHECK(balance.momentum.isApprox(Vector3d(24, 0, 8)));  // added to what is there
}
