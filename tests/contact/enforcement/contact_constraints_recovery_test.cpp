// SPDX-License-Identifier: BSD-3-Clause
#include "support/balanced_cubes.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using test::BalancedCubes;

namespace {

constexpr double deep_by = 0.01, comes_out = 2e-4, of_softness = BalancedCubes::softness;

/// The force on what penetrates once the pair is on, by the energy that it has lost.
double force_by(double lost, const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero()) {
  BalancedCubes cubes;
  cubes.begin({0, 0, 0});  // the step in which the pair begins
  cubes.histories[{0}].impact = lost;
  cubes.begin(velocity);
  ContactPoint point = cubes.point(-deep_by);
  cubes.add(point);
  cubes.solve(30, true);
  return cubes.contacts.points()[0].force;
}

}  // namespace

TEST_CASE("a penetration comes out as far as lost energy pays for it", "[contact][contact_constraints]") {
  // To push out by r takes a force r / c along r.
  const double whole = comes_out * comes_out / of_softness;
  CHECK(force_by(1.01 * whole) == Approx(comes_out / of_softness).epsilon(1e-4));
  CHECK(force_by(0.5 * whole) == Approx(0.5 * comes_out / of_softness).epsilon(1e-4));
  CHECK(force_by(0.0) == Approx(0.0).margin(1e-8));
  CHECK(force_by(-1.0) == Approx(0.0).margin(1e-8));
}

TEST_CASE("a share of the motion of the sides comes out whatever it takes",
          "[contact][contact_constraints]") {
  CHECK(force_by(0.0, {0.2, 0, 0}) == Approx(4e-3 * 0.1 * 0.2 / of_softness).epsilon(1e-4));
  CHECK(force_by(0.0, {20.0, 0, 0}) == Approx(comes_out / of_softness).epsilon(1e-4));  // not more than all
}

TEST_CASE("what closes is stopped whether or not what penetrates may come out",
          "[contact][contact_constraints]") {
  const double slow = 4e-3 * 0.1 * 0.1;
  CHECK(force_by(0.0, {0, 0, -0.1}) == Approx((0.01 + slow) / of_softness).epsilon(1e-4));
}

TEST_CASE("an overlap of a pair that begins pays for itself", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(-deep_by));
  cubes.solve(30, true);
  CHECK(cubes.recovery.of_overlaps({0}) == Approx(0.5 * deep_by * deep_by / of_softness));
  CHECK(cubes.contacts.points()[0].force == Approx(comes_out / of_softness).epsilon(1e-4));
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(-deep_by));
  cubes.solve(30, true);
  CHECK(cubes.recovery.of_overlaps({0}) == Approx(0.5 * deep_by * deep_by / of_softness));  // once
}

TEST_CASE("points of a pair share what it has lost", "[contact][contact_constraints]") {
  const double whole = comes_out * comes_out / of_softness;
  BalancedCubes cubes;
  cubes.begin({0, 0, 0});
  cubes.histories[{0}].impact = whole;
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(-deep_by));
  ContactPoint far = cubes.point(-deep_by);
  far.first.nodes.fill({11});
  far.second.nodes.fill({3});  // its own nodes, as soft
  far.second.weights = Eigen::Vector4d::UnitX();
  far.first_entity = 1;
  cubes.add(far);
  cubes.solve(30, true);
  // The second is softer, by 4 to 2.5: it takes less energy for the same way.
  const double needed = whole + comes_out * comes_out / (4.0 * BalancedCubes::dt * BalancedCubes::dt);
  CHECK(cubes.contacts.points()[0].force == Approx(whole / needed * comes_out / of_softness).epsilon(1e-3));
}
