// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/smooth_overlap.hpp"

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

constexpr double width = 0.2, stiffness = 1e6, interference = 1e-3;

/// The facets of a ring about z, whose normals look away from the axis or towards it. With a slope it is a
/// part of a cone.
std::vector<MovingFace> ring(int n, double radius, bool looks_out, double turn, double slope = 0.0) {
  std::vector<MovingFace> faces;
  const auto at = [&](int k, double z) {
    const double angle = turn + 2.0 * std::numbers::pi * k / n, r = radius + slope * z;
    return Vector3d(r * std::cos(angle), r * std::sin(angle), z);
  };
  for (int k = 0; k < n; ++k) {
    const int a = looks_out ? k : k + 1, b = looks_out ? k + 1 : k;
    MovingFace face{FaceCorners::Zero(), FaceCorners::Zero(), false, 360.0 / n};
    face.x << at(a, 0.0), at(b, 0.0), at(b, width), at(a, width);
    faces.push_back(face);
  }
  return faces;
}

MovingFace quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
                bool is_turned = false) {
  MovingFace face{FaceCorners::Zero(), FaceCorners::Zero(), false, 0.0};
  if (is_turned) {
    face.x << a, d, c, b;
  } else {
    face.x << a, b, c, d;
  }
  return face;
}

/// Each of them as two triangles, cut along one diagonal or the other by turns.
std::vector<MovingFace> cut_in_triangles(const std::vector<MovingFace>& quads) {
  std::vector<MovingFace> triangles;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    for (const int half : {0, 2}) {
      const int first = half + static_cast<int>(i % 2);
      const auto corner = [&](int k) { return quads[i].x.col((first + k) % 4); };
      MovingFace face{FaceCorners::Zero(), FaceCorners::Zero(), true, quads[i].sharpness};
      face.x << corner(0), corner(1), corner(2), corner(2);
      triangles.push_back(face);
    }
  }
  return triangles;
}

/// The facets of a sphere: the six sides of a cube of n x n cells, blown up.
std::vector<MovingFace> sphere(int n, double radius, bool looks_out) {
  std::vector<MovingFace> faces;
  const auto grid = [n](int i) { return std::tan(std::numbers::pi / 4.0 * (2.0 * i / n - 1.0)); };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](int i, int j) -> Vector3d {
        Vector3d x;
        x[axis] = side;
        x[(axis + 1) % 3] = grid(i);
        x[(axis + 2) % 3] = grid(j);
        return radius * x.normalized();
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j)
          faces.push_back(
              quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), (side > 0.0) != looks_out));
      }
    }
  }
  return faces;
}

/// The facets of a torus around z, of a circle of radius 3 and tubes of radius 1, turned within the tube.
std::vector<MovingFace> torus(int n_around, int n_tube, double turn) {
  std::vector<MovingFace> faces;
  const auto at = [&](int i, int j) {
    const double a = 2.0 * std::numbers::pi * i / n_around, b = turn + 2.0 * std::numbers::pi * j / n_tube;
    const double r = 3.0 + std::cos(b);
    return Vector3d(r * std::cos(a), r * std::sin(a), std::sin(b));
  };
  for (int i = 0; i < n_around; ++i) {
    for (int j = 0; j < n_tube; ++j)
      faces.push_back(quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)));
  }
  return faces;
}

/// The cells of a square of width 10 that looks up.
std::vector<MovingFace> plate(int n, double z) {
  std::vector<MovingFace> faces;
  const auto at = [&](int i, int j) { return Vector3d(10.0 * i / n - 5.0, 10.0 * j / n - 5.0, z); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) faces.push_back(quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)));
  }
  return faces;
}

struct Smoothed {
  std::vector<MovingFace> faces;
  std::vector<SmoothFace> smooth;

  explicit Smoothed(std::vector<MovingFace> given) : faces(std::move(given)) {}
  Smoothed(std::vector<MovingFace> given, const RoundShape& shape) : faces(std::move(given)) {
    for (const MovingFace& face : faces)
      smooth.push_back(SmoothFace::make(shape, face.x, face.is_triangle).value());
  }
  SmoothPatch patch(std::size_t i) const { return {faces[i], smooth.empty() ? nullptr : &smooth[i]}; }
  void turn(const Eigen::AngleAxisd& by) {
    for (MovingFace& face : faces) face.x = by.toRotationMatrix() * face.x;
  }
};

Vector3d moment_of(const FaceCorners& x, const Eigen::Vector4d& weights, const Vector3d& force) {
  return (x * weights).cross(force);
}

/// What all facets of two bodies do to each other.
struct Total {
  double area = 0.0, force = 0.0, least_pressure = 1e300, most_pressure = 0.0, left_moment = 0.0;
  Vector3d force_on_first = Vector3d::Zero(), moment = Vector3d::Zero();
};

Total push(const Smoothed& a, const Smoothed& b) {
  PairPenalty penalty;
  penalty.stiffness = stiffness;
  penalty.depth = 0.1;
  Total total;
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    for (std::size_t j = 0; j < b.faces.size(); ++j) {
      const SmoothPatch first = a.patch(i), second = b.patch(j);
      const FaceFaceContact contact = find_smooth_contact({first, second}, penalty, 0.0);
      if (!contact.overlaps) continue;
      const Vector3d force = contact.force * contact.normal;
      const Vector3d on_first = moment_of(a.faces[i].x, contact.weights_1, force),
                     on_second = moment_of(b.faces[j].x, contact.weights_2, force);
      total.area += contact.area;
      total.force += contact.force;
      total.force_on_first += force;
      total.moment += on_first;
      total.left_moment = std::max(total.left_moment, (on_first - on_second).norm());
      CHECK(contact.weights_1.sum() == Approx(1.0));
      CHECK(contact.weights_2.sum() == Approx(1.0));
      total.least_pressure = std::min(total.least_pressure, contact.force / contact.area);
      total.most_pressure = std::max(total.most_pressure, contact.force / contact.area);
    }
  }
  return total;
}

}  // namespace

TEST_CASE("facets of two rings press on each other as their circles do", "[contact][smoothing]") {
  const double turn = GENERATE(0.0, 0.01, 0.1, 0.13, 0.2);
  const bool is_inner_finer = GENERATE(false, true);
  const Smoothed inner(ring(is_inner_finer ? 24 : 16, 1.0 + interference, true, turn), RoundShape{}),
      outer(ring(is_inner_finer ? 16 : 24, 1.0, false, 0.0), RoundShape{});
  const Total total = push(inner, outer);
  CHECK(total.area == Approx(2.0 * std::numbers::pi * width).epsilon(2e-3));
  CHECK(total.least_pressure == Approx(1000.0).epsilon(5e-3));
  CHECK(total.most_pressure == Approx(1000.0).epsilon(5e-3));
  CHECK(std::abs(total.moment.z()) < 1e-3 * stiffness * interference);
  CHECK(total.left_moment < 1e-10);
  CHECK(total.force_on_first.norm() < 1e-3 * total.force);
}

TEST_CASE("facets of two cones press on each other as the cones do, also triangles", "[contact][smoothing]") {
  const double slope = GENERATE(0.0, 0.1, 0.5), turn = GENERATE(0.0, 0.1);
  const int n_cut = GENERATE(0, 1, 2);
  const auto facets = [&](const std::vector<MovingFace>& quads, bool is_cut) {
    return is_cut ? cut_in_triangles(quads) : quads;
  };
  const Smoothed inner(facets(ring(16, 1.0 + interference, true, turn, slope), n_cut > 0), RoundShape{}),
      outer(facets(ring(24, 1.0, false, 0.0, slope), n_cut > 1), RoundShape{});
  const Total total = push(inner, outer);
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);  // of the interference along the normal
  const double area = 2.0 * std::numbers::pi * width * (1.0 + 0.5 * slope * width) / cosine;
  // The arcs at the ends of steep triangles are seen as straight where they bend in.
  CHECK(total.area == Approx(area).epsilon(n_cut == 0 ? 0.005 : 0.01 + 0.06 * slope));
  CHECK(total.least_pressure == Approx(1000.0 * cosine).epsilon(5e-3));
  CHECK(total.most_pressure == Approx(1000.0 * cosine).epsilon(5e-3));
  CHECK(std::abs(total.moment.z()) < 1e-3 * stiffness * interference);
  CHECK(total.left_moment < 1e-10);
}

TEST_CASE("facets of two spheres press on each other as the spheres do", "[contact][smoothing]") {
  RoundShape shape;
  shape.kind = RoundShape::Kind::spherical;
  Smoothed inner(sphere(4, 1.0 + interference, true), shape);
  const Smoothed outer(sphere(6, 1.0, false), shape);
  inner.turn(Eigen::AngleAxisd(GENERATE(0.0, 0.3), Vector3d(1, 2, 3).normalized()));
  const Total total = push(inner, outer);
  CHECK(total.area == Approx(4.0 * std::numbers::pi).epsilon(0.03));
  CHECK(total.least_pressure == Approx(1000.0).epsilon(0.02));
  CHECK(total.most_pressure == Approx(1000.0).epsilon(0.02));
  CHECK(total.moment.norm() < 1e-3 * stiffness * interference);
  CHECK(total.left_moment < 1e-10);
  CHECK(total.force_on_first.norm() < 1e-3 * total.force);
}

TEST_CASE("a sphere on a plate touches in a circle, wherever its facets are", "[contact][smoothing]") {
  RoundShape shape;
  shape.kind = RoundShape::Kind::spherical;
  Smoothed ball(sphere(4, 1.0, true), shape);
  ball.turn(Eigen::AngleAxisd(GENERATE(0.0, 0.2, 0.5, 0.9), Vector3d(1, 2, 3).normalized()));
  const Smoothed below(plate(5, -1.0 + interference));
  const Total total = push(ball, below);
  CHECK(total.force == Approx(stiffness * std::numbers::pi * interference * interference).epsilon(0.02));
  CHECK(total.force_on_first.z() == Approx(total.force).epsilon(1e-3));
  CHECK(total.area == Approx(2.0 * std::numbers::pi * interference).epsilon(0.05));
  CHECK(total.left_moment < 1e-10);
  // The force is below the middle.
  CHECK(total.moment.norm() < 2e-3 * total.force);
}

TEST_CASE("a torus on a plate touches in a ring, wherever its facets are", "[contact][smoothing]") {
  RoundShape shape;
  shape.kind = RoundShape::Kind::toroidal;
  shape.arc_radius = 3.0;
  const Smoothed tyre(torus(32, 16, GENERATE(0.0, 0.05, 0.1)), shape), below(plate(3, -1.0 + interference));
  const Total total = push(tyre, below);
  const double half_width = std::sqrt(2.0 * interference), circle = 6.0 * std::numbers::pi;
  CHECK(total.force == Approx(stiffness * 4.0 / 3.0 * interference * half_width * circle).epsilon(0.02));
  CHECK(total.area == Approx(2.0 * half_width * circle).epsilon(0.03));
  CHECK(total.left_moment < 1e-10);
  CHECK(total.moment.norm() < 2e-3 * total.force);
}

TEST_CASE("points of balance carry the gap of the circles, and no moment", "[contact][smoothing]") {
  const Smoothed inner(ring(16, 1.0 + interference, true, 0.07), RoundShape{}),
      outer(ring(24, 1.0, false, 0.0), RoundShape{});
  double area = 0.0, left = 0.0;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t i = 0; i < inner.faces.size(); ++i) {
    for (std::size_t j = 0; j < outer.faces.size(); ++j) {
      const SmoothPatch first = inner.patch(i), second = outer.patch(j);
      const FaceFaceConstraints found =
          find_smooth_constraints({first, second}, {0.0, 1e-4, 1e-4, 0.1, 1e-3});
      for (const OverlapShare& point : found.all()) {
        const Vector3d on_first = moment_of(inner.faces[i].x, point.weights_1, point.normal),
                       on_second = moment_of(outer.faces[j].x, point.weights_2, point.normal);
        const double gap = point.rise + point.normal.dot(inner.faces[i].x * point.weights_1 -
                                                         outer.faces[j].x * point.weights_2);
        CHECK(gap == Approx(-interference).epsilon(2e-3));
        area += point.area;
        moment += point.area * on_first;
        left = std::max(left, (on_first - on_second).norm());
      }
    }
  }
  CHECK(area == Approx(2.0 * std::numbers::pi * width).epsilon(2e-3));
  CHECK(std::abs(moment.z()) < 1e-3);
  CHECK(left < 1e-12);
}
