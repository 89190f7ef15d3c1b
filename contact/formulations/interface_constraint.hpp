// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "core/base/row_numbers.hpp"
#include "core/interface_laws/bond_law.hpp"

namespace contactsim {

/// Vectors of the corners of two sides [3 x 8]: those of the first, then those of the second.
using CornerVectors = Eigen::Matrix<double, 3, 8>;

/// A face, or a node, that something holds to a face.
struct InterfaceConstraint {
  PairIndex pair;
  bool is_swapped = false;         ///< the first side is of the pair's second surface
  std::uint32_t first_entity = 0;  ///< face or surface node
  FaceIndex second;
  bool is_node = false;                     ///< the first side is a node
  std::array<ContactNodeIndex, 8> nodes{};  ///< contact nodes of the corners
  Eigen::Matrix<double, 8, 1> springs =
      Eigen::Matrix<double, 8, 1>::Zero();  ///< each corner's share of the springs [force/length]
  double area = 0.0;                        ///< [length^2]
  double share = 1.0;  ///< of a whole constraint, where pairs that go both ways share it [1]

  FaceIndex first_face() const { return {first_entity}; }
  SurfaceNodeIndex row() const { return {first_entity}; }
};

/// The forces of an interface constraint on its corners; all 0 of a tie that does not act.
struct CornerForces {
  CornerVectors forces;     ///< [force]
  Eigen::Vector3d normal;   ///< of the second side, unit [1]
  double stored = 0.0;      ///< in the springs [energy]
  double dissipated = 0.0;  ///< in the step, by damage and failure [energy]
};

/// A constraint that held in a step, and by which forces.
struct ConstraintForces {
  InterfaceConstraint constraint;
  CornerForces forces;
  std::size_t index = 0;     ///< of the constraint in the formulation that found it
  bool fails = false;        ///< it holds for the last time
  BondHistory history = {};  ///< of a bond, after the step
};

/// The constraint that is behind some forces.
inline InterfaceConstraint& constraint_of(ConstraintForces& forces) { return forces.constraint; }
inline InterfaceConstraint& constraint_of(InterfaceConstraint& constraint) { return constraint; }

/// Axes that turn with a face: a diagonal, at right angles to it, the normal.
Eigen::Matrix3d axes_of(const FaceCorners& x);

/// Adds forces to those of the second side so that neither force nor moment is left over.
///   arms  of the corners, from any point near [length]
void balance(const CornerVectors& arms, CornerVectors& forces);

/// How the corners of a face carry a point that stands off the face and turns with it: the point's velocity
/// is the sum of a matrix times the velocity of each corner.
///   offset  from the point of the face with these weights [length]
std::array<Eigen::Matrix3d, 4> carry_point(const FaceCorners& x, const Eigen::Vector4d& weights,
                                           const Eigen::Vector3d& offset);

/// The rule that holds for the sides of a constraint.
const PairRule& rule_of(const ContactStepContext& context, const InterfaceConstraint& constraint);

/// Where the corners of a constraint are [length].
CornerVectors corners_of(const ContactStepContext& context, const InterfaceConstraint& constraint);

/// Goes over to other faces and nodes. Returns whether both sides are still there.
bool keep_constraint(const ContactRemap& remap, InterfaceConstraint& constraint);
/// The same of many: what held a side that is removed is over.
template <class Constraint>
void keep_constraints(const ContactRemap& remap, std::vector<Constraint>& constraints) {
  std::size_t n = 0;
  for (Constraint& constraint : constraints) {
    if (keep_constraint(remap, constraint_of(constraint))) constraints[n++] = constraint;
  }
  constraints.resize(n);
}

/// Lists what every kind of constraint saves.
void visit_constraint(InterfaceConstraint& constraint, RowNumbers& row);

}  // namespace contactsim
