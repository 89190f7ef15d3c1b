// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "contact/geometry/face_face.hpp"

namespace contactsim {

/// Which part of an overlap is constrained, by the gaps at the end of the coming step.
struct ConstraintActivation {
  double ahead = 0.0;   ///< the coming step [time]
  double margin = 0.0;  ///< gaps up to it count as closed, > 0 [length]
  double near = 0.0;    ///< where no gap closes those up to it may close soon, >= margin [length]
  double depth = 0.0;   ///< what lies deeper is another wall [length]
  double flat = 0.0;    ///< warp up to which a quadrilateral counts as flat [length]
};

/// The part of an overlap that one corner of a face has; of a small overlap all of it.
struct OverlapShare {
  double area;                           ///< [length^2]
  Eigen::Vector3d normal;                ///< unit, from the second face to the first [1]
  Eigen::Vector4d weights_1, weights_2;  ///< of the corners, sum 1 each [1]
  std::uint8_t part;                     ///< of the overlap
  double rise;  ///< by which the gap is wider than that of the weighted corners [length]
};

/// The mean gap of a part of an overlap: of its weighted corners, and what the rest rises by [length].
double gap_of(const OverlapShare& share, const MovingFace& first, const MovingFace& second);

/// The contact points of two faces. Left without values: most of it is never used.
struct FaceFaceConstraints {
  std::size_t n = 0;
  std::array<OverlapShare, 64> points;  // of four facets on four, with four at most

  void add(const OverlapShare& point) { points[n++] = point; }
  std::span<const OverlapShare> all() const { return {points.data(), n}; }
};

/// Finds the part of the overlap of two faces whose gap closes in the coming step, else what may close soon,
/// and shares it out among the corners of the smaller face by their shape functions: so the points carry any
/// pressure that is linear over it, and a uniform one exactly. A part that is less than half of the smaller
/// face is one point. Seen along the normal both sides of a point coincide now, so that equal and opposite
/// forces leave no moment. Source: weighted gaps of Puso and Laursen (2004), on each overlap by itself.
///
/// Warped quadrilaterals that are near in part count as their Facets.
FaceFaceConstraints find_face_face_constraints(const MovingFace& first, const MovingFace& second,
                                               const ConstraintActivation& activation);

/// Two faces that a constraint may part.
struct ConstrainedFaces {
  const MovingFace &first, &second;
  ConstraintActivation activation;
};

/// Finds those of up to eight pairs that have the same time ahead.
///   found  of as many pairs
void find_face_face_constraints(std::span<const ConstrainedFaces> pairs,
                                std::span<FaceFaceConstraints> found);

/// The shares of the corners of one face in all of its overlap with another, whatever the gap: areas, weights
/// and mean gaps by their shape functions. Warped quadrilaterals are bilinear.
struct CornerShares {
  std::size_t n = 0;
  std::array<OverlapShare, 4> corners;  ///< part: which corner

  void add(const OverlapShare& share) { corners[n++] = share; }
  std::span<const OverlapShare> all() const { return {corners.data(), n}; }
};
///   is_of_first  whose corners: of the first face, else of the second
CornerShares find_corner_shares(const MovingFace& first, const MovingFace& second, bool is_of_first);

}  // namespace contactsim
