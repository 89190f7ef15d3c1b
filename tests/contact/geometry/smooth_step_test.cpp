// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/smooth_step.hpp"

#include "support/catch.hpp"

using contactsim::smooth_step;

TEST_CASE("a smooth step has no kink at its ends and the same rise on both halves", "[contact][geometry]") {
  CHECK(smooth_step(0.0) == 0.0);
  CHECK(smooth_step(0.5) == 0.5);
  CHECK(smooth_step(1.0) == 1.0);
  CHECK(smooth_step(1e-4) == Approx(3e-8).epsilon(1e-3));
  CHECK(1.0 - smooth_step(0.75) == Approx(smooth_step(0.25)));
}
