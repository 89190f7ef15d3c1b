// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/conditions/condition_scope.hpp"

namespace contactsim {

/// Sets the velocities that INITIAL VELOCITY blocks give. Components are set one by one; a direction or an
/// axis sets the whole vector. Of several blocks on one node the last in the deck counts, with a warning when
/// it changes what another gave: blocks of equal velocity may share nodes. A function is taken at the start
/// time. Errors: unknown names, values that are not finite.
///   velocity          [3 x n_nodes] [length/time]
///   angular_velocity  [3 x n_nodes] set where a whole vector is: about an axis all of it turns [1/time];
///   null:
///                     not wanted
void set_initial_velocity(const ConditionScope& scope, Eigen::Matrix3Xd& velocity,
                          Eigen::Matrix3Xd* angular_velocity = nullptr);

}  // namespace contactsim
