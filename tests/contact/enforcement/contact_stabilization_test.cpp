// SPDX-License-Identifier: BSD-3-Clause
// What resists the motion of bodies that do not touch yet, in load steps.
#include "contact/enforcement/contact_stabilization.hpp"
#include "contact/enforcement/contact_force.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;

namespace {

constexpr double gap = 0.25;

/// A cube that hangs above a plate of three by three cubes, as a load step of 0.5 begins.
class HangingCube {
 public:
  explicit HangingCube(const std::string& lines) : bodies(mesh(), static_region(lines)) {
    bodies.ask();
    start_ = bodies.x;
    bodies.time += 0.5;
    bodies.dt = 0.5;
    bodies.v.setZero();
    bodies.contact.begin_trials(bodies.motion());
  }

  /// The forces after the cube has moved.
  Matrix3Xd try_motion(const Eigen::Vector3d& way) {
    move(way);
    Matrix3Xd forces = Matrix3Xd::Zero(3, bodies.x.cols());
    bodies.contact.try_forces(bodies.motion(), forces, nullptr);
    return forces;
  }
  Eigen::Vector3d force_on_cube(const Eigen::Vector3d& way) {
    bodies.forces = try_motion(way);
    return bodies.force_on(1);
  }
  ForceReport accept(const Eigen::Vector3d& way) {
    move(way);
    return bodies.contact.accept_trial(bodies.motion(), bodies.forces);
  }

  ContactBodies bodies;

 private:
  void move(const Eigen::Vector3d& way) {
    bodies.x = start_;
    bodies.shift(1, way);
    bodies.v = (bodies.x - start_) / 0.5;
  }
  static MeshBuilder mesh() {
    return MeshBuilder()
        .add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}})
        .add_hexes({.id = 2, .origin = {0.9, 0.8, 1.0 + gap}, .share_nodes = false});
  }
  static Region static_region(const std::string& lines) {
    Region region;
    region.contact = parse_contact(general_contact("constraint formulation = node_face\n" + lines));
    region.contact->enforcement.is_static = true;
    return region;
  }

  Matrix3Xd start_;
};

}  // namespace

TEST_CASE("sides that do not touch yet resist their motion by a thousandth of what is behind them",
          "[contact][contact_force][statics]") {
  HangingCube hanging("contact stabilization = 2\nstabilization tangential fraction = 0.25\n");
  hanging.bodies.contact.stabilize({0.5, 10.0});
  // Bulk modulus 1 over edges of 1 in series: 0.5. Both sides' nodes count half of their areas of 1; no node
  // of the plate but one stands below the cube. The range is the edge of 1.
  const double per_area = 2.0 * 1e-3 * 0.5 * 10.0 * 0.5 * (1.0 - gap);
  const double stiffness = 0.5 * per_area * (1.0 + 1.0);
  const Eigen::Vector3d force = hanging.force_on_cube({0.01, 0.02, -0.1});
  CHECK(force.z() == Approx(0.1 * stiffness));
  CHECK(force.x() == Approx(-0.25 * 0.01 * stiffness));
  CHECK(force.y() == Approx(-0.25 * 0.02 * stiffness));
  CHECK(hanging.bodies.net_force().norm() == Approx(0.0).margin(1e-15));
  CHECK(hanging.bodies.contact.stabilization().share == Approx(2.0 * 1e-3 * 10.0 * 0.5));
  // As the block ends nothing is left.
  hanging.bodies.contact.stabilize({0.0, 10.0});
  CHECK(hanging.force_on_cube({0.01, 0.02, -0.1}).isZero(0.0));
  CHECK(hanging.bodies.contact.stabilization().share == 0.0);
}

TEST_CASE("what remains of stabilization does so as a time stepping block ends",
          "[contact][contact_force][statics]") {
  HangingCube whole("contact stabilization = on\n");
  HangingCube rest("contact stabilization = on\nstabilization remaining fraction = 0.125\n");
  whole.bodies.contact.stabilize({1.0, 4.0});
  rest.bodies.contact.stabilize({0.0, 4.0});
  const Eigen::Vector3d way(0.01, 0.0, -0.1);
  CHECK(rest.force_on_cube(way).isApprox(0.125 * whole.force_on_cube(way)));
}

TEST_CASE("stabilization ends at its range", "[contact][contact_force][statics]") {
  HangingCube near("contact stabilization = on\nstabilization range = 0.26\n");
  HangingCube far("contact stabilization = on\nstabilization range = 0.24\n");
  for (HangingCube* hanging : {&near, &far}) hanging->bodies.contact.stabilize({1.0, 4.0});
  CHECK(near.force_on_cube({0.0, 0.0, -0.1}).z() > 0.0);
  CHECK(far.force_on_cube({0.0, 0.0, -0.1}).isZero(0.0));
  CHECK(far.bodies.contact.stabilization().nodes.empty());
}

TEST_CASE("springs of stabilization are the derivatives of its forces", "[contact][contact_force][statics]") {
  HangingCube hanging("contact stabilization = on\n");
  hanging.bodies.contact.stabilize({1.0, 4.0});
  const Eigen::Vector3d way(0.02, -0.01, -0.05);
  const Matrix3Xd forces = hanging.try_motion(way);
  Matrix3Xd by_springs = Matrix3Xd::Zero(3, forces.cols());
  Matrix3Xd motion = Matrix3Xd::Zero(3, forces.cols());
  for (Eigen::Index i = 0; i < motion.cols(); ++i) motion.col(i) = 0.5 * hanging.bodies.v.col(i);
  hanging.bodies.contact.visit_springs([&](const ContactSpring& spring) {
    spring.visit_blocks([&](const SpringEnd& a, const SpringEnd& b, const Eigen::Matrix3d& block) {
      by_springs.col(a.node) -= block * motion.col(b.node);
    });
  });
  CHECK(forces.norm() > 0.0);
  CHECK(by_springs.isApprox(forces));
}

TEST_CASE("stabilization takes the mean of its forces at both ends of a step",
          "[contact][contact_force][statics]") {
  HangingCube hanging("contact stabilization = on\n");
  hanging.bodies.contact.stabilize({1.0, 4.0});
  const Eigen::Vector3d way(0.0, 0.0, -0.1);
  const double force = hanging.force_on_cube(way).z();
  CHECK(hanging.accept(way).stabilization_work == Approx(0.5 * force * 0.1));
}
