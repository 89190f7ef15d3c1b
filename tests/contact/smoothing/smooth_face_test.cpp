// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/smooth_face.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A facet of a cylinder about z of radius r between two angles, one corner of radius r + more.
FaceCorners facet(double r, double from, double to, double more = 0.0) {
  FaceCorners x;
  x << (r + more) * std::cos(from), r * std::cos(to), r * std::cos(to), r * std::cos(from),
      (r + more) * std::sin(from), r * std::sin(to), r * std::sin(to), r * std::sin(from), 0.0, 0.0, 1.0, 1.0;
  return x;
}

RoundShape shape_of(RoundShape::Kind kind, double arc_radius = 0.0) {
  RoundShape shape;
  shape.kind = kind;
  shape.arc_radius = arc_radius;
  return shape;
}

constexpr double eighth = std::numbers::pi / 8.0;

}  // namespace

TEST_CASE("a round surface rises over a facet by the sagitta and not at all at its corners",
          "[contact][smoothing]") {
  const FaceCorners x = facet(2.0, -eighth, eighth);
  const auto smooth = SmoothFace::make(RoundShape{}, x, false);
  REQUIRE(smooth);
  const double sagitta = 2.0 * (1.0 - std::cos(eighth));
  CHECK(smooth->height() == Approx(sagitta));
  CHECK(smooth->lean() == Approx(std::tan(eighth)));
  CHECK(smooth->rise_at(0.0, 0.3).value.z() == Approx(sagitta));
  for (const double xi : {-1.0, 1.0}) CHECK(smooth->rise_at(xi, 1.0).value.norm() < 1e-14);
  const MovingFace face{x, FaceCorners::Zero(), false, 0.0};
  const SmoothPatch patch(face, &*smooth);
  for (const double xi : {-0.8, 0.1, 0.9}) {
    const SmoothPatch::Point point = patch.at(xi, -0.2);
    const Vector3d out(point.on_face.x(), point.on_face.y(), 0.0);
    CHECK(point.x.head<2>().norm() == Approx(2.0));
    CHECK(point.normal().dot(out.normalized()) == Approx(1.0));
  }
}

TEST_CASE("the derivatives of a round surface are those of differences", "[contact][smoothing]") {
  const FaceCorners x = facet(2.0, 0.2, 0.7, 0.1);
  using Kind = RoundShape::Kind;
  for (const RoundShape& shape :
       {shape_of(Kind::circumferential), shape_of(Kind::spherical), shape_of(Kind::toroidal, 1.2)}) {
    const auto smooth = SmoothFace::make(shape, x, false);
    REQUIRE(smooth);
    constexpr double h = 1e-6;
    const FaceVector at = smooth->rise_at(0.3, -0.4);
    const Vector3d by_xi =
        (smooth->rise_at(0.3 + h, -0.4).value - smooth->rise_at(0.3 - h, -0.4).value) / (2 * h);
    const Vector3d by_eta =
        (smooth->rise_at(0.3, -0.4 + h).value - smooth->rise_at(0.3, -0.4 - h).value) / (2 * h);
    CHECK((at.by_xi - by_xi).norm() < 1e-8);
    CHECK((at.by_eta - by_eta).norm() < 1e-8);
  }
}

TEST_CASE("a round surface turns along with its face", "[contact][smoothing]") {
  const FaceCorners x = facet(2.0, 0.2, 0.7);
  const auto smooth = SmoothFace::make(RoundShape{}, x, false);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.rotate(Eigen::AngleAxisd(2.1, Vector3d(1, -1, 2).normalized()));
  moved.translation() = Vector3d(5, 6, 7);
  const MovingFace before{x, FaceCorners::Zero(), false, 0.0},
      after{moved * x, FaceCorners::Zero(), false, 0.0};
  const auto a = SmoothPatch(before, &*smooth).at(0.4, 0.1), b = SmoothPatch(after, &*smooth).at(0.4, 0.1);
  CHECK((moved * a.x - b.x).norm() < 1e-13);
  CHECK((moved.linear() * a.normal() - b.normal()).norm() < 1e-13);
}

TEST_CASE("a node has its gap to the cylinder, along the cylinder's normal", "[contact][smoothing]") {
  const bool looks_out = GENERATE(true, false);
  FaceCorners x = facet(2.0, -eighth, eighth);
  if (!looks_out) x.col(1).swap(x.col(3));
  const auto smooth = SmoothFace::make(RoundShape{}, x, false);
  REQUIRE(smooth);
  for (const double angle : {-0.3, 0.0, 0.1, 0.38}) {
    for (const double gap : {-0.05, 0.0, 1e-3, 0.2}) {
      const double radius = looks_out ? 2.0 + gap : 2.0 - gap;
      const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
      const Vector3d point = radius * out + 0.4 * Vector3d::UnitZ();
      const auto found = project_sphere(x, false, &*smooth, point, 0.0);
      REQUIRE(found);
      CHECK(found->gap == Approx(gap).margin(1e-9));
      CHECK(std::abs(found->normal.dot(out)) == Approx(1.0));
      CHECK_FALSE(found->edge);
      // No moment: the point of the face below is on the line of the force.
      const Vector3d below = x * corner_weights(found->xi, found->eta, false);
      CHECK((point - below).cross(found->normal).norm() < 1e-9);
    }
  }
}

TEST_CASE("neighbours part their nodes at the edge, however deep", "[contact][smoothing]") {
  const FaceCorners left = facet(2.0, eighth, 0.0), right = facet(2.0, 0.0, -eighth);
  const auto of_left = SmoothFace::make(RoundShape{}, left, false);
  const auto of_right = SmoothFace::make(RoundShape{}, right, false);
  REQUIRE((of_left && of_right));
  for (const double radius : {1.7, 1.99, 2.0, 2.1, 2.6}) {
    for (const double angle : {0.01, -0.01}) {
      const Vector3d point(radius * std::cos(angle), radius * std::sin(angle), 0.5);
      const auto on_left = project_sphere(left, false, &*of_left, point, 0.0);
      const auto on_right = project_sphere(right, false, &*of_right, point, 0.0);
      REQUIRE((on_left && on_right));
      CHECK(!on_left->edge == (angle > 0.0));
      CHECK(!on_right->edge == (angle < 0.0));
    }
  }
}

TEST_CASE("the way out of a cone is square to it, and leaves no moment", "[contact][smoothing]") {
  // Radius 2 - z, twelve facets round.
  const double half = std::numbers::pi / 12.0;
  FaceCorners x = facet(2.0, -half, half);
  x.rightCols<2>().topRows<2>() *= 0.5;
  const auto smooth = SmoothFace::make(RoundShape{}, x, false);
  REQUIRE(smooth);
  const double root = std::sqrt(0.5), gap = 0.01;
  const Vector3d out(std::cos(0.1), std::sin(0.1), 0.0), normal = root * (out + Vector3d::UnitZ());
  const Vector3d point = 1.6 * out + 0.4 * Vector3d::UnitZ() + gap * normal;
  const auto found = project_sphere(x, false, &*smooth, point, 0.0);
  REQUIRE(found);
  CHECK(found->gap == Approx(gap).epsilon(1e-6));
  CHECK(found->normal.dot(normal) == Approx(1.0));
  CHECK((point - x * corner_weights(found->xi, found->eta, false)).cross(found->normal).norm() < 1e-9);
}

TEST_CASE("faces that look along the axis stand for themselves", "[contact][smoothing]") {
  FaceCorners x;
  x << 1.0, 2.0, 2.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  CHECK_FALSE(SmoothFace::make(RoundShape{}, x, false));
  x.col(0).setZero();  // a disc's corner on the axis
  CHECK_FALSE(SmoothFace::make(RoundShape{}, x, false));
}
