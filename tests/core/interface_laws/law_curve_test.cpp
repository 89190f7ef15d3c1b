// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/law_curve.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a curve knows its integral, its end and its steepest line", "[core][law_curve]") {
  const LawCurve curve({{-1.0, 0.0}, {1.0, 4.0}, {3.0, 1.0}});
  CHECK(curve.at(0.0) == 2.0);
  CHECK(curve.at(5.0) == 1.0);
  CHECK(curve.last() == 3.0);
  CHECK(curve.steepest() == 2.0);
  CHECK(curve.integral(0.0) == 0.0);
  CHECK(curve.integral(1.0) == Approx(3.0));
  CHECK(curve.integral(3.0) == Approx(8.0));
  CHECK(curve.integral(4.0) == Approx(9.0));
}

TEST_CASE("a curve softens when its line to the origin never gets steeper", "[core][law_curve]") {
  CHECK(LawCurve({{0, 0}, {0.5, 10}, {1, 0}}).softens());
  CHECK(LawCurve({{0, 10}, {1, 0}}).softens());
  CHECK(LawCurve({{0, 0}, {0.25, 5}, {0.5, 10}, {1, 10}}).softens());
  CHECK(!LawCurve({{0, 0}, {0.5, 1}, {1, 10}}).softens());
  CHECK(!LawCurve({{0, 0}, {0.5, 1}, {1, -1}}).softens());
  CHECK(!LawCurve({{0, -1}, {1, 0}}).softens());
}
