// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/cohesive_traction.hpp"

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A pull that falls from 10 per area at touch to nothing at a gap of 0.2.
InterfaceLaw adhesion() {
  InterfaceLaw law;
  law.pull = LawCurve({{0.0, 10.0}, {0.2, 0.0}});
  return law;
}

NodePenaltyInput node_push() {
  NodePenaltyInput push;
  push.penalty.stiffness = 100.0;
  push.area = 2.0;
  push.velocity.setZero();
  push.last_velocity.setZero();
  push.dt = 0.1;
  return push;
}

ContactPoint node_at(double gap) {
  ContactPoint point;
  point.normal = Vector3d::UnitZ();
  point.gap = gap;
  return point;
}

ContactPoint pulled(double gap) {
  ContactPoint point = node_at(gap);
  push_node(node_push(), point);
  add_node_traction(adhesion(), node_push(), point);
  return point;
}

}  // namespace

TEST_CASE("a node across a gap is pulled by its area, and feels nothing beyond the law",
          "[contact][cohesive_traction]") {
  const ContactPoint point = pulled(0.05);
  CHECK(point.force == Approx(-2.0 * 7.5));
  CHECK(point.area == 2.0);
  CHECK(point.is_held_apart);
  CHECK(point.stiffness == Approx(200.0 + 2.0 * 50.0));
  const ContactPoint far = pulled(0.2);
  CHECK(far.force == 0.0);
  CHECK_FALSE(far.is_held_apart);
  CHECK(far.stored() == 0.0);
  // What touches is pushed by the penalty alone.
  const ContactPoint touching = pulled(-0.01);
  CHECK(touching.force == Approx(2.0));
  CHECK(touching.is_held_apart);
}

TEST_CASE("the force of a pull is the derivative of what it stores", "[contact][cohesive_traction]") {
  constexpr double probe = 1e-6;
  for (const double gap : {-0.03, 0.03, 0.11, 0.19}) {
    const double by_energy = -(pulled(gap + probe).stored() - pulled(gap - probe).stored()) / (2.0 * probe);
    CHECK(pulled(gap).force == Approx(by_energy).epsilon(1e-6));
  }
  // No jump at touch, and nothing at the end: all of the law is 10 x 0.2 / 2.
  CHECK(pulled(-1e-12).stored() == Approx(-2.0));
  CHECK(pulled(1e-12).stored() == Approx(-2.0));
  CHECK(pulled(0.2 - 1e-9).stored() == Approx(0.0).margin(1e-6));
}

TEST_CASE("a junction resists slip below its cutoff only, up to its limit at that speed",
          "[contact][cohesive_traction]") {
  InterfaceLaw junction;
  junction.rate_limit = RateLimit{Function(3.0), 2.0, 0.1};
  const auto slipped = [&](double gap, double speed) {
    NodePenaltyInput push = node_push();
    push.last_velocity << speed, 0, 5;
    ContactPoint point = node_at(gap);
    push_node(push, point);
    add_node_traction(junction, push, point);
    return point;
  };
  // 0.001 of slip by a spring of 200; the limit is 3 x 2 per area.
  CHECK(slipped(0.05, 0.01).tangential.isApprox(Vector3d(-0.2, 0, 0)));
  CHECK(slipped(0.05, 10.0).tangential.isApprox(Vector3d(-12, 0, 0)));
  CHECK(slipped(0.05, 10.0).dissipated > 0.0);
  CHECK(slipped(0.05, 10.0).force == 0.0);
  CHECK(slipped(0.11, 10.0).tangential.isZero(0.0));
  CHECK_FALSE(slipped(0.11, 10.0).is_held_apart);
}

TEST_CASE("two faces across a gap are pulled by their overlap, evenly where they are parallel",
          "[contact][cohesive_traction]") {
  FacePenaltyInput push{test::make_square(0.0, 0.05, false), test::make_square(0.0, 0.0, true), {}, 0.1};
  push.penalty.depth = 0.5;
  ContactPoint point;
  REQUIRE(add_face_traction(adhesion(), push, point));
  const double area = area_vector(push.second.x).norm();
  CHECK(point.normal.isApprox(Vector3d::UnitZ()));
  CHECK(point.force == Approx(-7.5 * area));
  CHECK(point.gap == Approx(0.05));
  CHECK(point.area == Approx(area));
  CHECK(point.stiffness == Approx(50.0 * area));
  CHECK(point.first.weights.isApprox(Eigen::Vector4d::Constant(0.25)));
  CHECK(point.second.weights.isApprox(Eigen::Vector4d::Constant(0.25)));
  // -(10 (0.2 - g)^2 / 0.4) of what is left of the law.
  CHECK(point.stored() == Approx(-10.0 * 0.15 * 0.15 / 0.4 * area));
  push.first = test::make_square(0.0, 0.25, false);
  CHECK_FALSE(add_face_traction(adhesion(), push, point));
  push.first = test::make_square(0.0, -0.6, false);  // another wall
  CHECK_FALSE(add_face_traction(adhesion(), push, point));
}

TEST_CASE("the pull of two faces that lean against each other is their potential's derivative",
          "[contact][cohesive_traction]") {
  const auto stored_at = [](double rise, double* force = nullptr) {
    FacePenaltyInput push{test::make_square(0.0, 0.0, false), test::make_square(0.0, 0.0, true), {}, 0.1};
    push.penalty.depth = 0.5;
    for (int k = 0; k < 4; ++k) push.first.x(2, k) += rise + 0.1 * push.first.x(0, k);
    ContactPoint point;
    REQUIRE(add_face_traction(adhesion(), push, point));
    if (force != nullptr) *force = point.force * point.normal.z();
    return point.stored();
  };
  constexpr double probe = 1e-6;
  // But for the overlap, which shifts a little as seen along the normal between both.
  double force = 0.0;
  stored_at(0.06, &force);
  CHECK(force == Approx(-(stored_at(0.06 + probe) - stored_at(0.06 - probe)) / (2.0 * probe)).epsilon(5e-3));
}
