// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_mobility.hpp"

#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using test::TwoCubes;

namespace {

/// Two cubes, of which the second is rigid, and how they give way.
struct RigidCube : TwoCubes {
  ContactMobility mobility;

  RigidCube() : mobility(make_rigid()) { mobility.update(0.0); }
};

const Eigen::Vector3d unit_x = Eigen::Vector3d::UnitX(), unit_z = Eigen::Vector3d::UnitZ();

}  // namespace

TEST_CASE("a free node gives way by its mass, a held one along what is free", "[contact][contact_mobility]") {
  TwoCubes cubes;
  cubes.hold({{3}}, Components{{false, false, true}});
  ContactMobility mobility(cubes.model);
  CHECK(mobility.update(0.0));
  CHECK_FALSE(mobility.update(1.0));
  const ContactKinematics& kinematics = cubes.parts.kinematics;
  CHECK(mobility.mobility(kinematics, {0}, &unit_z) == 2.0);
  CHECK(mobility.mobility(kinematics, {3}, &unit_z) == 0.0);
  CHECK(mobility.mobility(kinematics, {3}, &unit_x) == 2.0);
  CHECK(mobility.mobility(kinematics, {3}, nullptr) == 2.0);
  CHECK(mobility.is_held(kinematics, {3}, &unit_z));
  CHECK_FALSE(mobility.is_held(kinematics, {3}, &unit_x));
  CHECK_FALSE(mobility.is_held(kinematics, {3}, nullptr));
  CHECK_FALSE(mobility.is_held(kinematics, {0}, &unit_z));
}

TEST_CASE("a node of a rigid body gives way by the whole body", "[contact][contact_mobility]") {
  const RigidCube cubes;
  const ContactKinematics& kinematics = cubes.parts.kinematics;
  CHECK(cubes.mobility.is_of_body(kinematics.contact_mesh(), {9}));
  // A corner is sqrt(0.75) from the centre; the least moment of inertia is 2.
  CHECK(cubes.mobility.mobility(kinematics, {9}, &unit_z) == Approx(1.0 / 8 + 0.75 / 2));
}

TEST_CASE("the springs of a rigid body's nodes add up, those of nodes do not",
          "[contact][contact_mobility]") {
  RigidCube cubes;
  ContactPoint point;
  point.stiffness = 3.0;
  point.normal = unit_z;
  point.first = {{8, 9, 10, 11}, {0.25, 0.25, 0.25, 0.25}, 0.0};
  point.second = {{4, 5, 6, 7}, {0.5, 0.5, 0.0, 0.0}, 0.0};
  const std::vector<ContactPoint> points{point, point};
  const IndexedVector<PairIndex, std::uint8_t> slips{0};
  const auto rates = cubes.mobility.find_rates(cubes.parts.kinematics, points, {}, slips);
  CHECK(rates[{4}] == Approx(2 * 0.5 * 3.0 * 2.0));
  CHECK(rates[{6}] == 0.0);
  CHECK(rates[{8}] == Approx(2 * 3.0 * 0.5));
  CHECK(rates[{15}] == rates[{8}]);
}

TEST_CASE("contact alone accelerates rigid bodies, and not what elements hold",
          "[contact][contact_mobility]") {
  RigidCube cubes;
  ContactPoint point;
  point.first.nodes.fill({8});  // of the body of mass 8
  point.second.nodes.fill({4});
  point.first.weights = point.second.weights = Eigen::Vector4d::UnitX();
  point.normal = unit_z;
  point.force = 16.0;
  std::vector<ContactPoint> points{point, point};
  points[1].first.nodes.fill({9});
  for (const double acceleration : cubes.mobility.find_accelerations(cubes.parts.kinematics, points))
    CHECK(acceleration == 4.0);  // both forces move it, the other side's nodes have elements
  for (ContactPoint& swapped : points) std::swap(swapped.first, swapped.second);
  for (const double acceleration : cubes.mobility.find_accelerations(cubes.parts.kinematics, points))
    CHECK(acceleration == 4.0);  // forces on the second side point the other way, and so does it
  for (ContactPoint& apart : points) apart.force = 0.0;
  for (const double acceleration : cubes.mobility.find_accelerations(cubes.parts.kinematics, points))
    CHECK(acceleration == 0.0);
}
