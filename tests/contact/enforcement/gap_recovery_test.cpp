// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/gap_recovery.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a fifth of a penetration comes out in a step, and no more than the thickness allows",
          "[contact][enforcement]") {
  CHECK(left_gap(-1e-4, false, 1.0) == Approx(-0.8e-4));
  CHECK(left_gap(-1e-2, false, 1.0) == Approx(-1e-2 + 2e-4));
  CHECK(left_gap(-1e-2, false, 10.0) == Approx(-0.8e-2));
}

TEST_CASE("an open gap may close, what may not part comes back as slowly", "[contact][enforcement]") {
  CHECK(left_gap(1e-4, false, 1.0) == 0.0);
  CHECK(left_gap(1e-4, true, 1.0) == Approx(0.8e-4));
  CHECK(left_gap(1e-2, true, 1.0) == Approx(1e-2 - 2e-4));
  CHECK(left_gap(-1e-4, true, 1.0) == Approx(-0.8e-4));
}
