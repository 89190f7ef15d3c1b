// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/overlap_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/projected_overlap.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Overlap = ProjectedOverlap;

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

TEST_CASE("the overlap of two squares is a rectangle", "[contact][overlap_polygons]") {
  const Overlap found(make_square(0.0, 0.0, true), make_square(0.25, 0.1, false));
  CHECK(found.points.area == Approx(0.75).epsilon(1e-14));
  // Quadratic polynomials are integrated exactly over a 0.75 x 1 rectangle, seen from its middle.
  const CommonPlane& plane = found.pair.plane;
  const Eigen::Vector3d middle = Eigen::Vector3d(0.625, 0.5, 0.0) - plane.origin;
  const Eigen::Vector3d m(plane.across.dot(middle), plane.along.dot(middle), plane.normal.dot(middle));
  const auto of = [&](const auto& f) {
    return found.sum([&](const Eigen::Vector3d& x, const Eigen::Vector3d&) { return f(x - m); });
  };
  CHECK(of([](const Eigen::Vector3d&) { return 1.0; }) == Approx(0.75).epsilon(1e-14));
  CHECK(of([](const Eigen::Vector3d& x) { return x.x(); }) == Approx(0.0).margin(1e-15));
  CHECK(of([](const Eigen::Vector3d& x) { return x.y(); }) == Approx(0.0).margin(1e-15));
  const double polar = 0.75 * (0.75 * 0.75 + 1.0) / 12.0;
  CHECK(of([](const Eigen::Vector3d& x) { return x.head<2>().squaredNorm(); }) == Approx(polar));
}

TEST_CASE("overlaps of random faces have the area of a sweep in strips", "[contact][overlap_polygons]") {
  Random random(3);
  double total = 0.0;
  for (int i = 0; i < 60; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.0);
    const Overlap found(a, b);
    const double slow = area_in_strips(found.pair.first, found.pair.second);
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

TEST_CASE("points of an overlap lie above each other on both faces, and on both",
          "[contact][overlap_polygons]") {
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

TEST_CASE("a face inside another one overlaps wholly, faces side by side do not",
          "[contact][overlap_polygons]") {
  const MovingFace floor = make_square(0.0, 0.0, true);
  MovingFace small = make_square(0.25, 0.0, false, 0.5);
  small.x.row(1).array() += 0.25;
  CHECK(Overlap(floor, small).points.area == Approx(0.25));
  CHECK(Overlap(small, floor).points.area == Approx(0.25));
  CHECK(Overlap(floor, make_square(0.0, 0.0, false)).points.area == Approx(1.0));
  CHECK(Overlap(floor, make_square(1.0, 0.0, false)).points.area == Approx(0.0).margin(1e-15));
  CHECK(Overlap(floor, make_square(1.5, 0.0, false)).points.area == 0.0);
}

TEST_CASE("a polygon is cut where the gap leaves its bounds", "[contact][overlap_polygons]") {
  // The gap goes from 0.1 at x = 0 to 0.3 at x = 1.
  MovingFace upper = make_square(0.0, 0.2, false);
  upper.x.row(2) += 0.2 * (upper.x.row(0).array() - 0.5).matrix();
  Overlap found(upper, make_square(0.0, 0.0, true));
  found.polygons.set_gaps(found.pairs);
  const double whole = found.area();
  const auto share = [&](double least, double most) {
    return std::max(0.0, found.polygons.part_between(least, most).area()(0) / whole);
  };
  CHECK(share(-1.0, 1.0) == Approx(1.0));
  CHECK(share(-1.0, 0.2) == Approx(0.5).epsilon(0.05));
  CHECK(share(-1.0, 0.2) + share(0.2, 1.0) == Approx(1.0));
  CHECK(share(0.15, 0.25) + share(-1.0, 0.15) + share(0.25, 1.0) == Approx(1.0));
  CHECK(share(-1.0, 0.05) == 0.0);
  CHECK(share(0.35, 1.0) == 0.0);
}

TEST_CASE("gaps at the corners of an overlap are those of the faces, warped or not",
          "[contact][overlap_polygons]") {
  Random random(5);
  int n_found = 0;
  for (int i = 0; i < 20; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.2);
    const Overlap found(a, b);
    const OverlapPolygon polygon = found.polygons.of(0);
    // Corners of the first face that the second one covers are corners of the overlap.
    for (int k = 0; k < polygon.n; ++k) {
      for (int c = 0; c < 4; ++c) {
        const Eigen::Vector3d x = found.pair.first.col(c);
        if (std::hypot(x.x() - polygon.u[k], x.y() - polygon.v[k]) > 1e-12) continue;
        const double gap = locate_on_both(found.pairs.maps_1, found.pairs.maps_2, x.x(), x.y()).gap(0);
        CHECK(gap + height_over(found.pair.second, b.is_triangle, x) == Approx(x.z()).margin(1e-12));
        ++n_found;
      }
    }
  }
  CHECK(n_found > 10);
}

TEST_CASE("polygons of eight pairs are those of each pair alone", "[contact][overlap_polygons]") {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    auto [first, second] = random_pairs(random, i, 0.04, 0.06);
    second[3].x.row(0).array() += 5.0;  // beside the first
    std::vector<FacePair> pairs;
    for (std::size_t k = 0; k < n_lanes; ++k) pairs.push_back({&first[k], &second[k]});
    const ProjectedPairs projected(pairs);
    const LaneMask wanted = !first_lanes(1);
    OverlapPolygons all(projected, wanted);
    all.set_gaps(projected);
    const OverlapPolygons parts = all.part_between(-0.07, -0.03);
    CHECK(all.of(0).n == 0);
    CHECK_FALSE(all.area()(3) > 0.0);
    for (std::size_t k = 1; k < n_lanes; ++k) {
      const auto lane = static_cast<Eigen::Index>(k);
      Overlap alone(first[k], second[k]);
      alone.polygons.set_gaps(alone.pairs);
      CHECK(all.area()(lane) == alone.area());
      CHECK(parts.area()(lane) == alone.polygons.part_between(-0.07, -0.03).area()(0));
      const OverlapPolygon polygon = all.of(lane), expected = alone.polygons.of(0);
      REQUIRE(polygon.n == expected.n);
      for (int c = 0; c < polygon.n; ++c) {
        CHECK(polygon.u[c] == expected.u[c]);
        CHECK(polygon.v[c] == expected.v[c]);
      }
    }
  }
}

TEST_CASE("polygons are taken over where something holds", "[contact][overlap_polygons]") {
  const std::array<DoubleVectors, 3> small{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}}},
      large{{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 1.0}}};
  OverlapPolygons polygons(small);
  polygons.set_where(first_lanes(2), OverlapPolygons(large));
  CHECK(polygons.area()(1) == 2.0);
  CHECK(polygons.area()(2) == 0.5);
  CHECK(polygons.part_between(0.5, 2.0).area()(7) == 0.125);
}
