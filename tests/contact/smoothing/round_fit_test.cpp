// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/round_fit.hpp"

#include <Eigen/Geometry>
#include <functional>
#include <numbers>

#include "contact/geometry/face_map.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

using Surface = std::function<Vector3d(double u, double v)>;

/// A grid of quadrilaterals, or of triangles, over 0 <= u, v <= 1.
SurfacePart grid(const Surface& at, int n_u, int n_v, bool has_triangles = false) {
  SurfacePart part;
  const auto node = [&](int i, int j) {
    return at(static_cast<double>(i) / n_u, static_cast<double>(j) / n_v);
  };
  const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    part.areas.push_back(area_vector(a, b, c, d));
    part.centres.push_back(c == d ? Vector3d((a + b + c) / 3.0) : Vector3d((a + b + c + d) / 4.0));
  };
  for (int i = 0; i <= n_u; ++i) {
    for (int j = 0; j <= n_v; ++j) part.nodes.push_back(node(i, j));
  }
  for (int i = 0; i < n_u; ++i) {
    for (int j = 0; j < n_v; ++j) {
      const Vector3d a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
      if (has_triangles) {
        add(a, b, c, c);
        add(a, c, d, d);
      } else {
        add(a, b, c, d);
      }
    }
  }
  return part;
}

Eigen::Isometry3d askew(double scale) {
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  placed.rotate(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  placed.translation() = scale * Vector3d(3, -2, 5);
  return placed;
}

/// A part of an elliptic cylinder, a cone and a torus.
Vector3d barrel(double radius_x, double radius_y, double cone, double u, double v) {
  const double angle = 1.6 * u, wide = 1.0 + cone * v;
  return {wide * radius_x * std::cos(angle), wide * radius_y * std::sin(angle), 0.7 * v};
}
Vector3d torus(double ring, double tube, double u, double v) {
  const double a = 1.2 * u, b = 0.3 + 1.4 * v, r = ring + tube * std::cos(b);
  return {r * std::cos(a), r * std::sin(a), tube * std::sin(b)};
}
Vector3d sphere(double radius, double u, double v) {
  return radius * Vector3d(std::cos(1.3 * u) * std::cos(v), std::sin(1.3 * u) * std::cos(v), std::sin(v));
}

constexpr double two = 2.0;

}  // namespace

TEST_CASE("a cylinder, a sphere and a torus are found by their nodes", "[contact][smoothing]") {
  const double size = GENERATE(1.0, 1e-3, 1e3);
  const bool has_triangles = GENERATE(false, true);
  const Eigen::Isometry3d placed = askew(size);
  const auto fit = [&](const Surface& at) {
    const PartFit found = fit_part(
        grid([&](double u, double v) { return Vector3d(placed * (size * at(u, v))); }, 8, 6, has_triangles));
    CHECK_FALSE(found.is_flat);
    REQUIRE(found.shape);
    CHECK(found.shape->residual < 1e-6 * size);
    return *found.shape;
  };
  const FittedShape round = fit([](double u, double v) { return barrel(two, two, 0.0, u, v); });
  CHECK(round.shape.kind == RoundShape::Kind::circumferential);
  CHECK(round.radius == Approx(2.0 * size));
  CHECK(std::abs(round.shape.axis.dot(placed.linear().col(2))) == Approx(1.0));
  CHECK(round.shape.radius_of(placed.translation()) < 1e-6 * size);

  const FittedShape ball = fit([](double u, double v) { return sphere(two, u, v); });
  CHECK(ball.shape.kind == RoundShape::Kind::spherical);
  CHECK(ball.radius == Approx(2.0 * size));
  CHECK((ball.shape.origin - placed.translation()).norm() < 1e-6 * size);

  const FittedShape tyre = fit([](double u, double v) { return torus(3.0, 1.0, u, v); });
  CHECK(tyre.shape.kind == RoundShape::Kind::toroidal);
  CHECK(tyre.radius == Approx(size));
  CHECK(tyre.shape.arc_radius == Approx(3.0 * size));
  CHECK((tyre.shape.origin - placed.translation()).norm() < 1e-5 * size);
}

TEST_CASE("planes, cones and ellipses are not round", "[contact][smoothing]") {
  const PartFit plane = fit_part(grid([](double u, double v) { return Vector3d(u, v, 0.0); }, 4, 4));
  CHECK(plane.is_flat);
  CHECK_FALSE(plane.shape);

  const PartFit cone = fit_part(grid([](double u, double v) { return barrel(two, two, 0.3, u, v); }, 8, 6));
  CHECK_FALSE(cone.is_flat);
  CHECK_FALSE(cone.shape);
  CHECK(cone.least_residual > largest_residual);

  // A band of one row of faces: its nodes are on a sphere.
  CHECK_FALSE(fit_part(grid([](double u, double v) { return barrel(two, two, 0.3, u, v); }, 8, 1)).shape);
  CHECK(fit_part(grid([](double u, double v) { return barrel(two, two, 0.0, u, v); }, 8, 1)).shape);

  const auto ellipse = [](double share) {
    return fit_part(grid([&](double u, double v) { return barrel(two, share * two, 0.0, u, v); }, 8, 6));
  };
  CHECK_FALSE(ellipse(1.05).shape);
  CHECK(ellipse(1.0005).shape);
}

TEST_CASE("a roof of three planes is no cylinder", "[contact][smoothing]") {
  CHECK_FALSE(fit_part(grid([](double u, double v) { return barrel(two, two, 0.0, u, v); }, 3, 3)).shape);
}
