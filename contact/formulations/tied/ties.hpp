// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "contact/formulations/interface_constraint.hpp"
#include "contact/geometry/face_face.hpp"

namespace contactsim {

/// A point of a tie that momentum balance holds where it was tied.
struct TiePoint {
  double area = 0.0;                                    ///< that it stands for [length^2]
  Eigen::Vector4d weights_1 = Eigen::Vector4d::Zero();  ///< of the first side's corners, sum 1 [1]
  Eigen::Vector4d weights_2 = Eigen::Vector4d::Zero();  ///< of the second side's [1]
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();     ///< between them, in axes of the second [length]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();      ///< of the last step, in the same axes [force]
};

/// A face, or a node, tied to a face. The springs between the points of both add up to one stiffness between
/// their corners, so that a tie of faces passes uniform stress and keeps what gap there was.
struct Tie : InterfaceConstraint {
  Eigen::Matrix<double, 8, 8> stiffness = Eigen::Matrix<double, 8, 8>::Zero();  ///< [force/length]
  CornerVectors rest =
      CornerVectors::Zero();  ///< forces that hold the gaps open, in axes of the second face [force]
  double rest_energy = 0.0;   ///< that the springs would hold were the gaps closed; of a glued pair also what
                              ///< it held before [energy]
  std::uint32_t n_points = 0;
  std::array<TiePoint, 4> points{};  ///< for momentum balance
};

/// Ties all points of two faces whose gap is at most the tolerance either way. Returns whether there are any.
///   tie  nodes and entities are set, the rest is filled in
bool tie_faces(const MovingFace& first, const MovingFace& second, double stiffness, double tolerance,
               Tie& tie);

/// Ties a node to a point of a face.
///   weights    of the face's corners, sum 1 [1]
///   stiffness  [force/length]
void tie_node(const Eigen::Vector3d& node, const MovingFace& face, const Eigen::Vector4d& weights,
              double stiffness, Tie& tie);

/// Forces of a tie. Gaps turn with the second face; its corners take the moment of forces across a gap, so
/// that neither force nor moment is left over.
///   x  of the corners [length]
CornerForces find_tie_forces(const Tie& tie, const CornerVectors& x);

/// Gives a tie other springs, stretched so that they hold with the same forces as they do now.
///   stiffness  per area of the springs [force/length^3]
///   x          of the corners now [length]
void renew_springs(double stiffness, const CornerVectors& x, Tie& tie);

/// Continues a tie with springs under momentum balance, which begins with their forces: its points are in
/// place as they are now. Of the springs no more is left than what makes the forces of the points theirs,
/// which does not depend on how far the sides are apart.
///   x  of the corners now [length]
void replace_springs_by_points(const CornerVectors& x, Tie& tie);

/// Whether a tie has forces beside those of its points.
inline bool has_constant_forces(const Tie& tie) { return tie.stiffness.isZero(0.0); }

/// Where the first side's point of a tie is, from the second side's. The second side carries it there, though
/// it may be off its place: so the forces on both sides leave no moment [length].
Eigen::Vector3d offset_of(const TiePoint& point, const CornerVectors& x);

/// Forces of a tie whose points have theirs from momentum balance.
///   x  of the corners [length]
CornerForces find_point_forces(const Tie& tie, const CornerVectors& x);

}  // namespace contactsim
