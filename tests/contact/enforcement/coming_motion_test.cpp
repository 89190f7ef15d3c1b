// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/coming_motion.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("contact nodes are foreseen to move by the accelerations of now", "[contact][enforcement]") {
  ContactParts parts(stacked_cubes(0.0), general_contact());
  parts.v.setConstant(1.0);
  parts.move();
  State state = make_state(parts.x, {}, 0.0);
  state.velocity = parts.v;
  state.acceleration = Eigen::Matrix3Xd::Constant(3, parts.x.cols(), 4.0);
  state.dt = 0.25;
  state.next_dt = 0.75;
  ComingMotion coming;
  coming.foresee(state, parts.contact_mesh, parts.kinematics);
  const ContactNodeIndex node = parts.contact_mesh.find_node({8});
  CHECK(parts.kinematics.v(node) == Eigen::Vector3d::Constant(1.0 + 0.5 * 4.0));
  CHECK(parts.kinematics.last_v(node) == Eigen::Vector3d::Ones());
}
