// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/projected_pair.hpp"

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("bounds of the gap of two faces hold every point of both", "[contact][projected_pair]") {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const MovingFace first = random_face(random, i % 2 == 0, false, 0.3),
                     second = random_face(random, i % 3 == 0, true, 0.0);
    const auto pair = project_pair(first, second);
    REQUIRE(pair);
    for (int k = 0; k < 4; ++k) {
      for (int m = 0; m < 4; ++m) {
        const double apart = pair->plane.normal.dot(Eigen::Vector3d(first.x.col(k) - second.x.col(m)));
        CHECK(apart >= pair->min_gap - 1e-12);
        CHECK(apart <= pair->max_gap + 1e-12);
      }
      // Distances are kept.
      const Eigen::Vector3d edge = first.x.col(k) - first.x.col(0),
                            seen = pair->first.col(k) - pair->first.col(0);
      CHECK(seen.norm() == Approx(edge.norm()).margin(1e-12));
    }
  }
}

TEST_CASE("a pair that is turned round has the same gaps", "[contact][projected_pair]") {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const MovingFace first = random_face(random, i % 2 == 0, false, 0.3),
                     second = random_face(random, i % 3 == 0, true, 0.0);
    const auto pair = project_pair(first, second), turned = project_pair(second, first);
    REQUIRE((pair && turned));
    CHECK(turned->min_gap == Approx(pair->min_gap));
    CHECK(turned->max_gap == Approx(pair->max_gap));
  }
}

TEST_CASE("heights ahead of time are those that the faces move to", "[contact][projected_pair]") {
  MovingFace first = make_square(0.0, 0.5, false), second = make_square(0.0, 0.0, true);
  first.v.row(2).setConstant(-2.0);
  first.v.row(0).setConstant(7.0);  // along the plane they stay where they are
  second.v.row(2).setConstant(1.0);
  const auto now = project_pair(first, second), ahead = project_pair(first, second, 0.1);
  REQUIRE((now && ahead));
  CHECK(now->min_gap == Approx(0.5));
  CHECK(ahead->min_gap == Approx(0.5 - 0.3));
  CHECK(ahead->first.topRows<2>() == now->first.topRows<2>());
}

TEST_CASE("faces that look the same way are no pair", "[contact][projected_pair]") {
  CHECK_FALSE(project_pair(make_square(0.0, 0.5, true), make_square(0.0, 0.0, true)));
  CHECK(project_pair(make_square(0.0, 0.5, false), make_square(0.0, 0.0, true)));
}

TEST_CASE("faces are near where their boxes meet, and their gap lies between the limits",
          "[contact][projected_pair]") {
  const auto is_near_at = [](double aside, double gap) {
    const auto pair = project_pair(make_square(aside, gap, false), make_square(0.0, 0.0, true));
    return is_near(*pair, 0.1, 0.2);
  };
  CHECK(is_near_at(0.0, 0.05));
  CHECK_FALSE(is_near_at(0.0, 0.1));
  CHECK(is_near_at(0.0, -0.19));
  CHECK_FALSE(is_near_at(0.0, -0.2));
  CHECK(is_near_at(0.9, 0.05));
  CHECK_FALSE(is_near_at(2.5, 0.05));
  CHECK_FALSE(is_near_at(-2.5, 0.05));
}

TEST_CASE("the overlap of two projected squares is a polygon of their common area",
          "[contact][projected_pair]") {
  const MovingFace first = make_square(0.25, 0.1, false), second = make_square(0.0, 0.0, true);
  auto pair = project_pair(first, second);
  REQUIRE(pair);
  make_maps(first, second, *pair);
  CHECK(overlap_of(*pair).area() == Approx(0.75));
  FaceMoments moments{};
  Lanes f = Lanes::Constant(2.0), xi = Lanes::Constant(0.5), eta = Lanes::Constant(-0.25);
  add_moments(f, xi, eta, moments);
  add_moments(f, xi, eta, moments);
  CHECK(moments[0] == Approx(2.0 * n_lanes * 2.0));
  CHECK(moments[1] == Approx(2.0 * n_lanes * 1.0));
  CHECK(moments[2] == Approx(-2.0 * n_lanes * 0.5));
  CHECK(moments[3] == Approx(-2.0 * n_lanes * 0.25));
}
