// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/friction.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

const Vector3d up = Vector3d::UnitZ();
const Vector3d nothing = Vector3d::Zero();

}  // namespace

TEST_CASE("friction sticks elastically, slides at its limit and turns back elastically",
          "[contact][friction]") {
  // Spring of 100, limit of 1: it holds 0.01.
  FrictionStep step = step_friction(up, nothing, {0.005, 0, 0}, 100.0, 1.0);
  CHECK((step.force - Vector3d(-0.5, 0, 0)).norm() < 1e-15);
  CHECK(step.slip == nothing);
  CHECK(step.dissipated == 0.0);
  step = step_friction(up, step.elastic_slip, {0.02, 0, 0}, 100.0, 1.0);
  CHECK((step.force - Vector3d(-1, 0, 0)).norm() < 1e-14);
  CHECK((step.slip - Vector3d(0.015, 0, 0)).norm() < 1e-16);
  CHECK(step.dissipated == Approx(0.015).epsilon(1e-14));
  step = step_friction(up, step.elastic_slip, {-0.015, 0, 0}, 100.0, 1.0);
  CHECK((step.force - Vector3d(0.5, 0, 0)).norm() < 1e-14);
  CHECK(step.dissipated == 0.0);
}

TEST_CASE("friction opposes the slip in any direction of the plane", "[contact][friction]") {
  const FrictionStep step = step_friction(up, nothing, {0.3, 0.4, 7.0}, 1000.0, 2.0);
  CHECK((step.force - Vector3d(-1.2, -1.6, 0.0)).norm() < 1e-12);
  CHECK(step.slip.norm() == Approx(0.5 - 0.002));
  CHECK(step.slip.z() == 0.0);
}

TEST_CASE("without a normal force nothing is held and nothing is lost", "[contact][friction]") {
  const FrictionStep step = step_friction(up, {0.01, 0, 0}, {0.1, 0, 0}, 100.0, 0.0);
  CHECK(step.force.norm() == 0.0);
  CHECK(step.elastic_slip.norm() == 0.0);
  CHECK(step.dissipated == 0.0);
}

TEST_CASE("what the spring holds turns with the plane and keeps its length", "[contact][friction]") {
  const Vector3d tilted = Vector3d(0, -0.6, 0.8);
  const FrictionStep step = step_friction(tilted, {0, 0.01, 0}, nothing, 100.0, 10.0);
  CHECK((step.elastic_slip - 0.01 * Vector3d(0, 0.8, 0.6)).norm() < 1e-16);
  CHECK(step_friction(up, up, nothing, 1.0, 1.0).elastic_slip == nothing);
}

TEST_CASE("work on the friction is what the spring keeps and what is lost", "[contact][friction]") {
  // A path in small steps: a closed loop keeps nothing in the spring that it did not have before.
  Vector3d elastic = nothing;
  double work = 0.0, lost = 0.0;
  constexpr int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / n;
    const Vector3d slip = 0.1 * 2.0 * EIGEN_PI / n * Vector3d(-std::sin(angle), std::cos(angle), 0.0);
    const FrictionStep step = step_friction(up, elastic, slip, 100.0, 1.0);
    work -= step.force.dot(slip);
    lost += step.dissipated;
    elastic = step.elastic_slip;
  }
  const double kept = 0.5 * 100.0 * elastic.squaredNorm();
  CHECK(lost > 0.5);
  CHECK(work == Approx(kept + lost).epsilon(2e-3));  // one-sided sums over 4000 steps
}

TEST_CASE("a record gets its friction", "[contact][friction]") {
  ContactPoint point;
  point.normal = up;
  point.force = 10.0;
  point.slip = {0.02, 0, 0};
  add_friction(100.0, 0.1 * point.force, point);
  CHECK((point.tangential - Vector3d(-1, 0, 0)).norm() < 1e-14);
  CHECK((point.elastic_slip - Vector3d(0.01, 0, 0)).norm() < 1e-16);
  CHECK((point.slip - Vector3d(0.01, 0, 0)).norm() < 1e-16);
  CHECK(point.dissipated == Approx(0.01));
}
