// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/edge_edge.hpp"

#include <random>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

Segment segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Segment made;
  made << a, b;
  return made;
}

double distance(const Segment& first, double s, const Segment& second, double t) {
  return ((1 - s) * first.col(0) + s * first.col(1) - (1 - t) * second.col(0) - t * second.col(1)).norm();
}

/// By looking at many places along both.
double slow_distance(const Segment& first, const Segment& second) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 200; ++i) {
    for (int j = 0; j <= 200; ++j) least = std::min(least, distance(first, i / 200.0, second, j / 200.0));
  }
  return least;
}

}  // namespace

TEST_CASE("the nearest points of two segments are the nearest", "[contact][edge_edge]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto point = [&] { return Eigen::Vector3d(any(random), any(random), 0.3 * any(random)); };
  for (int i = 0; i < 200; ++i) {
    const Segment first = segment(point(), point());
    const Segment second =
        i % 5 == 0 ? segment(point(), point()).col(0).replicate<1, 2>() : segment(point(), point());
    const EdgePairPoint pair_point = nearest_points(first, second);
    REQUIRE(pair_point.s >= 0.0);
    REQUIRE(pair_point.s <= 1.0);
    REQUIRE(pair_point.t >= 0.0);
    REQUIRE(pair_point.t <= 1.0);
    const double found = distance(first, pair_point.s, second, pair_point.t),
                 slow = slow_distance(first, second);
    CHECK(found <= slow + 1e-12);
    CHECK(found >= slow - 0.02);
  }
}

TEST_CASE("two points are as far apart as they are", "[contact][edge_edge]") {
  const Eigen::Vector3d a(1, 2, 3), b(1, 2, 5);
  const EdgePairPoints places(segment(a, a), segment(b, b));
  REQUIRE(places.get().size() == 1);
  CHECK(distance(segment(a, a), places.get()[0].s, segment(b, b), places.get()[0].t) == 2.0);
}

TEST_CASE("crossing segments meet in one place, parallel ones along the part that they share",
          "[contact][edge_edge]") {
  const Segment first = segment({0, 0, 0}, {4, 0, 0});
  const EdgePairPoints crossing(first, segment({1, -1, 0.5}, {1, 1, 0.5}));
  REQUIRE(crossing.get().size() == 1);
  CHECK(crossing.get()[0].s == Approx(0.25));
  CHECK(crossing.get()[0].t == Approx(0.5));
  CHECK(crossing.get()[0].length == 0.0);
  const EdgePairPoints along(first, segment({5, 0, 1}, {1, 0, 1}));
  REQUIRE(along.get().size() == 2);
  CHECK(along.get()[0].s == Approx(0.25));
  CHECK(along.get()[0].t == Approx(1.0));
  CHECK(along.get()[1].s == Approx(1.0));
  CHECK(along.get()[1].t == Approx(0.25));
  CHECK(along.get()[0].length + along.get()[1].length == Approx(3.0));
  // Parallel, but one after the other.
  CHECK(EdgePairPoints(first, segment({5, 0, 1}, {6, 0, 1})).get().size() == 1);
}

TEST_CASE("a place next to a node by round-off is at the node", "[contact][edge_edge]") {
  Segment along_x, along_y;
  along_x << 0.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  for (const double off : {1e-16, -1e-16, 1e-12, 0.0}) {
    along_y << off, off, -1.0, 1.0, 0.1, 0.1;
    CHECK(nearest_points(along_x, along_y).s == 0.0);
    along_y.row(0).array() += 1.0;
    CHECK(nearest_points(along_x, along_y).s == 1.0);
  }
  along_y << 1e-6, 1e-6, -1.0, 1.0, 0.1, 0.1;
  CHECK(nearest_points(along_x, along_y).s == Approx(1e-6));
}
