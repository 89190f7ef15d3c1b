// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/crossed_sheets.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Way = std::array<Eigen::Vector3d, 2>;

Way stays(double x, double y, double z) { return {Eigen::Vector3d(x, y, z), Eigen::Vector3d(x, y, z)}; }
Way goes(const Eigen::Vector3d& from, const Eigen::Vector3d& by) { return {from, from + by}; }

const std::array<Way, 3> triangle{stays(0, 0, 0), stays(1, 0, 0), stays(0, 1, 0)};

}  // namespace

TEST_CASE("a point goes through a triangle where it meets its plane between the corners",
          "[contact][overlap]") {
  const double x = GENERATE(-0.01, 0.01, 0.3, 0.69, 0.71);
  const bool is_within = x > 0.0 && x < 0.7;
  CHECK(goes_through(goes({x, 0.3, 1}, {0, 0, -1.5}), triangle) == is_within);
  CHECK(goes_through(goes({x, 0.3, -0.5}, {0, 0, 1.5}), triangle) == is_within);
  CHECK_FALSE(goes_through(goes({x, 0.3, 1}, {0, 0, -0.9}), triangle));
}

TEST_CASE("a triangle that goes over a point at rest is gone through", "[contact][overlap]") {
  const Eigen::Vector3d by(0.2, 0, 1);
  const std::array moving{goes({0, 0, 0}, by), goes({1, 0, 0}, by), goes({0, 1, 0}, by)};
  CHECK(goes_through(stays(0.3, 0.3, 0.5), moving));
  CHECK_FALSE(goes_through(stays(0.05, 0.3, 0.5), moving));  // it has gone past by then
  CHECK_FALSE(goes_through(goes({0.3, 0.3, 0.5}, by), moving));
}

TEST_CASE("a triangle that turns over is gone through on the way", "[contact][overlap]") {
  // About its first edge, by a quarter turn, along chords.
  const std::array turning{stays(0, 0, 0), stays(1, 0, 0), goes({0, 1, 0}, {0, -1, 1})};
  CHECK(goes_through(stays(0.2, 0.2, 0.2), turning));
  CHECK_FALSE(goes_through(stays(0.2, 0.2, -0.2), turning));
}
