// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "contact/geometry/contact_point.hpp"

namespace contactsim {

/// The tangential spring of nodes in load steps over the penalty, which is ten times that of explicit
/// dynamics: what sticks holds as well, and takes a third of Newton's steps [1].
inline constexpr double static_slip_share = 0.1;

/// Friction of one contact point in one step.
struct FrictionStep {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the first side [force]
  Eigen::Vector3d elastic_slip =
      Eigen::Vector3d::Zero();  ///< slip that the tangential spring holds, after the step [length]
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();  ///< beyond the spring, in the step: lost for good [length]
  double dissipated = 0.0;                         ///< in the step, >= 0 [energy]
};

/// Coulomb friction by a tangential spring: the force follows the slip elastically up to coefficient * normal
/// force and slides there. The slip of earlier steps is turned into the plane of now.
///   normal   unit [1]
///   elastic  held after the last step [length]
///   slip     of the first side along the second in this step; its normal part is left out [length]
///   stiffness  of the tangential spring [force/length]
///   limit    coefficient times normal force, >= 0 [force]
/// Source: return mapping of Wriggers, Computational Contact Mechanics (2006), 5.2.
FrictionStep step_friction(const Eigen::Vector3d& normal, const Eigen::Vector3d& elastic_slip,
                           const Eigen::Vector3d& slip, double stiffness, double limit);

/// Gives a contact point that touches its friction: takes the slip of the step and the elastic slip from it,
/// and sets tangential force, both slips and what is lost.
///   stiffness  of the tangential spring [force/length]
///   limit      of the tangential force, >= 0 [force]
void add_friction(double stiffness, double limit, ContactPoint& point);

}  // namespace contactsim
