// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/dynamics/state.hpp"
#include "core/statics/static_bodies.hpp"
#include "core/statics/static_unknowns.hpp"
#include "core/statics/step_start.hpp"

namespace contactsim {

/// The forces and moments of a load step as vectors of unknowns: those of its state now and of its start. On
/// nodes, unless they are summed over rigid bodies. A view, to be used while what it refers to stays.
struct StepForces {
  /// Internal, external or contact.
  using Part = Eigen::Matrix3Xd NodalForces::*;

  const StaticUnknowns& unknowns;
  const StaticBodies& bodies;
  const State& state;
  const StepStart& start;

  Eigen::VectorXd now(Part part) const {
    return unknowns.vector_of(state.forces.*part, state.rotations.moments.*part);
  }
  Eigen::VectorXd at_start(Part part) const {
    return unknowns.vector_of(start.forces().*part, start.rotations().moments.*part);
  }
  Eigen::VectorXd mean(Part part) const { return 0.5 * (at_start(part) + now(part)); }
  /// The sum of all three parts.
  Eigen::VectorXd all() const;
  /// The same of the start, summed over bodies where they were.
  Eigen::VectorXd all_at_start() const;
  /// Forces summed over bodies where they are now.
  Eigen::VectorXd gathered(Eigen::VectorXd forces) const {
    bodies.gather(forces);
    return forces;
  }
};

}  // namespace contactsim
