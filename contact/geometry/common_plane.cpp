// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/common_plane.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/smooth_step.hpp"

namespace contactsim {

namespace {

/// Cosines of the angles between which the normal goes over from the mean to that of the blunter face.
constexpr double no_lean = 0.985, full_lean = 0.866;

/// A surface that turns by less than this is as good as smooth [degrees].
constexpr double next_to_smooth = 0.1;

}  // namespace

std::array<double, 2> shares_of_normals(double cosine, double sharpness_1, double sharpness_2) {
  if (cosine >= no_lean) return {1.0, 1.0};
  const double lean = smooth_step(std::clamp((no_lean - cosine) / (no_lean - full_lean), 0.0, 1.0));
  const double sharper_1 = (sharpness_1 - sharpness_2) / (sharpness_1 + sharpness_2 + next_to_smooth);
  return {1.0 - lean * std::max(sharper_1, 0.0), 1.0 - lean * std::max(-sharper_1, 0.0)};
}

std::optional<CommonPlane> make_common_plane(const FaceCorners& first, const FaceOrientation& look_1,
                                             const FaceOrientation& look_2) {
  const double size_1 = look_1.area.norm(), size_2 = look_2.area.norm();
  const double opposed = -look_1.area.dot(look_2.area), size = size_1 * size_2;
  const double facing = facing_limit(std::max(look_1.sharpness, look_2.sharpness));
  if (!(opposed > -facing * size)) return std::nullopt;
  const auto shares = shares_of_normals(opposed / size, look_1.sharpness, look_2.sharpness);
  CommonPlane plane;
  plane.normal = (shares[1] * size_1 * look_2.area - shares[0] * size_2 * look_1.area).normalized();
  plane.spread = std::max(-size_1 / look_1.area.dot(plane.normal), size_2 / look_2.area.dot(plane.normal));
  plane.origin = first.col(0);
  // In the plane any direction will do; one that turns with the faces makes results turn with them.
  const Eigen::Vector3d diagonal = first.col(2) - first.col(0);
  plane.across = (diagonal - plane.normal.dot(diagonal) * plane.normal).normalized();
  plane.along = plane.normal.cross(plane.across);
  return plane;
}

FaceCorners project(const FaceCorners& face, const CommonPlane& plane) {
  const FaceCorners moved = face.colwise() - plane.origin;
  FaceCorners projected;
  projected.row(0) = plane.across.transpose() * moved;
  projected.row(1) = plane.along.transpose() * moved;
  projected.row(2) = plane.normal.transpose() * moved;
  return projected;
}

}  // namespace contactsim
