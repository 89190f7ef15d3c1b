// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/base/indices.hpp"

namespace contactsim {

struct State;

/// How the nodes moved in a step, for those who answer with forces.
struct Motion {
  double time;  ///< at the end of the step [time]
  double dt;    ///< its size; 0: no step yet, forces at the start are asked for [time]
  const Eigen::Matrix3Xd& coordinates;  ///< [3 x n_nodes] at the end of the step [length]
  const Eigen::Matrix3Xd& velocity;     ///< [3 x n_nodes] at its middle [length/time]
  /// The largest step that the terms asked before allow; infinite for the first [time]
  double stable_step = std::numeric_limits<double>::infinity();
  /// [3 x n_nodes] at the middle of the step, as velocity; null when no node turns [1/time]
  const Eigen::Matrix3Xd* angular_velocity = nullptr;
};

/// What a force term says of a step besides its forces.
struct ForceReport {
  double stable_step = std::numeric_limits<double>::infinity();  ///< the largest that the term allows [time]
  std::optional<ElementIndex> critical_element;                  ///< that sets it, if an element does
  double hourglass_work = 0.0;                                   ///< of the step [energy]
  double viscous_work = 0.0;                                     ///< of the step, on bulk viscosity [energy]
  double friction_work = 0.0;                                    ///< of the step, lost to friction [energy]
  double contact_damping_work = 0.0;  ///< of the step, lost to contact damping [energy]
  double impact_work = 0.0;           ///< of the step, lost where sides met without rebound [energy]
  double stabilization_work = 0.0;    ///< of the step, lost to contact stabilization [energy]
  double supplied_work = 0.0;         ///< of the step, put into contact by overlaps that are ramped [energy]
  std::span<const std::uint32_t> balanced_nodes = {};  ///< of the mesh, whose forces balance() has changed
};

/// Something that pushes the nodes: elements, loads, contact.
class ForceTerm {
 public:
  virtual ~ForceTerm() = default;

  /// Sets the forces at the end of a step, as they act on the nodes. Called once per step, in order, for
  /// terms with a memory. Throws SolveError when the motion cannot go on.
  ///   forces  [3 x n_nodes] [force]; whatever it held is gone
  virtual ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) = 0;

  /// Sets the moments that go with the forces of the last call of set_forces; none by default. Called only
  /// when nodes turn.
  ///   moments  [3 x n_nodes] [force length]; whatever it held is gone
  virtual void set_moments(const Motion& /*motion*/, Eigen::Matrix3Xd& moments) { moments.setZero(); }

  /// Adds the forces that depend on the motion which all other forces would give: those of constraints.
  /// Called once per step, after set_forces of all terms, when the size of the next step is known. Returns
  /// nothing when the term has no such forces; else set_moments is called again.
  ///   state   its accelerations are those of the forces so far, fixed and prescribed nodes and rigid bodies
  ///           included; its velocities those half a step before
  ///   forces  [3 x n_nodes] of set_forces, added to [force]
  virtual std::optional<ForceReport> balance(const State& /*state*/, Eigen::Matrix3Xd& /*forces*/) {
    return std::nullopt;
  }
};

}  // namespace contactsim
