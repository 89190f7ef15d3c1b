// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/integrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/errors.hpp"
#include "core/base/node_ranges.hpp"
#include "core/dynamics/energy_balance.hpp"
#include "core/dynamics/node_groups.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/dynamics/rigid_motion.hpp"
#include "core/dynamics/state_motion.hpp"
#include "core/dynamics/subcycler.hpp"

namespace contactsim {

namespace {

/// Has every term set the moments that go with its forces.
void set_moments(ForceTerms terms, const Motion& motion, NodalForces& moments) {
  terms.internal.set_moments(motion, moments.internal);
  terms.external.set_moments(motion, moments.external);
  if (terms.contact == nullptr) return;
  moments.contact.resizeLike(moments.internal);
  terms.contact->set_moments(motion, moments.contact);
}

/// Adds what contact reports of its step.
void add_contact(const ForceReport& contact, Energies& energies) {
  energies.friction += contact.friction_work;
  energies.contact_damping += contact.contact_damping_work;
  energies.impact += contact.impact_work;
  energies.external += contact.supplied_work;
  energies.contact += contact.supplied_work;
}

/// Springs of contact that leave less than this share of the elements' stable step are what sets it [1].
constexpr double share_of_elements = 0.5;

/// Has every term set its forces for the motion.
StepReport set_forces(ForceTerms terms, const Motion& motion, State& state) {
  Energies& energies = state.energies;
  const ForceReport internal = terms.internal.set_forces(motion, state.forces.internal);
  energies.hourglass += internal.hourglass_work;
  energies.bulk_viscosity += internal.viscous_work;
  StepReport step{internal.stable_step, internal.critical_element};
  const ForceReport external = terms.external.set_forces(motion, state.forces.external);
  step.stable_step = std::min(step.stable_step, external.stable_step);
  if (terms.contact != nullptr) {
    Motion known = motion;
    known.stable_step = step.stable_step;
    const ForceReport contact = terms.contact->set_forces(known, state.forces.contact);
    if (contact.stable_step < share_of_elements * step.stable_step) step.critical_element.reset();
    step.stable_step = std::min(step.stable_step, contact.stable_step);
    add_contact(contact, energies);
  }
  if (state.rotations.exist()) set_moments(terms, motion, state.rotations.moments);
  return step;
}

void accelerate(const NodeRanges& nodes, const Eigen::RowVectorXd& masses, const NodalForces& forces,
                Eigen::Matrix3Xd& acceleration) {
  const auto group_at = [](const Eigen::Matrix3Xd& values, Eigen::Index node) {
    return Eigen::Map<const NodeGroup>(values.data() + 3 * node);
  };
  nodes.visit([&](std::int64_t begin, std::int64_t end) {
    Eigen::Index node = begin;
    for (; node + nodes_per_group <= end; node += nodes_per_group) {
      NodeGroup sum = group_at(forces.internal, node);
      if (forces.external.size() > 0) sum += group_at(forces.external, node);
      if (forces.contact.size() > 0) sum += group_at(forces.contact, node);
      Eigen::Map<NodeGroup>(acceleration.data() + 3 * node) = sum / repeat_thrice(masses.data() + node);
    }
    for (; node < end; ++node) acceleration.col(node) = forces.at(node) / masses(node);
  });
}

/// The same of some nodes.
void accelerate(std::span<const std::uint32_t> nodes, const Eigen::RowVectorXd& masses,
                const NodalForces& forces, Eigen::Matrix3Xd& acceleration) {
  for (const std::uint32_t node : nodes) acceleration.col(node) = forces.at(node) / masses(node);
}

/// Brings velocities to the middle of the step and what they change to its end.
void move(const NodeRanges& nodes, double dt, const Eigen::Matrix3Xd& acceleration,
          Eigen::Matrix3Xd& velocity, Eigen::Matrix3Xd& changed) {
  double *v = velocity.data(), *x = changed.data();
  const double* a = acceleration.data();
  const double half = 0.5 * dt;
  nodes.visit([=](std::int64_t begin, std::int64_t end) {
#pragma omp simd
    for (std::int64_t i = 3 * begin; i < 3 * end; ++i) {
      v[i] += half * a[i];
      x[i] += dt * v[i];
    }
  });
}

void move(const NodeRanges& nodes, State& state) {
  move(nodes, state.dt, state.acceleration, state.velocity, state.coordinates);
  NodalRotations& rotations = state.rotations;
  if (rotations.exist()) move(nodes, state.dt, rotations.acceleration, rotations.velocity, rotations.angle);
}

/// A time between steps as the conditions of rotations see it.
BetweenSteps between_turns(const State& state, double dt_before, double dt_after) {
  const NodalRotations& rotations = state.rotations;
  return {state.time, dt_before, dt_after, state.coordinates, rotations.velocity, &rotations.angle};
}

/// Names the first node whose motion is not finite.
[[noreturn]] void stop_at_non_finite(const Model& model, State& state, RankShare* share) {
  if (share != nullptr) share->complete_nodes(state);
  for (std::uint32_t node = 0; node < model.mesh->n_nodes(); ++node) {
    const auto acceleration = state.acceleration.col(node);
    const bool is_massless = model.mass(node) <= minimum_nodal_mass && !acceleration.isZero(0.0);
    if (acceleration.allFinite() && state.velocity.col(node).allFinite() && !is_massless) continue;
    const char* cause = is_massless ? "has no mass but is pushed" : "moves without bound";
    throw SolveError(state.time, fmt::format("node {} {}", model.mesh->node_id({node}), cause));
  }
  for (std::uint32_t node = 0; node < state.rotations.velocity.cols(); ++node) {
    const auto acceleration = state.rotations.acceleration.col(node);
    const bool is_massless = model.inertia(node) <= minimum_nodal_mass && !acceleration.isZero(0.0);
    if (acceleration.allFinite() && state.rotations.velocity.col(node).allFinite() && !is_massless) continue;
    const char* cause = is_massless ? "has no rotations but is turned by a moment" : "turns without bound";
    throw SolveError(state.time, fmt::format("node {} {}", model.mesh->node_id({node}), cause));
  }
  std::uint32_t fastest = 0;
  for (std::uint32_t node = 1; node < model.mesh->n_nodes(); ++node) {
    if (state.velocity.col(node).stableNorm() > state.velocity.col(fastest).stableNorm()) fastest = node;
  }
  throw SolveError(state.time,
                   fmt::format("the energy is not finite; node {} is the fastest, at a speed of {:.3g}",
                               model.mesh->node_id({fastest}), state.velocity.col(fastest).stableNorm()));
}

/// A run whose steps become this small, next to the first one, would not end: an element that is pressed flat
/// makes them shrink faster than it closes.
constexpr double vanishing = 1e-4;

void check_step(const Model& model, const State& state, const StepReport& report) {
  const double dt = state.next_dt;
  if (std::isinf(dt))
    throw SolveError(state.time,
                     "nothing in the model sets a time step: no element has stiffness and nothing touches; "
                     "USER TIME STEP gives one");
  if (dt > vanishing * state.first_dt && state.time + dt > state.time) return;
  std::string cause = fmt::format("the stable time step has fallen to {:.3g}", dt);
  if (report.critical_element) {
    cause += fmt::format(", set by element {}", model.mesh->element_id(*report.critical_element));
  } else if (state.forces.contact.size() > 0) {
    cause += ", set by the stiffness of contact: its PENALTY STIFFNESS, PENALTY SCALE or pressure function";
  }
  throw SolveError(state.time, cause);
}

void update_energies(const EnergyBalance& balance, State& state) {
  Energies& energies = state.energies;
  energies.kinetic = balance.kinetic;
  if (state.step == 0) energies.unseen = balance.unseen;
  energies.internal -= state.begun.internal + balance.ended.internal + (balance.unseen - energies.unseen);
  energies.unseen = balance.unseen;
  energies.external += state.begun.external + balance.ended.external;
  energies.contact -= state.begun.contact + balance.ended.contact;
  state.begun = balance.begun;
  state.momentum = balance.momentum;
  const double seen = balance.conserved + balance.unseen;
  if (state.step == 0) energies.start += seen + energies.contact;
  energies.error = seen + energies.internal + energies.contact - energies.external - energies.start;
  for (const double term : {energies.kinetic, energies.internal, energies.external, energies.contact})
    energies.largest = std::max(energies.largest, std::abs(term));
}

/// Holds and drives what conditions say, and rigid bodies.
void constrain(const Model& model, State& state) {
  model.kinematic_constraints.constrain(
      {state.time, state.dt, state.next_dt, state.coordinates, state.velocity}, state.acceleration);
  NodalRotations& rotations = state.rotations;
  if (rotations.exist()) {
    model.rotation_constraints.constrain(between_turns(state, state.dt, state.next_dt),
                                         rotations.acceleration);
  }
  if (!model.rigid.empty()) drive_rigid_bodies(model, state);
}

/// The accelerations that the forces give, fixed and prescribed nodes and rigid bodies included.
void find_accelerations(const Model& model, const NodeRanges& nodes, State& state) {
  accelerate(nodes, model.mass, state.forces, state.acceleration);
  NodalRotations& rotations = state.rotations;
  if (rotations.exist()) accelerate(nodes, model.inertia, rotations.moments, rotations.acceleration);
  constrain(model, state);
}

/// Has contact balance the momentum of what meets in the coming step.
void balance_contact(const Model& model, ForceTerms terms, State& state) {
  if (terms.contact == nullptr) return;
  const auto report = terms.contact->balance(state, state.forces.contact);
  if (!report) return;
  add_contact(*report, state.energies);
  accelerate(report->balanced_nodes, model.mass, state.forces, state.acceleration);
  NodalRotations& rotations = state.rotations;
  if (rotations.exist()) {
    terms.contact->set_moments(motion_of(state), rotations.moments.contact);
    accelerate(report->balanced_nodes, model.inertia, rotations.moments, rotations.acceleration);
  }
  constrain(model, state);
}

/// What accelerations leave of the kinetic energy between half steps at the start, where the leapfrog stands
/// mirrored: |v0|^2 - |v - v0|^2.
double energy_at_start(const Model& model, State& state, RankShare* share) {
  if (share != nullptr) share->complete_nodes(state);
  const double half = 0.5 * state.next_dt;
  const NodalRotations& rotations = state.rotations;
  EnergyBalance bodies;
  if (!model.rigid.empty()) add_rigid_balance(model, state, bodies);
  double changed = 0.0;
  for (std::uint32_t i = 0; i < model.mesh->n_nodes(); ++i) {
    if (!model.rigid.nodes.is_free({i})) continue;
    changed += model.mass(i) * state.acceleration.col(i).squaredNorm();
    if (rotations.exist()) changed += model.inertia(i) * rotations.acceleration.col(i).squaredNorm();
  }
  return bodies.conserved - 0.5 * half * half * changed;
}

/// Chooses the next step, constrains the accelerations and completes velocities, energies and momentum.
void complete(const Model& model, ForceTerms terms, const TimeStepControl& control, const StepReport& report,
              State& state, RankShare* share) {
  const NodeRanges all(model.mesh->n_nodes());
  const NodeRanges& nodes = share != nullptr ? share->followed() : all;
  state.next_dt = control.step_after(state.time, state.dt, state.stable_step.take(report.stable_step));
  if (state.step == 0) state.first_dt = state.next_dt;
  check_step(model, state, report);
  find_accelerations(model, nodes, state);
  const double free = state.step == 0 ? energy_at_start(model, state, share) : 0.0;
  balance_contact(model, terms, state);
  if (state.step == 0) state.energies.contact = free - energy_at_start(model, state, share);
  EnergyBalance balance = complete_velocities(model, state, share);
  if (!model.rigid.empty()) add_rigid_balance(model, state, balance);
  if (!std::isfinite(balance.kinetic + balance.conserved)) stop_at_non_finite(model, state, share);
  update_energies(balance, state);
  if (!std::isfinite(state.energies.error)) stop_at_non_finite(model, state, share);
}

}  // namespace

StepReport start(const Model& model, ForceTerms forces, const TimeStepControl& control, State& state,
                 RankShare* share) {
  if (!model.rigid.empty()) start_rigid_bodies(model, state);
  const Motion motion = motion_of(state, 0.0);
  StepReport report = set_forces(forces, motion, state);
  const double dt = control.step_after(state.time, 0.0, report.stable_step);
  model.kinematic_constraints.constrain_velocity({state.time, 0.0, dt, state.coordinates, state.velocity},
                                                 state.velocity);
  if (state.rotations.exist())
    model.rotation_constraints.constrain_velocity(between_turns(state, 0.0, dt), state.rotations.velocity);
  report = set_forces(forces, motion, state);  // bulk viscosity depends on the velocities
  if (forces.subcycler != nullptr) forces.subcycler->start();
  complete(model, forces, control, report, state, share);
  if (forces.subcycler != nullptr) forces.subcycler->end_step();
  return report;
}

StepReport advance(const Model& model, ForceTerms forces, const TimeStepControl& control, State& state,
                   RankShare* share) {
  if (forces.subcycler != nullptr) forces.subcycler->begin_step();
  state.dt = state.next_dt;
  state.time += state.dt;
  ++state.step;
  const NodeRanges all(model.mesh->n_nodes());
  move(share != nullptr ? share->followed() : all, state);
  if (!model.rigid.empty()) move_rigid_bodies(model, state);
  if (forces.subcycler != nullptr) forces.subcycler->move(control);
  const Motion motion = motion_of(state, state.dt);
  const StepReport report = set_forces(forces, motion, state);
  if (forces.subcycler != nullptr) forces.subcycler->end_move();
  complete(model, forces, control, report, state, share);
  if (forces.subcycler != nullptr) forces.subcycler->end_step();
  return report;
}

}  // namespace contactsim
