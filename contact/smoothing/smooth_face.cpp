// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/smooth_face.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// A face goes round a shape when the cosine between its normal and the way to its corners is greater, either
/// way: that of a cone of 70 degrees is.
constexpr double goes_round_cosine = 0.3;

/// By so much coordinates may be beyond an edge and still be on it: they are found by iterations.
constexpr double on_edge = 1e-8;

/// Points at which the largest height and lean of the surface over a face are looked for, along each side.
constexpr int n_probes = 4;

Eigen::Vector3d tangent_xi(const FaceMap& map, double eta) { return map.c[1] + eta * map.c[3]; }
Eigen::Vector3d tangent_eta(const FaceMap& map, double xi) { return map.c[2] + xi * map.c[3]; }

FaceFunction face_function(const Eigen::Vector4d& values, bool is_triangle) {
  FaceCorners corners = FaceCorners::Zero();
  corners.row(0) = values;
  return component(make_face_map(corners, is_triangle), 0);
}

/// The axes of a face, as columns: along a diagonal, across it, out of the element. They turn with the face.
Eigen::Matrix3d face_axes(const FaceCorners& corners) {
  Eigen::Matrix3d axes;
  axes.col(2) = area_vector(corners).normalized();
  const Eigen::Vector3d diagonal = corners.col(2) - corners.col(0);
  axes.col(0) = (diagonal - axes.col(2).dot(diagonal) * axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace

std::optional<SmoothFace> SmoothFace::make(const RoundShape& shape, const FaceCorners& corners,
                                           bool is_triangle) {
  SmoothFace made;
  made.shape_ = shape;
  made.start_ = make_face_map(corners, is_triangle);
  made.to_face_axes_ = face_axes(corners).transpose();
  const Eigen::Vector3d normal = area_vector(corners).normalized();
  const auto goes_round = [&](const Eigen::Vector3d& way) {
    return std::abs(normal.dot(way)) > goes_round_cosine * way.norm();
  };
  Eigen::Vector4d radii;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const Eigen::Vector3d way = shape.way_to(Eigen::Vector3d(corners.col(k)));
    if (!goes_round(way)) return std::nullopt;
    radii[k] = way.norm();
  }
  if (!goes_round(shape.way_to(made.start_.centre()))) return std::nullopt;
  made.radius_ = face_function(radii, is_triangle);
  made.measure();
  return made;
}

void SmoothFace::measure() {
  const bool is_triangle = start_.is_triangle;
  double area = 0.0, of_face = 0.0;
  for (int i = 0; i <= n_probes; ++i) {
    for (int j = 0; j <= (is_triangle ? n_probes - i : n_probes); ++j) {
      const double s = static_cast<double>(i) / n_probes, t = static_cast<double>(j) / n_probes;
      const double xi = is_triangle ? s : 2.0 * s - 1.0, eta = is_triangle ? t : 2.0 * t - 1.0;
      const FaceVector rise = rise_at(xi, eta);
      const Eigen::Vector3d along = tangent_xi(start_, eta), across = tangent_eta(start_, xi);
      const Eigen::Vector3d out =
          (to_face_axes_ * along + rise.by_xi).cross(to_face_axes_ * across + rise.by_eta);
      height_ = std::max(height_, std::abs(rise.value.z()));
      lean_ = std::max(lean_, out.head<2>().norm() / std::max(out.z(), goes_round_cosine * out.norm()));
      // By the trapezoidal rule.
      const bool is_at_end = is_triangle ? i + j == n_probes : i == n_probes;
      const double weight = (i == 0 || is_at_end ? 0.5 : 1.0) * (j == 0 || j == n_probes ? 0.5 : 1.0);
      area += weight * out.norm();
      of_face += weight * along.cross(across).norm();
    }
  }
  area_ratio_ = area / of_face;
}

FaceVector SmoothFace::rise_at(double xi, double eta) const {
  const FaceVector way =
      shape_.way_to(FaceVector{start_.at(xi, eta), tangent_xi(start_, eta), tangent_eta(start_, xi)});
  const auto& r = radius_;
  const double ideal = r[0] + r[1] * xi + (r[2] + r[3] * xi) * eta;
  const double own = way.value.norm(), rise = ideal - own;
  const Eigen::Vector3d out = way.value / own;
  // The derivative of (ideal - own) out.
  const auto derivative = [&](const Eigen::Vector3d& along, double of_ideal) -> Eigen::Vector3d {
    const double of_own = out.dot(along);
    return to_face_axes_ * ((of_ideal - of_own) * out + rise / own * (along - of_own * out));
  };
  return {to_face_axes_ * (rise * out), derivative(way.by_xi, r[1] + r[3] * eta),
          derivative(way.by_eta, r[2] + r[3] * xi)};
}

SmoothPatch::SmoothPatch(const MovingFace& face, const SmoothFace* smooth)
    : face_(face),
      smooth_(smooth),
      map_(make_face_map(face.x, face.is_triangle)),
      velocity_(make_face_map(face.v, face.is_triangle)) {
  if (smooth != nullptr) axes_ = face_axes(face.x);
}

SmoothPatch::Point SmoothPatch::at(double xi, double eta) const {
  Point point;
  point.on_face = point.x = map_.at(xi, eta);
  point.along_xi = tangent_xi(map_, eta);
  point.along_eta = tangent_eta(map_, xi);
  if (smooth_ == nullptr) return point;
  const FaceVector rise = smooth_->rise_at(xi, eta);
  point.x += axes_ * rise.value;
  point.along_xi += axes_ * rise.by_xi;
  point.along_eta += axes_ * rise.by_eta;
  return point;
}

namespace {

/// The coordinates at which the way from the face to a point is along the surface's normal. Newton's method
/// with the normal held: its turn over the way left is as small as the height over the radius.
std::optional<ClosestPoint> project_along_normal(const SmoothPatch& patch, const Eigen::Vector3d& point) {
  constexpr int max_iterations = 40;
  constexpr double accuracy = 1e-10, far_away = 10.0;
  ClosestPoint found;
  if (patch.is_triangle()) found.xi = found.eta = 1.0 / 3.0;
  const FaceMap map = make_face_map(patch.face().x, patch.is_triangle());
  for (int i = 0; i < max_iterations; ++i) {
    const SmoothPatch::Point at = patch.at(found.xi, found.eta);
    found.normal = at.normal();
    found.gap = found.normal.dot(point - at.x);
    Eigen::Matrix3d directions;
    directions << tangent_xi(map, found.eta), tangent_eta(map, found.xi), found.normal;
    const double det = directions.determinant();
    if (!(det > 0.0)) return std::nullopt;
    const Eigen::Vector3d step = directions.inverse() * (point - at.on_face);
    found.xi += step[0];
    found.eta += step[1];
    if (!(std::abs(found.xi) < far_away && std::abs(found.eta) < far_away)) return std::nullopt;
    if (std::abs(step[0]) + std::abs(step[1]) < accuracy) return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle, const SmoothFace* smooth,
                                           const Eigen::Vector3d& centre, double radius) {
  if (smooth == nullptr) return project_sphere(x, is_triangle, centre, radius);
  const MovingFace face{x, FaceCorners::Zero(), is_triangle, 0.0};
  const SmoothPatch patch(face, smooth);
  auto found = project_along_normal(patch, centre);
  if (!found) return std::nullopt;
  double xi = found->xi, eta = found->eta;
  found->edge = move_inside(is_triangle, xi, eta);
  if (std::abs(found->xi - xi) + std::abs(found->eta - eta) < on_edge) found->edge = std::nullopt;
  if (found->edge) {
    if (radius > 0.0) return project_sphere(x, is_triangle, centre, radius);
    found->beyond = (patch.at(found->xi, found->eta).on_face - patch.at(xi, eta).on_face).norm();
  }
  found->gap -= radius;
  return found;
}

}  // namespace contactsim
