// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "contact/geometry/face_map.hpp"
#include "contact/geometry/lane_vector.hpp"

namespace contactsim {

/// Faces whose normals have a greater cosine than this stand beside each other, such as those round a convex
/// corner, and not opposite.
inline constexpr double max_facing_cosine = -0.3;
/// The same of blades and spikes, no face of which faces what they point at by more: of faces whose sharpness
/// is greater than this [degrees].
inline constexpr double max_facing_cosine_of_blade = -0.05, blade_sharpness = 145.0;

/// The cosine of two normals up to which a face of such a sharpness faces another.
inline double facing_limit(double sharpness) {
  return sharpness > blade_sharpness ? max_facing_cosine_of_blade : max_facing_cosine;
}
inline Lanes facing_limit(const Lanes& sharpness) {
  return (sharpness > blade_sharpness).select(max_facing_cosine_of_blade, max_facing_cosine);
}

/// Which way a face looks, and what is around it.
struct FaceOrientation {
  Eigen::Vector3d area;  ///< vector of any length, out of the element
  /// The angle that the surface turns by at the sharpest of the face's edges, or at a spike [degrees].
  double sharpness = 0.0;
};

/// Two faces that face each other, seen along the normal of a plane between them.
struct CommonPlane {
  Eigen::Vector3d normal;         ///< unit, from the second face towards the first [1]
  Eigen::Vector3d across, along;  ///< unit vectors of the plane; across x along = normal [1]
  Eigen::Vector3d origin;         ///< [length]
  double spread = 1.0;  ///< area of the face that leans more over its area seen along the normal [1]
};

/// The plane between two faces. Swapping the faces only turns its normal round. While they are nearly
/// parallel that is the mean of their normals, the second one's turned round. Where they lean by more than 10
/// to 30 degrees a sharp corner or edge meets something blunter: then it is the normal of the face with the
/// blunter surroundings, along which a surface without friction pushes a corner. Nothing when the faces do
/// not face each other.
///   first  corners of the first face
/// Source: mean normals of Belytschko and Yeh, Comput. Methods Appl. Mech. Eng. 105 (1993), and Tribol's
/// common plane. The rest is ours: corners that lie as deep as what they touch is wide keep their energy only
/// when the push is along the derivative of the gap, and of an area that goes with the leaning face.
std::optional<CommonPlane> make_common_plane(const FaceCorners& first, const FaceOrientation& look_1,
                                             const FaceOrientation& look_2);

/// The common planes of eight pairs of faces, see CommonPlane.
struct CommonPlanes {
  DoubleVectors normal, across, along, origin;
  Lanes spread;
  LaneMask exist;  ///< whether the faces face each other; the rest means nothing elsewhere

  CommonPlane of(Eigen::Index lane) const;
};

/// See FaceOrientation.
struct FaceOrientations {
  DoubleVectors area;
  Lanes sharpness;
};

/// The same of eight pairs of faces.
CommonPlanes make_common_planes(const CornersOfFaces& first, const FaceOrientations& look_1,
                                const FaceOrientations& look_2);

/// What the normals of two faces count for in the common one.
///   cosine  of the angle that the faces lean by
std::array<Lanes, 2> shares_of_normals(const Lanes& cosine, const Lanes& sharpness_1,
                                       const Lanes& sharpness_2);

}  // namespace contactsim
