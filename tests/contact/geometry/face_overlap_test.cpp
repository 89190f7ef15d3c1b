// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_overlap.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two faces on their common plane with what they have in common.
struct Overlap {
  CommonPlane plane;
  FaceCorners first, second;
  FaceMap map_1, map_2;
  OverlapPolygon polygon;
  OverlapPoints points;

  Overlap(const MovingFace& a, const MovingFace& b)
      : plane(make_common_plane(a.x, a.look(), b.look()).value()),
        first(project(a.x, plane)),
        second(project(b.x, plane)),
        map_1(make_face_map(first, a.is_triangle)),
        map_2(make_face_map(second, b.is_triangle)),
        polygon(intersect(first, a.is_triangle, second, b.is_triangle)) {
    if (polygon.has_area()) place_points(polygon, map_1, map_2, points);
  }

  /// The sum of a function of the place on the first face over the points.
  template <class F>
  double sum(const F& f) const {
    double total = 0.0;
    for (const OverlapBatch& batch : points.batches()) {
      for (int lane = 0; lane < n_lanes; ++lane) {
        total += batch.weight(lane) * f(map_1.at(batch.xi_1(lane), batch.eta_1(lane)),
                                        map_2.at(batch.xi_2(lane), batch.eta_2(lane)));
      }
    }
    return total;
  }
};

/// The height of a face at the place of a point, by Newton's method.
double height_over(const FaceCorners& face, bool is_triangle, const Eigen::Vector3d& at) {
  const FaceMap map = make_face_map(face, is_triangle);
  Eigen::Vector2d entity = Eigen::Vector2d::Zero();
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d by_xi = map.c[1] + entity[1] * map.c[3], by_eta = map.c[2] + entity[0] * map.c[3];
    Eigen::Matrix2d slope;
    slope << by_xi.head<2>(), by_eta.head<2>();
    entity += slope.inverse() * (at - map.at(entity[0], entity[1])).head<2>();
  }
  return map.at(entity[0], entity[1]).z();
}

/// Where a line of constant v meets a convex face: its ends in u, the first above the second if it does not.
std::array<double, 2> chord(const FaceCorners& face, double v) {
  double low = 1e300, high = -1e300;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d a = face.col(k), b = face.col((k + 1) % 4);
    if ((a.y() <= v) == (b.y() <= v)) continue;
    const double u = a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    low = std::min(low, u);
    high = std::max(high, u);
  }
  return {low, high};
}

/// The overlap's area, strip by strip.
double area_in_strips(const FaceCorners& first, const FaceCorners& second) {
  constexpr int n = 4000;
  const double low = first.row(1).minCoeff(), height = (first.row(1).maxCoeff() - low) / n;
  double area = 0.0;
  for (int i = 0; i < n; ++i) {
    const auto a = chord(first, low + (i + 0.5) * height), b = chord(second, low + (i + 0.5) * height);
    area += height * std::max(0.0, std::min(a[1], b[1]) - std::max(a[0], b[0]));
  }
  return area;
}

}  // namespace

TEST_CASE("the overlap of two squares is a rectangle", "[contact][face_overlap]") {
  const Overlap found(make_square(0.0, 0.0, true), make_square(0.25, 0.1, false));
  CHECK(found.points.area == Approx(0.75).epsilon(1e-14));
  // Quadratic polynomials are integrated exactly over a 0.75 x 1 rectangle, seen from its middle.
  const Eigen::Vector3d middle(0.625, 0.5, 0.0);
  const Eigen::Vector3d m = project(middle.replicate<1, 4>(), found.plane).col(0);
  const auto of = [&](const auto& f) {
    return found.sum([&](const Eigen::Vector3d& x, const Eigen::Vector3d&) { return f(x - m); });
  };
  CHECK(of([](const Eigen::Vector3d&) { return 1.0; }) == Approx(0.75).epsilon(1e-14));
  CHECK(of([](const Eigen::Vector3d& x) { return x.x(); }) == Approx(0.0).margin(1e-15));
  CHECK(of([](const Eigen::Vector3d& x) { return x.y(); }) == Approx(0.0).margin(1e-15));
  const double polar = 0.75 * (0.75 * 0.75 + 1.0) / 12.0;
  CHECK(of([](const Eigen::Vector3d& x) { return x.head<2>().squaredNorm(); }) == Approx(polar));
}

TEST_CASE("overlaps of random faces have the area of a sweep in strips", "[contact][face_overlap]") {
  Random random(3);
  double total = 0.0;
  for (int i = 0; i < 60; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.0);
    const Overlap found(a, b);
    const double slow = area_in_strips(found.first, found.second);
    total += slow;
    CHECK(found.points.area ==
          Approx(slow).margin(2e-5));  // strips of 1/4000, an end of which may be all edge
    CHECK(found.sum([](const auto&, const auto&) { return 1.0; }) == Approx(found.points.area));
    CHECK(Overlap(b, a).points.area == Approx(found.points.area).epsilon(1e-12));
    CHECK(Overlap(renumbered(a), b).points.area == Approx(found.points.area).epsilon(1e-12));
    CHECK(Overlap(a, renumbered(b)).points.area == Approx(found.points.area).epsilon(1e-12));
  }
  CHECK(total > 15.0);
}

TEST_CASE("points of an overlap lie above each other on both faces, and on both", "[contact][face_overlap]") {
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.1);
    const Overlap found(a, b);
    CHECK(found.sum([](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
      return (x - y).head<2>().norm();
    }) < 1e-12);
    for (const OverlapBatch& batch : found.points.batches()) {
      for (int lane = 0; lane < n_lanes; ++lane) {
        if (batch.weight(lane) == 0.0) continue;
        CHECK(corner_weights(batch.xi_1(lane), batch.eta_1(lane), a.is_triangle).minCoeff() > -1e-10);
      }
    }
  }
}

TEST_CASE("a face inside another one overlaps wholly, faces side by side do not", "[contact][face_overlap]") {
  const MovingFace floor = make_square(0.0, 0.0, true);
  MovingFace small = make_square(0.25, 0.0, false, 0.5);
  small.x.row(1).array() += 0.25;
  CHECK(Overlap(floor, small).points.area == Approx(0.25));
  CHECK(Overlap(small, floor).points.area == Approx(0.25));
  CHECK(Overlap(floor, make_square(0.0, 0.0, false)).points.area == Approx(1.0));
  CHECK(Overlap(floor, make_square(1.0, 0.0, false)).points.area == Approx(0.0).margin(1e-15));
  CHECK(Overlap(floor, make_square(1.5, 0.0, false)).points.area == 0.0);
}

TEST_CASE("a polygon is cut where the gap leaves its bounds", "[contact][face_overlap]") {
  // The gap goes from 0.1 at x = 0 to 0.3 at x = 1.
  MovingFace upper = make_square(0.0, 0.2, false);
  upper.x.row(2) += 0.2 * (upper.x.row(0).array() - 0.5).matrix();
  Overlap found(upper, make_square(0.0, 0.0, true));
  set_gaps(found.map_1, found.map_2, found.polygon);
  const double whole = found.polygon.area();
  const auto share = [&](double least, double most) {
    std::array<OverlapPolygon, 2> scratch;
    const OverlapPolygon& part = part_between(least, most, found.polygon, scratch);
    return part.has_area() ? part.area() / whole : 0.0;
  };
  CHECK(share(-1.0, 1.0) == Approx(1.0));
  CHECK(share(-1.0, 0.2) == Approx(0.5).epsilon(0.05));
  CHECK(share(-1.0, 0.2) + share(0.2, 1.0) == Approx(1.0));
  CHECK(share(0.15, 0.25) + share(-1.0, 0.15) + share(0.25, 1.0) == Approx(1.0));
  CHECK(share(-1.0, 0.05) == 0.0);
  CHECK(share(0.35, 1.0) == 0.0);
}

TEST_CASE("gaps at the corners of an overlap are those of the faces, warped or not",
          "[contact][face_overlap]") {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.2);
    Overlap found(a, b);
    set_gaps(found.map_1, found.map_2, found.polygon);
    // Corners of the first face that the second one covers are corners of the overlap.
    for (int k = 0; k < found.polygon.n; ++k) {
      for (int c = 0; c < 4; ++c) {
        const Eigen::Vector3d x = found.first.col(c);
        if (std::hypot(x.x() - found.polygon.u[k], x.y() - found.polygon.v[k]) > 1e-12) continue;
        CHECK(found.polygon.gap[k] + height_over(found.second, b.is_triangle, x) ==
              Approx(x.z()).margin(1e-12));
      }
    }
  }
}

TEST_CASE("points for products integrate the fourth degree", "[contact][face_overlap]") {
  MovingFace first, second;
  first.x << 0, 0, 2, 2, 0, 3, 3, 0, 0, 0, 0, 0;         // seen from below
  second.x << 0.5, 3, 3, 0.5, -1, -1, 2, 2, 0, 0, 0, 0;  // in common: 0.5 to 2 and 0 to 2
  Overlap overlap(first, second);
  REQUIRE(overlap.polygon.area() == Approx(3.0));
  place_points_for_products(overlap.polygon, overlap.map_1, overlap.map_2, overlap.points);
  const auto on_first = [&](const Eigen::Vector3d& at) {
    return Eigen::Vector3d(overlap.plane.origin + at.x() * overlap.plane.across +
                           at.y() * overlap.plane.along);
  };
  const double found = overlap.sum([&](const Eigen::Vector3d& at, const Eigen::Vector3d& /*on_second*/) {
    const Eigen::Vector3d x = on_first(at);
    return x.x() * x.x() * x.y() * x.y() + x.x() * x.x() * x.x() * x.y();
  });
  const double exact = (8.0 - 0.125) / 3.0 * 8.0 / 3.0 + (16.0 - 0.0625) / 4.0 * 2.0;
  CHECK(found == Approx(exact).epsilon(1e-12));
}
