// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/depth_law.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("the penalty is a spring up to a depth and gets stiffer from there to another one",
          "[contact][depth_law]") {
  const DepthLaw law(0.1, 0.3, 11.0);  // the slope grows by 50 per length
  CHECK(law.spring_depth(0.05) == 0.05);
  CHECK(law.slope(0.1) == 1.0);
  CHECK(law.slope(0.2) == Approx(6.0));
  CHECK(law.spring_depth(0.2) == Approx(0.2 + 0.5 * 50 * 0.01));
  CHECK(law.slope(0.3) == Approx(11.0));
  CHECK(law.slope(1.0) == Approx(11.0));
  CHECK(law.spring_depth(0.5) == Approx(0.3 + 0.5 * 50 * 0.04 + 0.2 * 11.0));
  const DepthLaw spring;
  CHECK(spring.spring_depth(7.0) == 7.0);
  CHECK(spring.slope(7.0) == 1.0);
  CHECK(spring.potential(7.0) == 24.5);
}

TEST_CASE("what the penalty stores is the work of its pressure", "[contact][depth_law]") {
  const DepthLaw law(0.1, 0.3, 11.0);
  double work = 0.0;
  const double step = 1e-4;
  for (int i = 0; i < 6000; ++i) {
    const double depth = (i + 0.5) * step;
    work += law.spring_depth(depth) * step;
    CHECK(law.potential(depth + 0.5 * step) == Approx(work).epsilon(1e-6));
    CHECK(law.spring_depth(depth + step) - law.spring_depth(depth) ==
          Approx(step * law.slope(depth + 0.5 * step)).epsilon(1e-3));
  }
}

TEST_CASE("many depths at once give what one gives", "[contact][depth_law]") {
  const DepthLaw law(0.1, 0.3, 11.0);
  Lanes depths;
  for (int i = 0; i < n_lanes; ++i) depths(i) = 0.08 * i;
  const Lanes springs = law.spring_depth(depths), potentials = law.potential(depths);
  for (int i = 0; i < n_lanes; ++i) {
    CHECK(springs(i) == Approx(law.spring_depth(depths(i))));
    CHECK(potentials(i) == Approx(law.potential(depths(i))));
  }
}
