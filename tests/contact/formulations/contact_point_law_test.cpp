// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/contact_point_law.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A node of area 2 before a penalty of 100 per area, that looks up.
struct PushedNode {
  NodePenaltyInput push;
  ContactPoint point;

  explicit PushedNode(double gap, const Vector3d& velocity = Vector3d::Zero()) {
    push.penalty.stiffness = 100.0;
    push.area = 2.0;
    push.velocity = push.last_velocity = velocity;
    push.dt = 0.1;
    point.normal = Vector3d::UnitZ();
    point.gap = gap;
  }
  const ContactPoint& pushed() {
    push_node(push, point);
    return point;
  }
};

}  // namespace

TEST_CASE("a node that penetrates is pushed by its area and depth", "[contact][contact_point_law]") {
  PushedNode node(-0.01, {3, 0, 0});
  const ContactPoint& point = node.pushed();
  CHECK(point.force == Approx(2.0));
  CHECK(point.area == 2.0);
  CHECK(point.deepest == 0.01);
  CHECK(point.stiffness == Approx(200.0));
  CHECK(point.slip.isApprox(Vector3d(0.3, 0, 0)));
  CHECK(point.damped == 0.0);
  CHECK(point.stored() == Approx(0.5 * 200.0 * 1e-4));
}

TEST_CASE("a node in front gives its stiffness for the stable step and nothing else",
          "[contact][contact_point_law]") {
  PushedNode node(0.01, {3, 0, -1});
  const ContactPoint& point = node.pushed();
  CHECK(point.force == 0.0);
  CHECK(point.area == 0.0);
  CHECK(point.stiffness == Approx(200.0));
  CHECK(point.slip.isZero(0.0));
  CHECK(PushedNode(0.0).pushed().force == 0.0);
}

TEST_CASE("damping resists closing, and ends with the spring where sides part",
          "[contact][contact_point_law]") {
  const auto damped = [](const Vector3d& velocity) {
    PushedNode node(-0.01, velocity);
    node.push.penalty.damping = 5.0;
    return node.pushed();
  };
  const ContactPoint closing = damped({0, 0, -0.3});
  CHECK(closing.force == Approx(2.0 + 5.0 * 2.0 * 0.3));
  CHECK(closing.damped == Approx(3.0 * 0.3 * 0.1));
  const ContactPoint parting = damped({0, 0, 0.1});
  CHECK(parting.force == Approx(2.0 - 1.0));
  CHECK(parting.damped == Approx(1.0 * 0.1 * 0.1));
  const ContactPoint fast = damped({0, 0, 10.0});
  CHECK(fast.force == Approx(0.0).margin(1e-15));
  CHECK(fast.damped == Approx(2.0 * 10.0 * 0.1));
}

TEST_CASE("what may not part is pulled by its spring, and damped either way",
          "[contact][contact_point_law]") {
  PushedNode node(0.01, {0, 0, 0.3});
  node.point.pulls = true;
  node.push.penalty.damping = 5.0;
  const ContactPoint& point = node.pushed();
  CHECK(point.force == Approx(-2.0 - 3.0));
  CHECK(point.damped == Approx(3.0 * 0.3 * 0.1));
  CHECK(point.area == 2.0);
  CHECK(point.deepest == 0.0);
}

TEST_CASE("a damped spring counts as stiffer for the stable step", "[contact][contact_point_law]") {
  CHECK(damped_stiffness(100.0, 0.0) == 100.0);
  // w (x + sqrt(1 + x^2)) with x = 3/4 is 2 w.
  CHECK(damped_stiffness(100.0, 0.75) == Approx(400.0));
  PushedNode node(-0.01);
  node.push.damping_fraction = 0.75;
  CHECK(node.pushed().stiffness == Approx(800.0));
}

TEST_CASE("a penalty that stiffens counts as stiff as at the depth to come, in load steps as now",
          "[contact][contact_point_law]") {
  const auto stiffness = [](bool is_static, double speed) {
    PushedNode node(-0.01, {0, 0, speed});
    node.push.penalty.law = DepthLaw(0.02, 0.04, 3.0);
    node.push.is_static = is_static;
    return node.pushed().stiffness;
  };
  CHECK(stiffness(false, 0.0) == Approx(200.0));
  CHECK(stiffness(false, -0.2) == Approx(200.0 * 2.0));  // 0.03 deep in a step
  CHECK(stiffness(false, 0.2) == Approx(200.0));
  CHECK(stiffness(true, -0.2) == Approx(200.0));
}

TEST_CASE("energy of a penalty that stiffens is its potential", "[contact][contact_point_law]") {
  PushedNode node(-0.03);
  node.push.penalty.law = DepthLaw(0.02, 0.04, 3.0);
  const ContactPoint& point = node.pushed();
  // f = d + 100 (d - 0.02)^2 / 2, its integral d^2 / 2 + 100 (d - 0.02)^3 / 6.
  CHECK(point.force == Approx(200.0 * (0.03 + 50.0 * 1e-4)));
  CHECK(point.stored() == Approx(200.0 * (0.5 * 9e-4 + 100.0 * 1e-6 / 6.0)));
}

TEST_CASE("where momentum is balanced a gap makes no force", "[contact][contact_point_law]") {
  PushedNode node(-0.01, {3, 0, -0.4});
  node.push.coming_dt = 0.25;
  const ContactPoint& point = node.pushed();
  CHECK(point.is_balanced);
  CHECK(point.force == 0.0);
  CHECK(point.area == 2.0);
  CHECK(point.closing == Approx(0.1));
}

TEST_CASE("what touched may be deeper than what did not", "[contact][contact_point_law]") {
  CHECK(depth_of_known(0.1, 0.0, 0.0) == Approx(0.15));
  CHECK(depth_of_known(0.1, 0.2, 0.1) == Approx(0.45));
  CHECK(depth_of_known(0.1, 0.2, -0.15) == Approx(0.15));
  CHECK(above_zero(0.5f) == 0.5);
  CHECK(above_zero(-0.5f) == 0.0);
}
