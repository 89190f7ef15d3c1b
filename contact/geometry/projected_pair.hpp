// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "contact/geometry/face_face_constraints.hpp"

namespace contactsim {

/// Two faces in the coordinates of their common plane.
struct ProjectedPair {
  CommonPlane plane;
  FaceCorners first, second;
  double min_gap, max_gap;  ///< bounds of the height of the first over the second [length]
  FaceMap map_1, map_2;
};

/// Both faces as seen along the normal of now; nothing when they do not face each other.
///   ahead  heights are those after this time [time]
std::optional<ProjectedPair> project_pair(const MovingFace& first, const MovingFace& second,
                                          double ahead = 0.0);

/// Whether two faces in the coordinates of one plane may overlap: their boxes do.
bool boxes_meet(const FaceCorners& first, const FaceCorners& second);

/// Whether some point of the first face may be nearer to the second than the activation distance, and none is
/// too deep.
inline bool is_near(const ProjectedPair& pair, double activation_distance, double depth) {
  return pair.min_gap < activation_distance && -pair.max_gap < depth && boxes_meet(pair.first, pair.second);
}

/// Whether no gap is beyond what counts as closed, nor deeper than what is another wall.
inline bool is_whole_near(const ProjectedPair& pair, const ConstraintActivation& activation) {
  return pair.min_gap >= -activation.depth && pair.max_gap <= activation.margin;
}

inline void make_maps(const MovingFace& first, const MovingFace& second, ProjectedPair& pair) {
  pair.map_1 = make_face_map(pair.first, first.is_triangle);
  pair.map_2 = make_face_map(pair.second, second.is_triangle);
}

inline OverlapPolygon overlap_of(const ProjectedPair& pair) {
  return intersect(pair.first, pair.map_1.is_triangle, pair.second, pair.map_2.is_triangle);
}

/// Adds f at eight points to sums over a face.
inline void add_moments(const Lanes& f, const Lanes& xi, const Lanes& eta, FaceMoments& moments) {
  const Lanes f_xi = f * xi;
  moments[0] += f.sum();
  moments[1] += f_xi.sum();
  moments[2] += (f * eta).sum();
  moments[3] += (f_xi * eta).sum();
}

}  // namespace contactsim
