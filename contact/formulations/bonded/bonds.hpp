// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/interface_constraint.hpp"
#include "core/interface_laws/interface_law.hpp"

namespace contactsim {

/// How far two sides have moved from where they were bonded, in axes of the second face.
struct Opening {
  double normal = 0.0;                             ///< > 0 apart [length]
  Eigen::Vector2d slip = Eigen::Vector2d::Zero();  ///< [length]
};

/// What a bond answers to an opening.
struct BondAnswer {
  double normal = 0.0;                                   ///< pulls back if > 0 [force]
  Eigen::Vector2d tangential = Eigen::Vector2d::Zero();  ///< in the direction of the slip [force]
  double stored = 0.0;                                   ///< [energy]
  double dissipated = 0.0;                               ///< by damage in this step [energy]
  bool fails = false;
};

/// The law of a bond: what it answers to an opening. In compression only slip counts: contact pushes.
///   area     of the interface [length^2]; of laws in forces its share of one bond [1]
///   penalty  stiffest that a traction may begin with, per area [force/length^3]
BondAnswer answer(const BondLaw& bond_law, const Opening& opening, double area, double penalty,
                  BondHistory& history);

/// The largest stiffness of a bond, for the stable step [force/length].
double bond_stiffness(const BondLaw& bond_law, double area, double penalty);

/// A point of a face, or a node, bonded to a point of a face by tractions or forces of its opening.
struct Bond : InterfaceConstraint {
  Eigen::Vector4d weights_1 = Eigen::Vector4d::Zero(), weights_2 = Eigen::Vector4d::Zero();  ///< sum 1 [1]
  Eigen::Vector3d rest =
      Eigen::Vector3d::Zero();  ///< between the points at the start, axes of the second face
  double size = 1.0;            ///< that the law counts with: the area, of laws in forces the share
  double penalty = 0.0;         ///< of the pair, per area [force/length^3]
  BondHistory history;
  bool has_failed = false;
};

/// What a step brings a bond.
struct BondStep {
  CornerForces forces;
  BondHistory history;  ///< after the step
  bool fails = false;
};

/// Forces of a bond where its corners are.
///   x  of the corners [length]
BondStep find_bond_step(const BondLaw& bond_law, const CornerVectors& x, const Bond& bond);

}  // namespace contactsim
