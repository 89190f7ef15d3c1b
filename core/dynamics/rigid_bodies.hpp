// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/conditions/kinematic_constraints.hpp"
#include "core/rigid/rigid_body.hpp"
#include "core/rigid/rigid_nodes.hpp"

namespace contactsim {

/// The rigid bodies of a model. Conditions on them act on their centres.
struct RigidBodies {
  std::vector<RigidBody> bodies;
  RigidNodes nodes;
  Eigen::RowVectorXd free_mass;  ///< as Model::mass, but 0 of nodes that are not free; empty without bodies
  Eigen::RowVectorXd free_inertia;             ///< as Model::inertia in the same way
  KinematicConstraints kinematic_constraints;  ///< its nodes are the bodies
  KinematicConstraints rotation_constraints;   ///< the same

  bool empty() const { return bodies.empty(); }
};

}  // namespace contactsim
