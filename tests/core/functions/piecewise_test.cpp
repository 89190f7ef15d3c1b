// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/piecewise.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr double unknown_x = std::numeric_limits<double>::quiet_NaN();
constexpr double far_away = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a piecewise linear function meets its points and holds its ends", "[core][function]") {
  const PiecewiseLinear f({{1, 10}, {2, 20}, {4, -20}});
  CHECK(f.evaluate(1.0) == 10.0);
  CHECK(f.evaluate(2.0) == 20.0);
  CHECK(f.evaluate(4.0) == -20.0);
  CHECK(f.evaluate(1.25) == 12.5);
  CHECK(f.evaluate(3.0) == 0.0);
  CHECK(f.evaluate(0.0) == 10.0);
  CHECK(f.evaluate(-far_away) == 10.0);
  CHECK(f.evaluate(5.0) == -20.0);
  CHECK(f.evaluate(far_away) == -20.0);
  CHECK(std::isnan(f.evaluate(unknown_x)));
}

TEST_CASE("a jump has the value of the side that is asked for", "[core][function]") {
  const std::vector<FunctionPoint> points{{0, 5}, {0, 1}, {1, 2}, {1, 4}, {2, 6}, {2, 9}};
  const PiecewiseLinear right(points), left(points, DiscontinuitySide::left);
  CHECK(right.evaluate(0.0) == 1.0);
  CHECK(left.evaluate(0.0) == 5.0);
  CHECK(right.evaluate(1.0) == 4.0);
  CHECK(left.evaluate(1.0) == 2.0);
  CHECK(right.evaluate(2.0) == 9.0);
  CHECK(left.evaluate(2.0) == 6.0);
  for (const PiecewiseLinear& f : {right, left}) {
    CHECK(f.evaluate(-1.0) == 5.0);
    CHECK(f.evaluate(0.5) == 1.5);
    CHECK(f.evaluate(1.5) == 5.0);
    CHECK(f.evaluate(3.0) == 9.0);
  }
}

TEST_CASE("a piecewise linear function equals a search through all its lines", "[core][function]") {
  std::vector<FunctionPoint> points;
  for (int i = 0; i < 50; ++i) points.push_back({static_cast<double>(i * i), std::sin(i)});
  const PiecewiseLinear f(points);
  for (double x = 0.0; x < 2401.0; x += 0.7) {
    std::size_t i = 0;
    while (points[i + 1].x <= x) ++i;
    const FunctionPoint a = points[i], b = points[i + 1];
    CHECK(f.evaluate(x) == Approx(a.y + (b.y - a.y) / (b.x - a.x) * (x - a.x)).margin(1e-14));
  }
}

TEST_CASE("a piecewise linear function of huge values does not overflow", "[core][function]") {
  CHECK(PiecewiseLinear({{0, -1.5e308}, {1, 1.5e308}}).evaluate(0.5) == 0.0);
}

TEST_CASE("a table of one point is its value everywhere", "[core][function]") {
  const PiecewiseLinear line({{1, 10}});
  const PiecewiseConstant step({{1, 10}}, DiscontinuitySide::left);
  for (const double x : {0.0, 1.0, 2.0}) {
    CHECK(line.evaluate(x) == 10.0);
    CHECK(step.evaluate(x) == 10.0);
  }
}

TEST_CASE("a piecewise constant function steps at its points", "[core][function]") {
  const std::vector<FunctionPoint> points{{1, 10}, {2, 20}, {3, 30}};
  const PiecewiseConstant right(points, DiscontinuitySide::right), left(points, DiscontinuitySide::left);
  for (const PiecewiseConstant& f : {right, left}) {
    CHECK(f.evaluate(0.0) == 10.0);
    CHECK(f.evaluate(1.0) == 10.0);
    CHECK(f.evaluate(1.5) == 10.0);
    CHECK(f.evaluate(2.5) == 20.0);
    CHECK(f.evaluate(9.0) == 30.0);
    CHECK(std::isnan(f.evaluate(unknown_x)));
  }
  CHECK(right.evaluate(2.0) == 20.0);
  CHECK(left.evaluate(2.0) == 10.0);
  CHECK(right.evaluate(3.0) == 30.0);
  CHECK(left.evaluate(3.0) == 20.0);
}
