// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/weld_failure.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// Forces on two of the first side's corners, and the opposite on the second side; the first is above.
CornerForces forces_of(const Vector3d& on_first) {
  CornerForces forces;
  forces.forces.setZero();
  forces.forces.col(0) = 0.25 * on_first;
  forces.forces.col(2) = 0.75 * on_first;
  forces.forces.col(5) = -on_first;
  forces.normal = Vector3d::UnitZ();
  return forces;
}

}  // namespace

TEST_CASE("the envelope of a weld is an ellipse of tension and shear", "[contact][weld]") {
  const WeldLaw weld{false, 10.0, 5.0};
  const InterfaceConstraint constraint;
  // What draws the sides together pulls the first one down.
  CHECK(weld_envelope(weld, constraint, forces_of({0, 0, -10})) == Approx(1.0));
  CHECK(weld_envelope(weld, constraint, forces_of({3, 4, 0})) == Approx(1.0));
  CHECK(weld_envelope(weld, constraint, forces_of({0, 2, -5})) == Approx(0.25 + 0.16));
  CHECK(weld_envelope(weld, constraint, forces_of({0, 0, 1000})) == 0.0);  // pressed together
  CHECK(weld_envelope(weld, constraint, forces_of({0, 2, 1000})) == Approx(0.16));
}

TEST_CASE("a weld holds by its share of a whole one, or by its area", "[contact][weld]") {
  InterfaceConstraint constraint;
  constraint.share = 0.5;
  constraint.area = 0.1;
  CHECK(weld_envelope({false, 10.0, 5.0}, constraint, forces_of({0, 0, -5})) == Approx(1.0));
  CHECK(weld_envelope({true, 10.0, 5.0}, constraint, forces_of({0, 0, -1})) == Approx(1.0));
}

TEST_CASE("a weld that fails passes on what is on its envelope", "[contact][weld]") {
  const WeldLaw weld{false, 10.0, 5.0};
  const InterfaceConstraint constraint;
  const CornerForces before = forces_of({3, 0, -20});
  const CornerForces after = forces_at_failure(weld, constraint, before);
  CHECK(weld_envelope(weld, constraint, after) == Approx(1.0));
  CHECK(after.forces.isApprox(before.forces / std::sqrt(weld_envelope(weld, constraint, before))));
}

TEST_CASE("what is pressed together passes on its forces along the surface alone", "[contact][weld]") {
  const WeldLaw weld{false, 10.0, 5.0};
  const CornerForces after = forces_at_failure(weld, {}, forces_of({6, 8, 100}));
  CHECK(after.forces.row(2).isZero(1e-12));
  CHECK(after.forces.leftCols<4>().rowwise().sum().isApprox(Vector3d(3, 4, 0)));
  CHECK(after.forces.rowwise().sum().norm() < 1e-12);
}
