// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_constraints.hpp"

#include "support/balanced_cubes.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using test::BalancedCubes;

namespace {

constexpr double point_softness = BalancedCubes::softness;

}  // namespace

TEST_CASE("a contact point closes its gap and no more", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  const ContactPoint point = cubes.step({0, 0, -0.3}, 0.01);
  CHECK(point.force == Approx((0.03 - 0.01) / point_softness).epsilon(1e-5));
  CHECK(point.tangential.isZero(0.0));
  // Within the gap nothing presses, nor does what goes up.
  CHECK(cubes.step({0, 0, -0.09}, 0.01).force == 0.0);
  CHECK(cubes.step({0, 0, 0.3}, 0.01).force == 0.0);
  CHECK(cubes.step({5, 0, 0}, 0.0).force == 0.0);
}

TEST_CASE("the energy that a contact point takes is what the bodies lose", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  const bool has_friction = GENERATE(false, true);
  BalancedCubes other(has_friction ? BalancedCubes::rough() : "");
  const Eigen::Vector3d before(has_friction ? 2.0 : 0.0, 0, -0.3);
  other.begin(before);
  other.add(other.point(0.01));
  const ContactLoss loss = other.solve();
  const ContactPoint& point = other.contacts.points()[0];
  const Eigen::Vector3d after = before + BalancedCubes::dt * 2.5 * point.force_on_first();
  // Velocities against each other have the mass 1 / 2.5.
  const double lost = 0.5 / 2.5 * (before.squaredNorm() - after.squaredNorm());
  CHECK(loss.impact_before + loss.impact_after + loss.friction_before + loss.friction_after == Approx(lost));
  CHECK(point.impact == Approx(loss.impact_before + loss.impact_after));
  CHECK(point.dissipated == Approx(loss.friction_before + loss.friction_after));
  CHECK(point.work_before + point.work_after == Approx(lost));
  CHECK(point.knows_work);
  CHECK((loss.friction_before > 0.0) == has_friction);
}

TEST_CASE("friction holds what it can and slides on the cone", "[contact][contact_constraints]") {
  BalancedCubes cubes(BalancedCubes::rough());
  const ContactPoint held = cubes.step({0.03, -0.01, -0.3}, 0.01);
  CHECK(held.tangential.isApprox(-Eigen::Vector3d(0.003, -0.001, 0) / point_softness, 1e-5));
  CHECK(held.slip.isZero(0.0));
  CHECK(held.dissipated > 0.0);
  BalancedCubes others(BalancedCubes::rough());
  const ContactPoint slid = others.step({3.0, 4.0, -0.3}, 0.01);
  CHECK(slid.force == Approx(0.02 / point_softness).epsilon(1e-5));
  CHECK(slid.tangential.isApprox(-0.2 * slid.force * Eigen::Vector3d(0.6, 0.8, 0), 1e-6));
  CHECK(slid.slip.isApprox(BalancedCubes::dt * Eigen::Vector3d(3, 4, 0) + point_softness * slid.tangential,
                           1e-6));
  CHECK(slid.elastic_slip.isZero(0.0));
}

TEST_CASE("what has touched and may not part pulls, and comes back slowly",
          "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, 0.2});
  ContactPoint point = cubes.point(0.01);
  point.pulls = true;
  cubes.add(point);
  cubes.solve();
  // From a gap of 0.01 that would grow by 0.02 back by the 2e-4 of a thickness.
  CHECK(cubes.contacts.points()[0].force == Approx(-(0.02 + 2e-4) / point_softness).epsilon(1e-5));
}

TEST_CASE("a penetration comes out by a share of it or of the thickness in a step",
          "[contact][contact_constraints]") {
  CHECK(BalancedCubes().step({0, 0, 0}, -0.01, 1.0).force == Approx(2e-4 / point_softness).epsilon(1e-4));
  CHECK(BalancedCubes().step({0, 0, 0}, -0.01, 100.0).force == Approx(2e-3 / point_softness).epsilon(1e-4));
  CHECK(BalancedCubes().step({0, 0, -0.3}, -0.01, 1.0).force ==
        Approx(0.0302 / point_softness).epsilon(1e-5));
}

TEST_CASE("a law's force acts besides and is balanced with the rest", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, -0.3});
  ContactPoint law = cubes.point(0.01);
  law.is_balanced = false;
  law.force = 0.5;
  cubes.add(law);
  cubes.add(cubes.point(0.01));
  cubes.solve();
  CHECK(cubes.contacts.points()[0].force == 0.5);
  CHECK(cubes.contacts.points()[1].force == Approx(0.02 / point_softness - 0.5).epsilon(1e-5));
}

TEST_CASE("points between the same entities share the force by their areas",
          "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, -0.3});
  for (const double area : {1.0, 3.0}) {
    ContactPoint point = cubes.point(0.01, area);
    point.part = area == 1.0 ? 0 : 1;
    cubes.add(point);
  }
  cubes.solve();
  const auto points = cubes.contacts.points();
  CHECK(points[0].force + points[1].force == Approx(0.02 / point_softness).epsilon(1e-5));
  CHECK(points[1].force == Approx(3.0 * points[0].force).epsilon(1e-4));
}

TEST_CASE("points without area are no constraints", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, -0.3});
  cubes.add(cubes.point(-0.01, 0.0));
  cubes.solve();
  CHECK(cubes.contacts.points().size() == 1);
  CHECK(cubes.contacts.points()[0].force == 0.0);
}

TEST_CASE("what passes leave of a penetration is made up for in the next step, up to a tenth",
          "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, -0.3});
  cubes.add(cubes.point(0.0));
  ContactPoint other = cubes.point(0.0);
  other.second.nodes.fill({3});
  other.second.weights = Eigen::Vector4d::UnitX();
  other.second_entity = 1;
  cubes.add(other);
  cubes.solve(1);
  // Both lean on one corner: D is 0.045 and 0.06, A ((0.025, 0.02), (0.02, 0.04)).
  CHECK(cubes.contacts.points()[0].force == Approx(0.03 / 0.045));
  CHECK(cubes.contacts.points()[1].force == Approx(0.03 / 0.06));
  // Of 0.03 - 0.026667 that is left at the first no more than 0.1 x 0.03.
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(-0.01), 100.0);
  cubes.solve();
  CHECK(cubes.contacts.points()[0].force == Approx((0.002 + 0.003) / point_softness).epsilon(1e-4));
}

TEST_CASE("what a light body answers is the derivative of the forces of its points",
          "[contact][contact_constraints]") {
  BalancedCubes cubes(BalancedCubes::rough());
  cubes.cubes.make_rigid();
  const double along = GENERATE(0.001, 2.0);  // it sticks, it slides
  const double up = GENERATE(-0.3, 0.3);      // it presses, it parts
  // A step before, whose force the passes begin with: the cone is that of the force that a pass looks at.
  cubes.step({0, 0, -0.5}, 0.0);
  cubes.begin({along, 0.3 * along, up});
  cubes.add(cubes.point(0.0));
  cubes.mobility.begin_passes();
  cubes.contacts.list_pushes();
  LeaningAreas areas(cubes.mobility.n_carriers(), {0.0, 0.0});
  cubes.contacts.add_areas(areas);
  std::vector<CarrierLoad> loads(areas.size());
  cubes.contacts.add_loads(areas, loads);
  cubes.light.begin(cubes.mobility.n_carriers());
  const std::uint32_t body = cubes.mobility.is_body(0) ? 0 : 4;
  REQUIRE(cubes.mobility.is_body(body));
  cubes.light.add(body, cubes.mobility.mobility(body));
  cubes.contacts.set_softness(areas, cubes.light, 1e-3);
  cubes.contacts.add_rows(cubes.light);
  cubes.contacts.begin_passes();
  cubes.contacts.push_forces();
  cubes.mobility.end_pass();
  constexpr double probe = 1e-6;
  for (const Eigen::Vector3d& velocity :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.01, 0.02, -0.4), Eigen::Vector3d(0, 0, 0.3)}) {
    const LightAnswer answer = cubes.contacts.answer(0, velocity);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = probe * Eigen::Vector3d::Unit(i);
      const Eigen::Vector3d rate = -(cubes.contacts.answer(0, velocity + step).force -
                                     cubes.contacts.answer(0, velocity - step).force) /
                                   (2.0 * probe);
      CHECK((answer.rate.col(i) - rate).norm() < 1e-5 * answer.stiffest);
    }
    const Eigen::Vector3d before = cubes.contacts.begun_points()[0].force_on_first();
    CHECK((answer.force - answer.change - before).norm() < 1e-12);
  }
}
