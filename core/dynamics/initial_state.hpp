// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/dynamics/state.hpp"
#include "core/elements/model_block.hpp"

namespace contactsim {

/// Values that a number of the elements' state has at the start.
struct InitialElementValues {
  std::string variable;        ///< stress or a state variable of materials, folded
  std::size_t component = 0;   ///< from 0
  std::vector<double> values;  ///< [n_elements] NaN: left as it is [of the variable]
};

/// What the initial conditions of a region say of the start.
struct InitialState {
  Eigen::Matrix3Xd velocity;          ///< [3 x n_nodes], 3 x 0: that which the state has [length/time]
  Eigen::Matrix3Xd angular_velocity;  ///< [3 x n_nodes], 3 x 0 where no node turns [1/time]
  Eigen::Matrix3Xd displacement;      ///< [3 x n_nodes] from the mesh, 3 x 0: none [length]
  std::vector<InitialElementValues> element_values;  ///< in deck order
};

/// Carries out INITIAL VELOCITY, then INITIAL CONDITION in deck order; the last that sets a value counts.
/// Nodal variables are velocity and displacement; element variables are stress (xx yy zz xy yz zx) and what
/// the materials of the elements remember, such as eqps, the same at all integration points. A component may
/// be picked: stress(xx). READ VARIABLE without TIME reads at the start of the run.
/// Errors: unknown names, other variables, MAGNITUDE lines of a wrong length, what the mesh file does not
/// hold, values that are not finite. Temperatures are ignored with a warning. Throws FileError.
///   blocks  of the model
InitialState make_initial_state(const ConditionScope& scope, std::span<const ModelBlock> blocks);

/// Brings a state at rest to the start.
///   state  of the blocks
void set_initial_state(InitialState initial, std::span<const ModelBlock> blocks, State& state);

}  // namespace contactsim
