// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/projected_pair.hpp"

#include <algorithm>
#include <array>

namespace contactsim {

namespace {

/// Faces in the lanes; those after the last pair repeat it.
struct FaceLanes {
  CornersOfFaces x, v;
  FaceOrientations look;
  LaneMask are_triangles;
};

template <class FaceOf>
void fill(std::span<const FacePair> pairs, bool has_velocity, const FaceOf& face_of, FaceLanes& faces) {
  std::uint32_t triangles = 0;
  for (std::size_t lane = 0; lane < n_lanes; ++lane) {
    const MovingFace& face = face_of(pairs[std::min(lane, pairs.size() - 1)]);
    const auto at = static_cast<Eigen::Index>(lane);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto corner = static_cast<Eigen::Index>(k);
      set_lane(at, face.x.col(corner), faces.x[k]);
      if (has_velocity) set_lane(at, face.v.col(corner), faces.v[k]);
    }
    faces.look.sharpness(at) = face.sharpness;
    triangles |= face.is_triangle ? 1u << lane : 0u;
  }
  faces.are_triangles = LaneMask::of_bits(triangles);
  faces.look.area = Lanes(0.5) * (faces.x[2] - faces.x[0]).cross(faces.x[3] - faces.x[1]);
}

CornersOfFaces project(const CommonPlanes& planes, const FaceLanes& faces) {
  CornersOfFaces projected;
  for (std::size_t k = 0; k < 4; ++k) {
    const DoubleVectors moved = faces.x[k] - planes.origin;
    projected[k] = {planes.across.dot(moved), planes.along.dot(moved), planes.normal.dot(moved)};
  }
  return projected;
}

void move_ahead(const CornerNumbers& speeds, double ahead, CornersOfFaces& corners) {
  for (std::size_t k = 0; k < 4; ++k) corners[k].z += ahead * speeds[k];
}

/// The least and the most of a number at the four corners.
struct Range {
  Lanes least, most;
};

template <class NumberOf>
Range range_of(const CornersOfFaces& corners, const NumberOf& number_of) {
  const Lanes &a = number_of(corners[0]), &b = number_of(corners[1]), &c = number_of(corners[2]),
              &d = number_of(corners[3]);
  return {a.min(b).min(c.min(d)), a.max(b).max(c.max(d))};
}

LaneMask overlap(const Range& a, const Range& b) { return a.most > b.least && b.most > a.least; }

FaceCorners corners_in(const CornersOfFaces& corners, Eigen::Index lane) {
  FaceCorners of_face;
  for (std::size_t k = 0; k < 4; ++k) of_face.col(static_cast<Eigen::Index>(k)) = vector_in(corners[k], lane);
  return of_face;
}

}  // namespace

ProjectedPairs::ProjectedPairs(std::span<const FacePair> pairs, double ahead, bool knows_speed) {
  const bool has_velocity = ahead > 0.0 || knows_speed;
  FaceLanes faces_1, faces_2;
  fill(
      pairs, has_velocity, [](const FacePair& pair) -> const auto& { return *pair.first; }, faces_1);
  fill(
      pairs, has_velocity, [](const FacePair& pair) -> const auto& { return *pair.second; }, faces_2);
  are_triangles_1 = faces_1.are_triangles;
  are_triangles_2 = faces_2.are_triangles;
  planes = make_common_planes(faces_1.x, faces_1.look, faces_2.look);
  first = project(planes, faces_1);
  second = project(planes, faces_2);
  for (std::size_t k = 0; has_velocity && k < 4; ++k) {
    speeds_1[k] = planes.normal.dot(faces_1.v[k]);
    speeds_2[k] = planes.normal.dot(faces_2.v[k]);
  }
  if (ahead > 0.0) {
    move_ahead(speeds_1, ahead, first);
    move_ahead(speeds_2, ahead, second);
  }
  const auto height = [](const DoubleVectors& corner) -> const Lanes& { return corner.z; };
  const Range heights_1 = range_of(first, height), heights_2 = range_of(second, height);
  min_gap = heights_1.least - heights_2.most;
  max_gap = heights_1.most - heights_2.least;
  maps_1 = make_functions(first, are_triangles_1);
  maps_2 = make_functions(second, are_triangles_2);
  warps_1_ = WarpOfFaces(faces_1.x, faces_1.look.area);
  warps_2_ = WarpOfFaces(faces_2.x, faces_2.look.area);
}

LaneMask ProjectedPairs::boxes_meet() const {
  const auto across = [](const DoubleVectors& corner) -> const Lanes& { return corner.x; };
  const auto along = [](const DoubleVectors& corner) -> const Lanes& { return corner.y; };
  return overlap(range_of(first, across), range_of(second, across)) &&
         overlap(range_of(first, along), range_of(second, along));
}

LaneMask ProjectedPairs::are_near(const Lanes& activation_distance, const Lanes& depth) const {
  return planes.exist && min_gap < activation_distance && -max_gap < depth && boxes_meet();
}

ProjectedPair ProjectedPairs::of(Eigen::Index lane) const {
  return {planes.of(lane),
          corners_in(first, lane),
          corners_in(second, lane),
          min_gap(lane),
          max_gap(lane),
          map_in(maps_1, are_triangles_1(lane), lane),
          map_in(maps_2, are_triangles_2(lane), lane)};
}

std::optional<ProjectedPair> project_pair(const MovingFace& first, const MovingFace& second, double ahead) {
  const FacePair pair{&first, &second};
  const ProjectedPairs pairs({&pair, 1}, ahead);
  if (!pairs.planes.exist(0)) return std::nullopt;
  return pairs.of(0);
}

}  // namespace contactsim
