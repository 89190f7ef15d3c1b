// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/geometry/face_face.hpp"
#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// Vectors of the corners of two sides [3 x 8]: those of the first, then those of the second.
using TieVectors = Eigen::Matrix<double, 3, 8>;

/// A face, or a node, that something holds to a face.
struct InterfaceConstraint {
  std::uint32_t pair = 0;
  bool is_swapped = false;                            ///< the first side is of the pair's second surface
  std::uint32_t first_entity = 0, second_entity = 0;  ///< face or surface node; face
  bool is_node = false;                               ///< the first side is a node
  std::array<std::uint32_t, 8> nodes{};               ///< contact nodes of the corners
  Eigen::Matrix<double, 8, 1> springs =
      Eigen::Matrix<double, 8, 1>::Zero();  ///< each corner's share of the springs [force/length]
  double area = 0.0;                        ///< [length^2]
  double share = 1.0;  ///< of a whole constraint, where pairs that go both ways share it [1]
};

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
  TieVectors rest =
      TieVectors::Zero();    ///< forces that hold the gaps open, in axes of the second face [force]
  double rest_energy = 0.0;  ///< that the springs would hold were the gaps closed; of a glued pair also what
                             ///< it held before [energy]
  std::uint32_t n_points = 0;
  std::array<TiePoint, 4> points{};  ///< for momentum balance
};

/// The forces of an interface constraint on its corners; all 0 of a tie that does not act.
struct TieForces {
  TieVectors forces;        ///< [force]
  Eigen::Vector3d normal;   ///< of the second side, unit [1]
  double stored = 0.0;      ///< in the springs [energy]
  double dissipated = 0.0;  ///< in the step, by damage and failure [energy]
};

/// Axes that turn with a face: a diagonal, at right angles to it, the normal.
Eigen::Matrix3d axes_of(const FaceCorners& x);

/// Adds forces to those of the second side so that neither force nor moment is left over.
///   arms  of the corners, from any point near [length]
void balance(const TieVectors& arms, TieVectors& forces);

/// Ties all points of two faces whose gap is at most the tolerance either way. Returns whether there are any.
///   tie  nodes and entities are set, the rest is filled in
bool tie_faces(const MovingFace& first, const MovingFace& second, double stiffness, double tolerance,
               Tie& tie);

/// How the corners of a face carry a point that stands off the face and turns with it: the point's velocity
/// is the sum of a matrix times the velocity of each corner.
///   offset  from the point of the face with these weights [length]
std::array<Eigen::Matrix3d, 4> carry_point(const FaceCorners& x, const Eigen::Vector4d& weights,
                                           const Eigen::Vector3d& offset);

/// Ties a node to a point of a face.
///   weights    of the face's corners, sum 1 [1]
///   stiffness  [force/length]
void tie_node(const Eigen::Vector3d& node, const MovingFace& face, const Eigen::Vector4d& weights,
              double stiffness, Tie& tie);

/// Forces of a tie. Gaps turn with the second face; its corners take the moment of forces across a gap, so
/// that neither force nor moment is left over.
///   x  of the corners [length]
TieForces find_tie_forces(const Tie& tie, const TieVectors& x);

}  // namespace contactsim
