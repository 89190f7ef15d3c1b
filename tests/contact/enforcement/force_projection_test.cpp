// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/force_projection.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr double projection_dt = 0.1;
/// Of the share 1e-6 by which constraints give way.
constexpr double compliance_tolerance = 1e-5;

/// A row along z that starts from the force 2 at a gap of -0.25, with softness 0.5.
struct LoneRow {
  NodeVector normal{0, 0, 1, 0};
  ConstraintSystem system;

  LoneRow() {
    system.points.emplace_back().normal = Eigen::Vector3d::UnitZ();
    ConstraintRow& row = system.rows.emplace_back();
    row.ahead = {0, 0, 2, 0};
    row.start = -0.25;
    row.softness = 0.5;
  }
  /// Gives it friction of softness 0.25 with a slip of 0.02 and 0.1 that is held, and a traction of 1 along
  /// x.
  ConstraintFriction& make_rough(double coefficient) {
    row().friction = 0u;
    row().ahead.x() = 1.0;
    ConstraintFriction& friction = system.frictions.emplace_back();
    friction.limit_per_force = coefficient;
    friction.slip.x() = 0.02;
    friction.held.x() = 0.1;
    friction.softness = 0.25;
    return friction;
  }
  ConstraintRow& row() { return system.rows[0]; }
  NodeVector force(const NodeVector& changed) const {
    return ForceProjection(system, projection_dt).next_force(normal, system.rows[0], changed);
  }
  LightAnswer answer(const NodeVector& changed) const {
    return ForceProjection(system, projection_dt).answer(normal, system.rows[0], changed);
  }
};

}  // namespace

TEST_CASE("the normal force steps down the gap and never pulls where sides may part",
          "[contact][force_projection]") {
  LoneRow lone;
  // 2 - (-0.25 + 0.1) / 0.5; the motion along the surface does not count.
  const NodeVector pressed = lone.force({5.0, -3.0, 0.1, 0});
  CHECK(pressed.z() == Approx(2.3).epsilon(compliance_tolerance));
  CHECK(pressed.head<2>().isZero(0.0));
  CHECK(pressed.w() == 0.0);
  // 2 - (-0.25 + 1.75) / 0.5 = -1.
  CHECK(lone.force({0, 0, 1.75, 0}).isZero(0.0));
  lone.row().pulls = true;
  CHECK(lone.force({0, 0, 1.75, 0}).z() == Approx(-1.0).epsilon(compliance_tolerance));
}

TEST_CASE("friction steps down the slip and a tenth of what it holds, and is cut to its limit",
          "[contact][force_projection]") {
  LoneRow lone;
  ConstraintFriction& friction = lone.make_rough(0.5);
  // 1 - (0.02 + 0.1 x 0.1 + 0.01) / 0.25 along x and -0.05 / 0.25 along y, of a limit of 1.15.
  const NodeVector changed(0.01, 0.05, 0.1, 0);
  const NodeVector sticks = lone.force(changed);
  CHECK(sticks.x() == Approx(0.84).epsilon(compliance_tolerance));
  CHECK(sticks.y() == Approx(-0.2).epsilon(compliance_tolerance));
  CHECK(sticks.z() == Approx(2.3).epsilon(compliance_tolerance));
  friction.limit_per_force = 0.2;
  const NodeVector slides = lone.force(changed);
  CHECK(slides.head<2>().norm() == Approx(0.46).epsilon(compliance_tolerance));
  CHECK(slides.x() / slides.y() == Approx(0.84 / -0.2).epsilon(compliance_tolerance));
  // Of a light carrier the limit is that of the force that the pass starts from.
  lone.row().light = 0u;
  CHECK(lone.force(changed).head<2>().norm() == Approx(0.4).epsilon(compliance_tolerance));
}

TEST_CASE("without a coefficient the rule of the pair says the slip limit", "[contact][force_projection]") {
  LoneRow lone;
  PairRule rule;
  rule.friction = 0.3;
  lone.make_rough(-1.0).rule = &rule;
  const ForceProjection projection(lone.system, projection_dt);
  CHECK(projection.slip_limit(lone.row(), NodeVector::Zero(), 7.0) == Approx(2.1));
  CHECK(projection.slip_limit(lone.row(), NodeVector::Zero(), -7.0) == 0.0);
}

TEST_CASE("the force answers to a velocity along the normal where it presses, along the surface as it holds",
          "[contact][force_projection]") {
  LoneRow lone;
  const NodeVector pressing(0, 0, 0.1, 0), parting(0, 0, 1.75, 0);
  const double of_normal = projection_dt / 0.5, of_slip = projection_dt / 0.25;
  const LightAnswer pressed = lone.answer(pressing);
  CHECK(pressed.stiffest == Approx(of_normal).epsilon(compliance_tolerance));
  CHECK(pressed.rate.isApprox(Eigen::Vector3d(0, 0, of_normal).asDiagonal().toDenseMatrix(),
                              compliance_tolerance));
  CHECK(pressed.change.z() == Approx(0.3).epsilon(compliance_tolerance));
  CHECK(lone.answer(parting).rate.isZero(0.0));
  ConstraintFriction& friction = lone.make_rough(0.5);
  CHECK(lone.answer(pressing).rate.isApprox(
      Eigen::Vector3d(of_slip, of_slip, of_normal).asDiagonal().toDenseMatrix(), compliance_tolerance));
  // It slides along x: only across it does the force still turn, by 0.46 over the trial traction 0.88.
  friction.limit_per_force = 0.2;
  CHECK(lone.answer(pressing).rate.isApprox(
      Eigen::Vector3d(0, of_slip * 0.46 / 0.88, of_normal).asDiagonal().toDenseMatrix(),
      compliance_tolerance));
}
