// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/depth_law.hpp"
#include "contact/geometry/face_overlap.hpp"
#include "contact/geometry/moving_face.hpp"

namespace contactsim {

class PressureLaw;

/// What a pair of faces, or a node and a face, resist with.
struct PairPenalty {
  double stiffness = 0.0;  ///< per area [force/length^3]
  double damping = 0.0;    ///< per area, of closing speed [force time/length^3]
  double depth = 0.0;      ///< what lies deeper is no contact but another wall [length]
  DepthLaw law;            ///< how pressure grows with depth
  double closing = 0.0;    ///< by which the gap may shrink in the coming step, for the stable step [length]
  const PressureLaw* pressure = nullptr;  ///< in place of the above; null: none
  double least_slope =
      0.0;  ///< beside a pressure, for the stable step: of a spring along it [force/length^3]

  /// The slope of the pressure at a depth, for the stable step [force/length^3].
  double slope(double depth_ahead) const {
    return pressure == nullptr ? stiffness * law.slope(depth_ahead) : slope_of_pressure(depth_ahead);
  }
  double slope_of_pressure(double depth_ahead) const;
  /// The pressure at a depth without damping [force/length^2].
  double pressure_at(double at_depth) const;
  /// Damping by the slope of the pressure at a depth, over that by the stiffness [1].
  double damping_factor(double at_depth) const;
};

/// How two faces push each other.
struct FaceFaceContact {
  bool overlaps = false;  ///< seen along the normal, and near enough to touch within the activation distance
  double force = 0.0;     ///< along the normal on the first face, against it on the second, >= 0 [force]
  double area = 0.0;      ///< that touches [length^2]
  double gap =
      0.0;  ///< at the centre of force, < 0 when they touch; else the smallest in the overlap [length]
  double deepest = 0.0;    ///< penetration of any point [length]
  double stiffness = 0.0;  ///< of the penalty over what is nearer than the activation distance, at the end of
                           ///< the step to come [force/length]
  double beyond_spring = 0.0;  ///< stored besides what springs of that force and depth would [energy]
  double damped_power = 0.0;   ///< energy that damping takes per time [energy/time]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, from the second face to the first [1]
  /// Shares of the corners in the force, sum 1; in the overlap's area when there is no force [1].
  Eigen::Vector4d weights_1 = Eigen::Vector4d::Zero(), weights_2 = Eigen::Vector4d::Zero();
};

/// Integrates the pressure stiffness * f(penetration) of the depth law over the part of the overlap of two
/// faces that lies behind the other face, by the area of the face that leans more. Both faces get the same
/// forces at the same points seen along the normal, so that neither net force nor moment appears, for faces
/// of any shape.
///   activation_distance  gaps up to it count as near [length]
/// Source: common plane of Belytschko and Yeh (1993) with the integration of Puso and Laursen, Comput.
/// Methods Appl. Mech. Eng. 193 (2004) 601-629, over the clipped polygon, which is clipped where the gap
/// closes as well: without that corners make or lose a tenth of their energy.
FaceFaceContact find_face_face_contact(const MovingFace& first, const MovingFace& second,
                                       const PairPenalty& penalty, double activation_distance);

/// Two faces that a penalty may part.
struct PushedFaces {
  const MovingFace &first, &second;
  const PairPenalty& penalty;
  double activation_distance;  ///< gaps up to it count as near [length]
  double flat;                 ///< warp up to which a quadrilateral counts as flat [length]
};

/// A contact of one of several pairs, by its number.
struct PushedContact {
  std::size_t pair;
  FaceFaceContact contact;
};

/// Appends the contacts of up to eight pairs that overlap, pair by pair. Warped quadrilaterals are taken as
/// their Facets where some part of both lies on the other side of where the gap closes than the rest, or
/// beyond the activation distance.
void find_face_face_contacts(std::span<const PushedFaces> pairs, std::vector<PushedContact>& contacts);

/// The plane and the points of two faces as they are now, for ties.
struct FaceFacePoints {
  CommonPlane plane;
  OverlapPoints points;
  bool is_triangle_1 = false, is_triangle_2 = false;

  /// Calls visit(area, gap, weights of the first face's corners, of the second's) for each point whose gap is
  /// at most the tolerance either way.
  template <class Visit>
  void visit_near(double tolerance, const Visit& visit) const {
    for (const OverlapBatch& batch : points.batches()) {
      for (int lane = 0; lane < n_lanes; ++lane) {
        const double area = batch.weight(lane), gap = batch.gap(lane);
        if (!(area > 0.0) || !(std::abs(gap) <= tolerance)) continue;
        visit(area, gap, corner_weights(batch.xi_1(lane), batch.eta_1(lane), is_triangle_1),
              corner_weights(batch.xi_2(lane), batch.eta_2(lane), is_triangle_2));
      }
    }
  }
};

/// Nothing when the faces do not face each other or do not overlap.
std::optional<FaceFacePoints> find_face_face_points(const MovingFace& first, const MovingFace& second);

}  // namespace contactsim
