// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/lanes.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// first, first + step, ...
Lanes row(double first, double step) {
  Lanes lanes;
  for (Eigen::Index lane = 0; lane < n_lanes; ++lane) lanes(lane) = first + step * static_cast<double>(lane);
  return lanes;
}

}  // namespace

TEST_CASE("lanes compute as numbers do, each for itself", "[core][lanes]") {
  const Lanes a = row(1.0, 0.7), b = row(-2.0, 0.9);
  const Lanes all[] = {a + b,   a - b,   a * b,   a / b,   -a,           a.sqrt(),
                       b.abs(), a.exp(), a.log(), a.cos(), 2.0 * a - 1.0};
  for (Eigen::Index lane = 0; lane < n_lanes; ++lane) {
    const double x = a(lane), y = b(lane);
    const double exact[] = {x + y, x - y, x * y, x / y, -x, std::sqrt(x), std::fabs(y)};
    for (std::size_t i = 0; i < 7; ++i) CHECK(all[i](lane) == exact[i]);
    const double near[] = {std::exp(x), std::log(x), std::cos(x), 2.0 * x - 1.0};
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(all[7 + i](lane) == Approx(near[i]).epsilon(1e-15).margin(1e-15));
  }
}

TEST_CASE("the lesser and the greater lane are those of std::min and std::max, also of what is no number",
          "[core][lanes]") {
  const double numbers[] = {1.0, -1.0, 0.0, -0.0, no_number, std::numeric_limits<double>::infinity()};
  const auto is_same = [](double a, double b) {
    return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
  };
  for (const double x : numbers) {
    for (const double y : numbers) {
      CHECK(is_same(Lanes(x).min(y)(3), std::min(x, y)));
      CHECK(is_same(Lanes(x).max(y)(3), std::max(x, y)));
    }
  }
}

TEST_CASE("masks hold where comparisons do, and nothing compares with what is no number", "[core][lanes]") {
  Lanes a = row(0.0, 1.0);
  a(6) = no_number;
  const LaneMask is_small = a < 3.0;
  for (Eigen::Index lane = 0; lane < n_lanes; ++lane) {
    CHECK(is_small(lane) == (lane < 3));
    CHECK((!is_small)(lane) == (lane >= 3));
    CHECK((a >= 3.0)(lane) == (lane >= 3 && lane != 6));
    CHECK((a != a)(lane) == (lane == 6));
    CHECK((is_small && a > 1.0)(lane) == (lane == 2));
    CHECK((is_small || a == 7.0)(lane) == (lane < 3 || lane == 7));
    CHECK(is_small.select(a, -1.0)(lane) == (lane < 3 ? static_cast<double>(lane) : -1.0));
  }
  CHECK(is_small.any());
  CHECK_FALSE(is_small.all());
  CHECK_FALSE((a < 0.0).any());
  CHECK((a >= 0.0 || a != a).all());
}

TEST_CASE("masks are made of bits, the lowest for the first lane", "[core][lanes]") {
  const LaneMask mask = LaneMask::of_bits(0b10000101);
  for (Eigen::Index lane = 0; lane < n_lanes; ++lane)
    CHECK(mask(lane) == (lane == 0 || lane == 2 || lane == 7));
  CHECK(LaneMask(true).all());
  CHECK_FALSE(LaneMask(false).any());
  for (std::size_t n = 0; n <= n_lanes; ++n) {
    for (Eigen::Index lane = 0; lane < n_lanes; ++lane)
      CHECK(first_lanes(n)(lane) == (static_cast<std::size_t>(lane) < n));
  }
}

TEST_CASE("a sum of the first lanes leaves the others out, whatever they hold", "[core][lanes]") {
  Lanes a = row(1.0, 1.0);
  CHECK(a.sum() == 36.0);
  CHECK(a.sum_of_first(8) == 36.0);
  a(5) = no_number;
  CHECK(a.sum_of_first(5) == 15.0);
  CHECK(a.sum_of_first(1) == 1.0);
  CHECK(a.sum_of_first(0) == 0.0);
}
