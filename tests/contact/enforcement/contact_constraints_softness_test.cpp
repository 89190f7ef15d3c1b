// SPDX-License-Identifier: BSD-3-Clause
#include "support/balanced_cubes.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using test::BalancedCubes;

namespace {

constexpr double balanced_step = BalancedCubes::dt;

/// The force of a pass that sees a gap close by 0.01 at the first point: 0.01 over its softness.
double softness_by(BalancedCubes& cubes, const LightCarriers& light, double least = 0.0) {
  cubes.mobility.begin_passes();
  cubes.contacts.list_pushes();
  LeaningAreas areas(cubes.mobility.n_carriers(), {0.0, 0.0});
  cubes.contacts.add_areas(areas);
  cubes.contacts.set_softness(areas, light, least);
  cubes.contacts.begin_passes();
  cubes.contacts.push_forces();
  cubes.mobility.end_pass();
  cubes.contacts.pass(0.0, light);
  cubes.contacts.finish();
  return 0.01 / cubes.contacts.points()[0].force;
}

LightCarriers none_light(std::size_t n_carriers) {
  LightCarriers light;
  light.begin(n_carriers);
  return light;
}

}  // namespace

TEST_CASE("a contact point that is alone is as soft as its sides", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, -0.1});
  cubes.add(cubes.point(0.0, GENERATE(0.01, 1.0, 50.0)));
  CHECK(softness_by(cubes, none_light(5)) == Approx(BalancedCubes::softness));
}

TEST_CASE("points around soften a contact point by their areas", "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.begin({0, 0, -0.1});
  cubes.add(cubes.point(0.0, 2.0));
  ContactPoint other = cubes.point(0.0, 3.0);
  other.second.nodes.fill({3});
  other.second.weights = Eigen::Vector4d::UnitX();
  other.second_entity = 1;
  cubes.add(other);  // leans on the same corner
  CHECK(softness_by(cubes, none_light(6)) ==
        Approx(balanced_step * balanced_step * (2.0 * (2.0 + 3.0) / 2.0 + 0.5)));
}

TEST_CASE("a side that is held gives way by nothing, and between two such sides nothing is done",
          "[contact][contact_constraints]") {
  BalancedCubes cubes;
  const bool are_both = GENERATE(false, true);
  std::vector<NodeIndex> held{{4}, {5}, {6}, {7}};
  if (are_both) held.push_back({8});
  cubes.cubes.hold(held, Components{{true, true, true}});
  cubes.begin({0, 0, -0.1});
  cubes.add(cubes.point(0.0));
  if (are_both) {
    ContactPoint free = cubes.point(0.0);
    free.first.nodes.fill({9});
    free.first_entity = 1;
    cubes.add(free);
  }
  const double found = softness_by(cubes, none_light(6));
  if (!are_both) CHECK(found == Approx(balanced_step * balanced_step * 2.0));
  if (!are_both) return;
  // The first is no constraint any more; the one behind it keeps what belongs to it.
  CHECK(cubes.contacts.points()[0].force == 0.0);
  CHECK(0.01 / cubes.contacts.points()[1].force == Approx(balanced_step * balanced_step * 2.0));
}

TEST_CASE("light carriers count for nothing, but their points are not stiffer than the least",
          "[contact][contact_constraints]") {
  BalancedCubes cubes;
  cubes.cubes.make_rigid();
  cubes.begin({0, 0, -0.1});
  cubes.add(cubes.point(0.0, 2.0));
  LightCarriers light = none_light(5);
  light.add(0, cubes.mobility.mobility(0));
  REQUIRE(cubes.mobility.is_body(0));
  const double least = GENERATE(0.0, 0.3);
  CHECK(softness_by(cubes, light, least) == Approx(balanced_step * std::max(balanced_step * 0.5, least)));
}
