// SPDX-License-Identifier: BSD-3-Clause
// Points of integration over the overlap of two surfaces, and the part of it whose gap is within bounds.
#include "contact/smoothing/smooth_overlap_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

MovingFace moving_quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  MovingFace face{FaceCorners::Zero(), FaceCorners::Zero(), false, 0.0};
  face.x << a, b, c, d;
  return face;
}

/// A square of width 2 about the origin that looks up.
MovingFace floor_square() { return moving_quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}); }

/// A square of width 2 about x that looks down; it leans along x.
MovingFace ceiling(double x, double height, double slope = 0.0) {
  const double low = height - slope, high = height + slope;
  return moving_quad({x - 1, -1, low}, {x - 1, 1, low}, {x + 1, 1, high}, {x + 1, -1, high});
}

/// The lowest facet of a cylinder about y of some radius, which touches the floor at the angle 0; its ends
/// lie beyond the floor's.
MovingFace lowest_facet(double radius, double half_angle, double height) {
  const double s = radius * std::sin(half_angle), z = height + radius * (1.0 - std::cos(half_angle));
  return moving_quad({-s, -1, z}, {-s, 1, z}, {s, 1, z}, {s, -1, z});
}

SmoothFace round_about_y(const MovingFace& face, double radius, double height) {
  RoundShape shape;
  shape.axis = Vector3d::UnitY();
  shape.origin = Vector3d(0, 0, height + radius);
  return SmoothFace::make(shape, face.x, face.is_triangle).value();
}

struct PartSum {
  double area = 0.0, first_moment = 0.0, least_gap = no_bound, most_gap = -no_bound;
};

PartSum sum_of(const SmoothOverlap& overlap, const GapBounds& bounds) {
  PartSum sum;
  overlap.visit_part(bounds, [&](double area, const SurfacePairPoint& point) {
    CHECK(area > 0.0);
    sum.area += area;
    sum.first_moment += area * point.middle.x();
    sum.least_gap = std::min(sum.least_gap, point.gap);
    sum.most_gap = std::max(sum.most_gap, point.gap);
  });
  return sum;
}

}  // namespace

TEST_CASE("area and centroid of a polygon by hand", "[contact][smoothing]") {
  PlanePolygon polygon;  // a square with a corner cut off
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(5, 5), Eigen::Vector2d(7, 5), Eigen::Vector2d(7, 6),
                                        Eigen::Vector2d(6, 7), Eigen::Vector2d(5, 7)})
    polygon.add(corner);
  CHECK(polygon.area() == Approx(3.5));
  // 4 (6, 6) less 0.5 (6 + 2/3, 6 + 2/3), over 3.5.
  const double c = (4.0 * 6.0 - 0.5 * (6.0 + 2.0 / 3.0)) / 3.5;
  CHECK((polygon.centroid() - Eigen::Vector2d(c, c)).norm() < 1e-12);
  CHECK(polygon.next(4) == 0);
  CHECK(polygon.next(3) == 4);
}

TEST_CASE("points of flat faces cover their overlap, whichever comes first", "[contact][smoothing]") {
  const bool is_swapped = GENERATE(false, true);
  const double aside = GENERATE(0.0, 0.5, 1.9);
  const MovingFace below = floor_square(), above = ceiling(aside, 0.1);
  const SmoothPatch low(below, nullptr), high(above, nullptr);
  const SmoothOverlap overlap(is_swapped ? SmoothSides{low, high} : SmoothSides{high, low}, 0.0);
  REQUIRE(overlap.has_area());
  CHECK((overlap.plane().normal - Vector3d(0, 0, is_swapped ? -1 : 1)).norm() < 1e-12);
  const PartSum all = sum_of(overlap, {-no_bound, no_bound});
  CHECK(all.area == Approx(2.0 * (2.0 - aside)));
  CHECK(all.first_moment / all.area == Approx(0.5 * aside).margin(1e-12));
  CHECK(all.least_gap == Approx(0.1));
  CHECK(all.most_gap == Approx(0.1));
  CHECK(overlap.may_hold({0.0, 0.11}));
  CHECK_FALSE(overlap.may_hold({-1.0, 0.09}));
  CHECK_FALSE(overlap.may_hold({0.11, 1.0}));
  const SmoothOverlap shifted({high, low, 0.03}, 0.0);
  CHECK(sum_of(shifted, {-no_bound, no_bound}).least_gap == Approx(0.07));
  CHECK(shifted.may_hold({0.0, 0.08}));
}

TEST_CASE("faces that look the same way or lie beside each other have no overlap", "[contact][smoothing]") {
  const MovingFace below = floor_square(), beside = ceiling(2.0, 0.1), same = floor_square();
  const SmoothPatch low(below, nullptr), other(beside, nullptr), also_up(same, nullptr);
  CHECK_FALSE(SmoothOverlap({low, other}, 0.0).has_area());
  CHECK_FALSE(SmoothOverlap({low, also_up}, 0.0).has_area());
  CHECK(sum_of(SmoothOverlap({low, other}, 0.0), {-no_bound, no_bound}).area == 0.0);
}

TEST_CASE("of a wedge the part within bounds is cut where the gap has them", "[contact][smoothing]") {
  const MovingFace below = floor_square(), above = ceiling(0.0, 0.02, 0.1);  // gap 0.02 + 0.1 x
  const SmoothPatch low(below, nullptr), high(above, nullptr);
  const SmoothOverlap overlap({high, low}, 0.0);
  const double whole = sum_of(overlap, {-no_bound, no_bound}).area;
  CHECK(whole == Approx(4.0).epsilon(0.01));
  // Open from x = -0.2 on; seen along a normal that leans by half the slope.
  CHECK(sum_of(overlap, {-no_bound, 0.0}).area / whole == Approx(0.4).epsilon(0.01));
  CHECK(sum_of(overlap, {0.0, no_bound}).area / whole == Approx(0.6).epsilon(0.01));
  CHECK(sum_of(overlap, {0.0, 0.05}).area / whole == Approx(0.25).epsilon(0.01));
  const PartSum behind = sum_of(overlap, {-no_bound, 0.0});
  CHECK(behind.first_moment / behind.area == Approx(-0.6).epsilon(0.02));
  CHECK(behind.most_gap < 1e-9);
}

TEST_CASE("bounds are of the gap at the end of the time ahead", "[contact][smoothing]") {
  const MovingFace below = floor_square();
  MovingFace above = ceiling(0.0, 0.1);
  above.v.row(2).setConstant(-2.0);
  const SmoothPatch low(below, nullptr), high(above, nullptr);
  const SmoothOverlap now({high, low}, 0.0), ahead({high, low}, 0.06);
  CHECK(sum_of(now, {-no_bound, 0.0}).area == 0.0);
  const PartSum closing = sum_of(ahead, {-no_bound, 0.0});
  CHECK(closing.area == Approx(4.0));
  CHECK(closing.most_gap == Approx(0.1));  // that of now
  CHECK(sum_of(SmoothOverlap({low, high}, 0.06), {-no_bound, 0.0}).area == Approx(4.0));
  CHECK(sum_of(SmoothOverlap({high, low}, 0.04), {-no_bound, 0.0}).area == 0.0);
}

TEST_CASE("a cylinder above a floor has the gap of its circle, and the area of its arc",
          "[contact][smoothing]") {
  const double radius = 2.0, half_angle = std::numbers::pi / 12.0, height = GENERATE(0.03, -0.01);
  const MovingFace below = floor_square(), facet = lowest_facet(radius, half_angle, height);
  const SmoothFace round = round_about_y(facet, radius, height);
  const SmoothPatch low(below, nullptr), high(facet, &round);
  const SmoothOverlap overlap({high, low}, 0.0);
  PartSum all;
  overlap.visit_part({-no_bound, no_bound}, [&](double area, const SurfacePairPoint& point) {
    const double x = point.middle.x(), rise = height + radius - std::sqrt(radius * radius - x * x);
    // Along the mean of both normals, which leans by half of the circle's angle there.
    const double cosine = std::cos(0.5 * std::asin(x / radius));
    CHECK(point.gap == Approx(cosine * rise).epsilon(1e-6).margin(1e-9));
    CHECK(point.normal.dot(Vector3d::UnitZ()) == Approx(cosine).epsilon(1e-9));
    CHECK(std::abs(point.middle.z() - 0.5 * rise) < 1e-6);
    all.area += area;
  });
  // The floor's width times the integral of 1 / cosine over what the circle covers, a bit less than its arc.
  double integral = 0.0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double x = radius * std::sin(half_angle) * (2.0 * (i + 0.5) / n - 1.0);
    integral += 2.0 * radius * std::sin(half_angle) / n / std::cos(0.5 * std::asin(x / radius));
  }
  CHECK(all.area == Approx(2.0 * integral).epsilon(1e-4));
  // What is closer than a bound: |x| < sqrt(r^2 - (r + height - gap)^2), where the lean hardly matters.
  const double bound = 0.035, reach = std::sqrt(radius * radius - std::pow(radius + height - bound, 2));
  CHECK(sum_of(overlap, {-no_bound, bound}).area == Approx(2.0 * 2.0 * reach).epsilon(0.01));
}
