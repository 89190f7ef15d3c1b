// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "core/mesh/indices.hpp"

namespace contactsim {

/// How the nodes moved in a step, for those who answer with forces.
struct Motion {
  double time;  ///< at the end of the step [time]
  double dt;    ///< its size; 0: no step yet, forces at the start are asked for [time]
  const Eigen::Matrix3Xd& coordinates;  ///< [3 x n_nodes] at the end of the step [length]
  const Eigen::Matrix3Xd& velocity;     ///< [3 x n_nodes] at its middle [length/time]
  /// The largest step that the terms asked before allow; infinite for the first [time]
  double stable_step = std::numeric_limits<double>::infinity();
};

/// What a force term says of a step besides its forces.
struct ForceReport {
  double stable_step = std::numeric_limits<double>::infinity();  ///< the largest that the term allows [time]
  std::optional<ElementIndex> critical_element;                  ///< that sets it, if an element does
  double hourglass_work = 0.0;                                   ///< of the step [energy]
  double viscous_work = 0.0;                                     ///< of the step, on bulk viscosity [energy]
  double friction_work = 0.0;                                    ///< of the step, lost to friction [energy]
  double contact_damping_work = 0.0;  ///< of the step, lost to contact damping [energy]
};

/// Something that pushes the nodes: elements, loads, contact.
class ForceTerm {
 public:
  virtual ~ForceTerm() = default;

  /// Sets the forces at the end of a step, as they act on the nodes. Called once per step, in order, for
  /// terms with a memory. Throws SolveError when the motion cannot go on.
  ///   forces  [3 x n_nodes] [force]; whatever it held is gone
  virtual ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) = 0;
};

}  // namespace contactsim
