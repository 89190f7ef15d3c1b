// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/common_plane.hpp"

#include "contact/geometry/smooth_step.hpp"

namespace contactsim {

namespace {

/// Cosines of the angles between which the normal goes over from the mean to that of the blunter face.
constexpr double no_lean = 0.985, full_lean = 0.866;

/// A surface that turns by less than this is as good as smooth [degrees].
constexpr double next_to_smooth = 0.1;

}  // namespace

std::array<Lanes, 2> shares_of_normals(const Lanes& cosine, const Lanes& sharpness_1,
                                       const Lanes& sharpness_2) {
  const LaneMask leans = cosine < no_lean;
  if (!leans.any()) return {1.0, 1.0};
  const Lanes lean = smooth_step<Lanes>(((no_lean - cosine) / (no_lean - full_lean)).max(0.0).min(1.0));
  const Lanes sharper_1 = (sharpness_1 - sharpness_2) / (sharpness_1 + sharpness_2 + next_to_smooth);
  return {1.0 - lean * sharper_1.max(0.0), 1.0 - lean * (-sharper_1).max(0.0)};
}

CommonPlanes make_common_planes(const CornersOfFaces& first, const FaceOrientations& look_1,
                                const FaceOrientations& look_2) {
  const DoubleVectors &area_1 = look_1.area, &area_2 = look_2.area;
  const Lanes size_1 = area_1.dot(area_1).sqrt(), size_2 = area_2.dot(area_2).sqrt();
  const Lanes opposed = -area_1.dot(area_2), size = size_1 * size_2;
  CommonPlanes planes;
  planes.exist = opposed > -facing_limit(look_1.sharpness.max(look_2.sharpness)) * size;
  const auto shares = shares_of_normals(opposed / size, look_1.sharpness, look_2.sharpness);
  planes.normal = normalized(shares[1] * size_1 * area_2 - shares[0] * size_2 * area_1);
  planes.spread = (-size_1 / area_1.dot(planes.normal)).max(size_2 / area_2.dot(planes.normal));
  planes.origin = first[0];
  // In the plane any direction will do; one that turns with the faces makes results turn with them.
  const DoubleVectors diagonal = first[2] - first[0];
  planes.across = normalized(diagonal - planes.normal.dot(diagonal) * planes.normal);
  planes.along = planes.normal.cross(planes.across);
  return planes;
}

CommonPlane CommonPlanes::of(Eigen::Index lane) const {
  return {vector_in(normal, lane), vector_in(across, lane), vector_in(along, lane), vector_in(origin, lane),
          spread(lane)};
}

std::optional<CommonPlane> make_common_plane(const FaceCorners& first, const FaceOrientation& look_1,
                                             const FaceOrientation& look_2) {
  CornersOfFaces corners;
  for (std::size_t k = 0; k < 4; ++k)
    corners[k] = DoubleVectors::all(first.col(static_cast<Eigen::Index>(k)));
  const auto planes = make_common_planes(corners, {DoubleVectors::all(look_1.area), look_1.sharpness},
                                         {DoubleVectors::all(look_2.area), look_2.sharpness});
  if (!planes.exist(0)) return std::nullopt;
  return planes.of(0);
}

}  // namespace contactsim
