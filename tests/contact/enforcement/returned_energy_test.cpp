// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/returned_energy.hpp"

#include <limits>

#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;

namespace {

constexpr double no_limit = std::numeric_limits<double>::quiet_NaN();

/// A spring of force 10 between two cubes that move by a velocity along it, in a step of a pair.
struct LimitedSpring {
  test::TwoCubes cubes;
  PairWork work{2};
  std::vector<ContactPoint> points;
  IndexedVector<PairIndex, double> energy{0.0, no_limit}, least{0.0, 0.0};
  std::vector<double> accelerations;

  LimitedSpring(double depth, double opening, double dt) {
    cubes.parts.v.rightCols(8).row(2).setConstant(opening);
    cubes.parts.kinematics.move_nodes(cubes.parts.motion(dt));
    work.begin_step(cubes.parts.kinematics, dt);
    points.push_back(test::TwoCubes::corner_over_face());
    points[0].force = 10.0;
    points[0].gap = -depth;
  }
  void limit() {
    accelerations.resize(points.size(), 0.0);
    limit_returned_energy(cubes.parts.kinematics, work, {energy, least}, accelerations, points);
  }
  /// The force of the point at an energy of its pair.
  double force_at(double available, double least_of_all = 0.0) {
    energy[{0}] = available;
    least[{0}] = least_of_all;
    points[0].force = 10.0;
    limit();
    return points[0].force;
  }
};

}  // namespace

TEST_CASE("springs keep their force as long as the pair has the energy, and lose it as that runs out",
          "[contact][returned_energy]") {
  // It holds 0.5, and gives 0.1 in half of the step: it needs 0.3 (0.5 + 0.1).
  LimitedSpring spring(0.1, 1.0, 0.02);
  CHECK(spring.force_at(0.19) == 10.0);
  CHECK(spring.force_at(0.17) < 10.0);
  CHECK(spring.force_at(0.09) == Approx(5.0));
  CHECK(spring.force_at(0.0) == 0.0);
  CHECK(spring.force_at(-1.0) == 0.0);
  CHECK(spring.force_at(no_limit) == 10.0);
}

TEST_CASE("what a pair has given out from nowhere before is no debt", "[contact][returned_energy]") {
  LimitedSpring spring(0.1, 1.0, 0.02);
  CHECK(spring.force_at(-1.0, -1.19) == 10.0);
  CHECK(spring.force_at(-1.0, -1.09) == Approx(5.0));
  CHECK(spring.force_at(-1.0, -1.0) == 0.0);
}

TEST_CASE("springs that get longer have the force of springs that hold the energy of the pair",
          "[contact][returned_energy]") {
  // It holds 0.5, of which it takes 0.1 in half of the step: it needs 0.3 (0.5 - 0.1).
  LimitedSpring spring(0.1, -1.0, 0.02);
  CHECK(spring.force_at(0.13) == 10.0);
  CHECK(spring.force_at(0.03) == Approx(5.0));  // half the force at a quarter of the energy
  // What has got longer in this step alone resists: 0.2 of all of its work F d.
  CHECK(spring.force_at(0.0) == Approx(2.0));
}

TEST_CASE("friction and damping are lowered along with the force of a point", "[contact][returned_energy]") {
  LimitedSpring spring(0.1, 1.0, 0.02);
  spring.points[0].tangential << 4, 2, 0;
  spring.points[0].dissipated = 0.06;
  spring.points[0].beyond_spring = -0.06;  // what it needs stays 0.18
  spring.points[0].damped = 0.0;
  CHECK(spring.force_at(0.09) == Approx(5.0));
  CHECK(spring.points[0].tangential.isApprox(Eigen::Vector3d(2, 1, 0)));
  CHECK(spring.points[0].dissipated == Approx(0.03));
}

TEST_CASE("a point that parts in a step gives the energy that the pair has left",
          "[contact][returned_energy]") {
  // In touch along 0.01 of the 0.1 that it goes in the step and goes again in the next one.
  const double available = GENERATE(0.3, 0.6, 0.9);
  LimitedSpring spring(0.01, 1.0, 0.1);
  const double force = spring.force_at(available);
  CHECK(force < 10.0);
  CHECK(2.0 * 0.5 * force * 0.1 == Approx(available));
}

TEST_CASE("a point that meets in a step takes what its spring would hold and the half step behind",
          "[contact][returned_energy]") {
  LimitedSpring spring(0.01, -1.0, 0.1);
  const double force = spring.force_at(0.0);
  CHECK(2.0 * 0.5 * force * 0.1 == Approx(0.5 * 10.0 * 0.01 + 0.5 * 10.0 * 0.1));
}

TEST_CASE("what a point is spared of counts how its force changes the next step",
          "[contact][returned_energy]") {
  constexpr double way = 0.1, depth = 0.01, growth = 0.03;
  const double opening = GENERATE(-1.0, 1.0);
  LimitedSpring spring(depth, opening, 0.1);
  spring.accelerations = {growth / (0.1 * 0.1)};
  // An energy at which all of the excess is spared: where it meets 0, where it parts what it gives along the
  // two steps.
  const double f = spring.force_at(opening < 0.0 ? 0.0 : 0.05 + 0.5) / 10.0;
  CHECK(f < 1.0);
  if (opening < 0.0) {
    CHECK(f * way - (1.0 - f) * (way - f * growth) == Approx(depth));
  } else {
    CHECK(f * (way + f * growth) - (1.0 - f) * way == Approx(depth));
  }
}

TEST_CASE("what pulls as well neither meets nor parts", "[contact][returned_energy]") {
  LimitedSpring spring(0.01, -1.0, 0.1);
  spring.points[0].pulls = true;
  CHECK(spring.force_at(0.0) == 10.0);
}

TEST_CASE("points of a pair share its energy, other pairs have their own", "[contact][returned_energy]") {
  LimitedSpring spring(0.1, 1.0, 0.02);
  for (const int pair : {0, 1}) {
    spring.points.push_back(spring.points[0]);
    spring.points.back().pair = {static_cast<std::uint32_t>(pair)};
  }
  ContactPoint open = spring.points[0];
  open.force = 0.0;
  open.gap = 0.2;
  spring.points.push_back(open);
  CHECK(spring.force_at(0.18) == Approx(5.0));  // both need 0.36
  CHECK(spring.points[1].force == Approx(5.0));
  CHECK(spring.points[2].force == 10.0);
  CHECK(spring.points[3].force == 0.0);
}
