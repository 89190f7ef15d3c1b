// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/relative_velocity.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("the first side of a point moves against the second, before and as foreseen",
          "[contact][enforcement]") {
  ContactParts parts(stacked_cubes(0.0), general_contact());
  const ContactMesh& contact_mesh = parts.contact_mesh;
  ContactPoint point;
  point.normal = Eigen::Vector3d::UnitZ();
  point.first.nodes.fill(contact_mesh.find_node({8}));  // of the upper cube
  point.first.weights = Eigen::Vector4d::UnitX();
  point.second.nodes.fill(contact_mesh.find_node({4}));
  point.second.weights = {0.5, 0.5, 0.0, 0.0};
  parts.v.setZero();
  parts.v.col(8) = Eigen::Vector3d(1, 2, 3);
  parts.v.col(4) = Eigen::Vector3d(0, 0, 1);
  parts.move();
  CHECK(relative_velocity(parts.kinematics, point, true) == Eigen::Vector3d(1, 2, 2));
  State state = make_state(parts.x, {}, 0.0, parts.v);
  state.dt = state.next_dt = 1.0;
  state.acceleration.col(8) = -parts.v.col(8);
  parts.kinematics.foresee(state);
  CHECK(relative_velocity(parts.kinematics, point, false) == Eigen::Vector3d(0, 0, -1));
  CHECK(relative_velocity(parts.kinematics, point, true) == Eigen::Vector3d(1, 2, 2));
}
