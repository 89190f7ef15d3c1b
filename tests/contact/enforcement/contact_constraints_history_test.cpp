// SPDX-License-Identifier: BSD-3-Clause
#include "support/balanced_cubes.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using test::BalancedCubes;

namespace {

/// A point of two faces of the cubes, the middles of which are over each other.
ContactPoint faces_point(const BalancedCubes& cubes, std::uint8_t part, double area = 1.0) {
  ContactPoint point = cubes.point(0.0, area);
  point.part = part;
  point.first.nodes = {8, 10, 11, 9};
  point.first.weights.setConstant(0.25);
  return point;
}

/// The normal forces that the points begin their passes with.
std::vector<double> begun_forces(const BalancedCubes& cubes) {
  std::vector<double> forces;
  for (const ContactPoint& point : cubes.contacts.begun_points()) forces.push_back(point.force);
  return forces;
}

}  // namespace

TEST_CASE("points begin with half of their pressure and traction in the step before",
          "[contact][contact_constraints]") {
  BalancedCubes cubes(BalancedCubes::rough());
  const ContactPoint before = cubes.step({3.0, 4.0, -0.3}, 0.01);
  cubes.begin({0, 0, 0});
  CHECK(cubes.contacts.begun_points().empty());
  cubes.add(cubes.point(0.0, 2.0));  // twice the area
  const ContactPoint begun = cubes.contacts.begun_points()[0];
  CHECK(begun.force == Approx(before.force));
  CHECK(begun.tangential.isApprox(before.tangential));
  // What never touched begins with nothing.
  BalancedCubes others;
  others.step({0, 0, 0.3}, 0.01);
  others.begin({0, 0, 0});
  others.add(others.point(0.0));
  CHECK(begun_forces(others) == std::vector{0.0});
}

TEST_CASE("a law's force is among those that the passes begin with", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.step({0, 0, -0.3}, 0.01);
  cubes.begin({0, 0, 0});
  ContactPoint point = cubes.point(0.0);
  point.force = 3.0;
  cubes.add(point);
  CHECK(begun_forces(cubes)[0] == Approx(3.0 + 0.5 * 0.02 / BalancedCubes::softness).epsilon(1e-5));
}

TEST_CASE("behind load steps points begin with all of their forces, and touch as they are",
          "[contact][contact_constraints]") {
  BalancedCubes cubes(BalancedCubes::rough());
  ContactPoint pressed = cubes.point(0.0, 2.0);
  pressed.force = 6.0;
  pressed.tangential << 0.5, 0, 0;
  ContactPoint empty = pressed;
  empty.area = 0.0;
  cubes.contacts.begin_pressed(std::vector{pressed, empty});
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(5e-4, 2.0));  // within 1e-3 of the thickness
  const ContactPoint begun = cubes.contacts.begun_points()[0];
  CHECK(begun.force == Approx(6.0));
  CHECK(begun.tangential.isApprox(pressed.tangential));
  cubes.solve();
  // At rest nothing closes: of the gap that counts as none nothing comes out, nor of the force.
  CHECK(cubes.contacts.points()[0].force == Approx(0.0).margin(1e-5));
}

TEST_CASE("what is wider open than what load steps leave is beside it", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  ContactPoint pressed = cubes.point(0.0);
  pressed.force = 6.0;
  cubes.contacts.begin_pressed(std::vector{pressed});
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(2e-3));
  CHECK(begun_forces(cubes) == std::vector{0.0});
  cubes.solve();
  // The gap counts.
  CHECK(cubes.step({0, 0, -0.02}, 2e-3).force == 0.0);
}

TEST_CASE("what penetrates behind load steps without a pressure stays where it is",
          "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.contacts.begin_pressed({});
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(-0.01));
  cubes.solve();
  CHECK(cubes.contacts.points()[0].force == 0.0);
  CHECK(cubes.step({0, 0, 0}, -0.01).force == 0.0);  // and in the next step
  // What closes further presses.
  CHECK(cubes.step({0, 0, -0.1}, -0.01).force == Approx(0.01 / BalancedCubes::softness).epsilon(1e-5));
}

TEST_CASE("nodes of a pair press with no more than in load steps before", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  ContactPoint pressed = cubes.point(0.0);
  pressed.force = 6.0;
  cubes.contacts.begin_pressed(std::vector{pressed});
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(0.0, 1.0));
  ContactPoint other = cubes.point(0.0, 2.0);
  other.part = 1;  // a new one knows the pressure between the two
  cubes.add(other);
  CHECK(begun_forces(cubes) == std::vector{6.0, 12.0});
  cubes.contacts.spread_pressed();
  CHECK(begun_forces(cubes)[0] == Approx(2.0));
  CHECK(begun_forces(cubes)[1] == Approx(4.0));
}

TEST_CASE("a part of the nodes bears what it bore", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  ContactPoint pressed = cubes.point(0.0, 2.0);
  pressed.force = 6.0;
  cubes.contacts.begin_pressed(std::vector{pressed});
  cubes.begin({0, 0, 0});
  cubes.add(cubes.point(0.0, 1.0));
  cubes.contacts.spread_pressed();
  CHECK(begun_forces(cubes) == std::vector{3.0});
}

TEST_CASE("two faces press with no more than in load steps before", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  ContactPoint pressed = faces_point(cubes, 0);
  pressed.force = 6.0;
  cubes.contacts.begin_pressed(std::vector{pressed});
  cubes.begin({0, 0, 0});
  for (const std::uint8_t part : {0, 1, 2}) cubes.add(faces_point(cubes, part));
  CHECK(begun_forces(cubes) == std::vector{6.0, 6.0, 6.0});
  cubes.contacts.spread_pressed();
  for (const double force : begun_forces(cubes)) CHECK(force == Approx(2.0));
}
