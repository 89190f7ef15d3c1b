// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <span>

#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/moving_face.hpp"

namespace contactsim {

/// Two faces in the coordinates of their common plane: across, along, normal [length].
struct ProjectedPair {
  CommonPlane plane;
  FaceCorners first, second;
  double min_gap, max_gap;  ///< bounds of the height of the first over the second [length]
  FaceMap map_1, map_2;
};

/// Two faces to be projected.
struct FacePair {
  const MovingFace *first, *second;
};

/// Up to eight pairs of faces as seen along their normals of now, a pair in each lane.
struct ProjectedPairs {
  ///   pairs  one at least
  ///   ahead  heights are those after this time [time]
  ///   knows_speed  with the speeds of the corners
  explicit ProjectedPairs(std::span<const FacePair> pairs, double ahead = 0.0, bool knows_speed = false);

  /// Whether some point of the first face may be nearer to the second than the activation distance, and none
  /// is too deep; not of faces that do not face each other.
  LaneMask are_near(const Lanes& activation_distance, const Lanes& depth) const;
  /// Whether their boxes in the plane do: else they do not overlap.
  LaneMask boxes_meet() const;
  /// Whether quadrilaterals are out of their planes by more than these heights [length].
  LaneMask are_warped_1(const Lanes& flat) const { return !are_triangles_1 && warps_1_.is_more_than(flat); }
  LaneMask are_warped_2(const Lanes& flat) const { return !are_triangles_2 && warps_2_.is_more_than(flat); }
  ProjectedPair of(Eigen::Index lane) const;

  CommonPlanes planes;
  CornersOfFaces first, second;
  Lanes min_gap, max_gap;
  MapsOfFaces maps_1, maps_2;
  CornerNumbers speeds_1, speeds_2;  ///< of the corners along the normals, where they are known [length/time]
  LaneMask are_triangles_1, are_triangles_2;

 private:
  /// How far the corners are out of the plane, times the area.
  class WarpOfFaces {
   public:
    WarpOfFaces() = default;
    WarpOfFaces(const CornersOfFaces& x, const DoubleVectors& area)
        : height_(0.25 * area.dot((x[0] - x[1]) + (x[2] - x[3]))), area_(area.dot(area)) {}
    LaneMask is_more_than(const Lanes& flat) const { return height_ * height_ > flat * flat * area_; }

   private:
    Lanes height_, area_;  // the area squared
  };
  WarpOfFaces warps_1_, warps_2_;
};

/// The same of pairs that have a `first` and a `second`.
template <class Pair>
ProjectedPairs project_pairs(std::span<const Pair> pairs, double ahead = 0.0, bool knows_speed = false) {
  std::array<FacePair, n_lanes> faces;
  for (std::size_t i = 0; i < pairs.size(); ++i) faces[i] = {&pairs[i].first, &pairs[i].second};
  return ProjectedPairs({faces.data(), pairs.size()}, ahead, knows_speed);
}

/// One pair; nothing when its faces do not face each other.
std::optional<ProjectedPair> project_pair(const MovingFace& first, const MovingFace& second,
                                          double ahead = 0.0);

}  // namespace contactsim
