// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/memory_pages.hpp"
#include "core/base/state_archive.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

State make_state(const Eigen::Matrix3Xd& coordinates, std::span<const ModelBlock> blocks, double time,
                 Eigen::Matrix3Xd velocity, bool has_loads) {
  State state;
  state.time = time;
  const auto set_zero = [&](Eigen::Matrix3Xd& values) {
    resize_in_huge_pages(coordinates.cols(), values);
    values.setZero();
  };
  resize_in_huge_pages(coordinates.cols(), state.coordinates);
  state.coordinates = coordinates;
  state.velocity = std::move(velocity);
  if (state.velocity.cols() == 0) set_zero(state.velocity);
  set_zero(state.acceleration);
  set_zero(state.forces.internal);
  if (has_loads) set_zero(state.forces.external);
  const auto turns = [](const ModelBlock& block) { return block.element->has_rotations; };
  if (std::ranges::any_of(blocks, turns)) {
    NodalRotations& of = state.rotations;
    for (Eigen::Matrix3Xd* values :
         {&of.angle, &of.velocity, &of.acceleration, &of.moments.internal, &of.moments.external})
      set_zero(*values);
  }
  for (const ModelBlock& block : blocks) state.blocks.push_back(make_state(block));
  return state;
}

namespace {

/// A run goes on with loads where it had none before, and without those that it had.
void archive_loads(const std::string& name, NodalForces& forces, StateArchive& saved) {
  if (saved.restores() ? !saved.has(name) : forces.external.cols() == 0) return;
  Eigen::Matrix3Xd gone;
  Eigen::Matrix3Xd& external = forces.external.cols() == 0 ? gone : forces.external;
  external.resizeLike(forces.internal);
  saved.fixed(name, external);
}

void archive(const std::string& name, NodalForces& forces, StateArchive& saved) {
  saved.fixed(name + "/internal", forces.internal);
  archive_loads(name + "/external", forces, saved);
  saved.fixed(name + "/contact", forces.contact);
}

void archive(NodalRotations& rotations, bool have_contact, StateArchive& saved) {
  if (!rotations.exist()) return;
  saved.fixed("nodes/angle", rotations.angle);
  saved.fixed("nodes/angular_velocity", rotations.velocity);
  saved.fixed("nodes/angular_acceleration", rotations.acceleration);
  if (have_contact) rotations.moments.contact.resizeLike(rotations.moments.internal);
  archive("moments", rotations.moments, saved);
}

void archive(Energies& energies, StateArchive& saved) {
  saved.numbers("run/energies", energies.kinetic, energies.internal, energies.hourglass,
                energies.bulk_viscosity, energies.external, energies.contact, energies.friction,
                energies.contact_damping, energies.impact, energies.error, energies.unseen, energies.start,
                energies.largest);
  // Of load steps with contact stabilization alone.
  const std::string name = "run/stabilization_energy";
  if (saved.restores() ? saved.has(name) : energies.stabilization != 0.0)
    saved.numbers(name, energies.stabilization);
}

void archive(std::vector<RigidBodyState>& bodies, StateArchive& saved) {
  saved.rows("run/rigid_bodies", bodies, [](RigidBodyState& body, RowNumbers& row) {
    row(body.position, body.orientation.coeffs(), body.angle);
    for (RigidBodyState::Motion* motion : {&body.before, &body.now, &body.after})
      row(motion->velocity, motion->turning, motion->spin);
    row(body.acceleration, body.angular_acceleration, body.force, body.moment, body.reaction,
        body.reaction_moment);
  });
}

void archive(SubcycledNodes& nodes, StateArchive& saved) {
  const std::string name = "subcycles/numbers";
  if (!nodes.exist() && !(saved.restores() && saved.has(name))) return;
  std::uint64_t n_nodes = static_cast<std::uint64_t>(nodes.forces.cols());
  saved.expect("subcycles/n_nodes", n_nodes, "subcycled elements");
  HeldStableStep& stable = nodes.stable_step;
  saved.numbers(name, stable.now, stable.before, stable.count, stable.returning, nodes.first_dt,
                nodes.n_parts);
  saved.fixed("subcycles/forces", nodes.forces);
  saved.fixed("subcycles/moments", nodes.moments);
  saved.fixed("subcycles/acceleration", nodes.acceleration);
  saved.fixed("subcycles/angular_acceleration", nodes.angular_acceleration);
}

}  // namespace

void archive(State& state, StateArchive& saved) {
  saved.numbers("run/steps", state.step, state.time, state.dt, state.next_dt, state.first_dt);
  HeldStableStep& stable = state.stable_step;
  saved.numbers("run/stable_step", stable.now, stable.before, stable.count, stable.returning);
  saved.fixed("nodes/coordinates", state.coordinates);
  saved.fixed("nodes/velocity", state.velocity);
  saved.fixed("nodes/acceleration", state.acceleration);
  archive("forces", state.forces, saved);
  archive(state.rotations, state.forces.contact.cols() > 0, saved);
  archive(state.rigid, saved);
  archive(state.energies, saved);
  saved.numbers("run/half_step_work", state.begun.internal, state.begun.external, state.begun.contact);
  saved.numbers("run/momentum", state.momentum);
  archive(state.subcycled, saved);
  for (std::size_t i = 0; i < state.blocks.size(); ++i) {
    std::vector<Lanes>& values = state.blocks[i].values;
    saved.fixed(fmt::format("blocks/{}/values", i + 1),
                std::span(values.data()->data(), n_lanes * values.size()));
    saved.numbers(fmt::format("blocks/{}/hourglass_work", i + 1), state.blocks[i].hourglass_work);
    std::vector<Lanes>& life = state.blocks[i].life;
    if (!life.empty())
      saved.fixed(fmt::format("blocks/{}/life", i + 1),
                  std::span(life.data()->data(), n_lanes * life.size()));
  }
  saved.rows("death/dying", state.death.dying, [](DyingElement& dying, RowNumbers& row) {
    row(dying.element.value, dying.n_steps, dying.n_left);
  });
  saved.list("death/checked", state.death.checked);
}

}  // namespace contactsim
