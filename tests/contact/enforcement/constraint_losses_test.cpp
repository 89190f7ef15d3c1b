// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/constraint_losses.hpp"

#include "support/balanced_cubes.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using test::BalancedCubes;

namespace {

/// A corner that comes down by 0.3 and slides by 0.5 along x, as in the step before; steps of 0.1.
struct FinishedRow {
  BalancedCubes cubes;
  ConstraintSystem system;
  ContactLoss loss;

  FinishedRow() {
    cubes.begin({0.5, 0, -0.3});
    system.points.push_back(cubes.point(0.01, 4.0));
    ConstraintRow& row = system.rows.emplace_back();
    row.start = -0.02;  // 0.01 - 0.03
    row.softness = 0.025;
  }
  void make_rough(double coefficient) {
    system.rows[0].friction = 0u;
    ConstraintFriction& friction = system.frictions.emplace_back();
    friction.limit_per_force = coefficient;
    friction.slip.x() = 0.05;
    friction.held.x() = 0.07;
  }
  ContactHistory::Entry finish(const Eigen::Vector3d& force, const NodeVector& change,
                               bool is_first_step = false) {
    system.rows[0].force = node_vector(force);
    const ConstraintLosses losses{system, cubes.cubes.parts.kinematics, BalancedCubes::dt, BalancedCubes::dt,
                                  is_first_step};
    return losses.finish(system.rows[0], force.z(), change, loss);
  }
  const ContactPoint& point() const { return system.points[0]; }
};

}  // namespace

TEST_CASE("a normal force takes its work along half of both steps", "[contact][constraint_losses]") {
  FinishedRow finished;
  const auto entry = finished.finish({0, 0, 2.0}, {0, 0, 0.01, 0});
  // It went by -0.03 before, and goes by -0.03 + 0.01 now.
  CHECK(finished.loss.impact_before == Approx(0.5 * 2.0 * 0.03));
  CHECK(finished.loss.impact_after == Approx(0.5 * 2.0 * 0.02));
  CHECK(finished.loss.friction_before + finished.loss.friction_after == 0.0);
  CHECK(finished.point().impact == Approx(0.05));
  CHECK(finished.point().work_before == Approx(0.03));
  CHECK(finished.point().work_after == Approx(0.02));
  CHECK(finished.point().force == 2.0);
  CHECK(finished.point().knows_work);
  REQUIRE(entry.is_known());
  CHECK(entry.pressure == Approx(0.5));
  CHECK(entry.area == 4.0);
  // Left of the penetration: 0.02 - 0.01, but at most a tenth of 2 x 0.025.
  CHECK(entry.left == Approx(0.005));
}

TEST_CASE("in the first step the half step before mirrors the one to come", "[contact][constraint_losses]") {
  FinishedRow finished;
  finished.finish({0, 0, 2.0}, {0, 0, 0.01, 0}, true);
  // Nothing but contact changes the velocity: a quarter of the force along the change.
  CHECK(finished.loss.impact_before == Approx(0.25 * 2.0 * 0.01));
  CHECK(finished.loss.impact_after == Approx(0.5 * 2.0 * 0.02));
}

TEST_CASE("what does not press loses nothing and is forgotten, but for where it just touches",
          "[contact][constraint_losses]") {
  FinishedRow finished;
  CHECK_FALSE(finished.finish({0, 0, 0}, NodeVector::Zero()).is_known());
  CHECK(finished.point().impact == 0.0);
  CHECK_FALSE(finished.point().knows_work);
  finished.system.rows[0].zero_gap = -0.004;
  const auto entry = finished.finish({0, 0, 0}, NodeVector::Zero());
  REQUIRE(entry.is_known());
  CHECK(entry.pressure == 0.0);
  CHECK(entry.zero_gap == -0.004);
  // Where sides may not part a pull counts as a push does.
  finished.system.rows[0].pulls = true;
  REQUIRE(finished.finish({0, 0, -1.0}, NodeVector::Zero()).is_known());
  CHECK(finished.loss.impact_after == Approx(-0.5 * 0.03));
}

TEST_CASE("friction takes its work along the slip of both half steps", "[contact][constraint_losses]") {
  FinishedRow finished;
  const bool slides = GENERATE(false, true);
  finished.make_rough(slides ? 0.3 : 0.5);
  const auto entry = finished.finish({-0.6, 0, 2.0}, {-0.01, 0, 0.01, 0});
  // It went by 0.05 along x before, and goes by 0.05 - 0.01 now.
  CHECK(finished.loss.friction_before == Approx(0.5 * 0.6 * 0.05));
  CHECK(finished.loss.friction_after == Approx(0.5 * 0.6 * 0.04));
  CHECK(finished.point().dissipated == Approx(0.027));
  CHECK(finished.point().work_before == Approx(0.03 + 0.015));
  CHECK(finished.point().work_after == Approx(0.02 + 0.012));
  CHECK(finished.point().tangential.isApprox(Eigen::Vector3d(-0.6, 0, 0)));
  CHECK(finished.point().slip.isApprox(Eigen::Vector3d(slides ? 0.04 : 0.0, 0, 0)));
  CHECK(finished.point().elastic_slip.isApprox(Eigen::Vector3d(slides ? 0.0 : 0.11, 0, 0)));
  REQUIRE(entry.is_known());
  CHECK(entry.traction.isApprox(Eigen::Vector3d(-0.15, 0, 0)));
  CHECK(entry.held.isApprox(finished.point().elastic_slip));
}
