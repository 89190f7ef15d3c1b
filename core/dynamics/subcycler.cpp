// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/subcycler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/errors.hpp"
#include "core/base/threads.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/dynamics/state_motion.hpp"

namespace contactsim {

namespace {

double clock_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Copies the columns of some nodes.
void take(std::span<const NodeIndex> nodes, const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    to.col(static_cast<Eigen::Index>(i)) = from.col(nodes[i].value);
}
void put(const Eigen::Matrix3Xd& from, std::span<const NodeIndex> nodes, Eigen::Matrix3Xd& to) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    to.col(nodes[i].value) = from.col(static_cast<Eigen::Index>(i));
}

}  // namespace

Subcycler::Subcycler(const Model& model, State& state) : model_(model), state_(state) {
  const auto& nodes = model.subcycles.nodes;
  std::vector<std::uint32_t> position(model.mesh->n_nodes(), 0);
  for (std::uint32_t i = 0; i < nodes.size(); ++i) position[nodes[i].value] = i;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const ModelBlock& block = model.blocks[b];
    std::vector<std::uint32_t> positions;
    for (const std::uint32_t node : block.chunk_nodes) positions.push_back(position[node]);
    sums_.emplace_back(positions, nodes.size(), find_places(block, true));
    for (std::size_t c = 0; c < block.chunks.size(); ++c) {
      if (block.chunks[c].is_subcycled) chunks_.push_back({b, c});
    }
  }
  steps_.resize(chunks_.size());
  SubcycledNodes& own = state.subcycled;
  const auto set_up = [&](Nodes& moved, const Eigen::RowVectorXd& mass, Eigen::Matrix3Xd& place,
                          Eigen::Matrix3Xd& velocity, Eigen::Matrix3Xd& forces) {
    const bool exist = velocity.cols() > 0;
    const Eigen::Matrix3Xd zero = Eigen::Matrix3Xd::Zero(3, exist ? size() : 0);
    moved = {&mass, &place, &velocity, &forces, zero, zero, zero, zero, {}, {}, {}, {}};
    moved.is_held.assign(nodes.size(), 0);
    forces = zero;
    return zero;
  };
  own.acceleration = set_up(moving_, model.mass, state.coordinates, state.velocity, own.forces);
  NodalRotations& turns = state.rotations;
  own.angular_acceleration = set_up(turning_, model.inertia, turns.angle, turns.velocity, own.moments);
}

/// Finds what conditions leave free in the step that begins now.
void Subcycler::find_free(const KinematicConstraints& constraints, Nodes& nodes) const {
  const auto active = constraints.find_active(state_.time);
  if (active.empty() || active == nodes.active) return;
  nodes.active = active;
  nodes.held.clear();
  nodes.free.clear();
  std::ranges::fill(nodes.is_held, 0);
  const auto& all = model_.subcycles.nodes;
  for (const FreeDirections& free : constraints.find_free_directions(state_.time)) {
    const auto at = std::ranges::lower_bound(all, free.node);
    if (at == all.end() || *at != free.node || free.projection == Eigen::Matrix3d::Identity()) continue;
    nodes.held.push_back(at - all.begin());
    nodes.free.push_back(free.projection);
    nodes.is_held[static_cast<std::size_t>(at - all.begin())] = 1;
  }
}

void Subcycler::add_chunks(double time, double dt) {
  Motion motion{time, dt, state_.coordinates, state_.velocity};
  if (state_.rotations.exist()) motion.angular_velocity = &state_.rotations.velocity;
  parallel_for(chunks_.size(), threads_for(model_.subcycles.n_elements * 10), [&](std::size_t i) {
    const ModelBlock& block = model_.blocks[chunks_[i].block];
    steps_[i] = block.element->advance(block, block.chunks[chunks_[i].chunk], motion,
                                       state_.blocks[chunks_[i].block]);
  });
  double stable = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const ModelBlock& block = model_.blocks[chunks_[i].block];
    const ChunkStep& step = steps_[i];
    if (!(step.min_volume > 0.0))
      stop_at_inverted(*model_.mesh, block, {&block.chunks[chunks_[i].chunk], 1}, motion);
    if (step.stable_step < stable) {
      stable = step.stable_step;
      critical_ = {block.first_element.value + static_cast<std::uint32_t>(step.critical_element)};
    }
    state_.energies.hourglass += step.hourglass_work;
    state_.blocks[chunks_[i].block].hourglass_work += step.hourglass_work;
    state_.energies.bulk_viscosity += step.viscous_work;
  }
  state_.subcycled.stable_step.take(stable);
}

void Subcycler::accelerate(Nodes& nodes) const {
  const auto& all = model_.subcycles.nodes;
  parallel_for(size(), threads_for(all.size()), [&](Eigen::Index i) {
    const Eigen::Index node = all[static_cast<std::size_t>(i)].value;
    nodes.small.col(i) = nodes.forces->col(i) / (*nodes.mass)(node);
  });
  for (std::size_t k = 0; k < nodes.held.size(); ++k)
    nodes.small.col(nodes.held[k]) = (nodes.free[k] * nodes.small.col(nodes.held[k])).eval();
}

void Subcycler::set_forces(double time, double dt) {
  add_chunks(time, dt);
  moving_.forces->setZero();
  turning_.forces->setZero();
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    sums_[b].add(state_.blocks[b].forces, *moving_.forces);
    if (!state_.blocks[b].moments.empty()) sums_[b].add(state_.blocks[b].moments, *turning_.forces);
  }
  accelerate(moving_);
  if (state_.rotations.exist()) accelerate(turning_);
}

/// Sums what act(position, node) gives, in a fixed order.
template <class Act>
Subcycler::Works Subcycler::sum_works(const Act& act) const {
  constexpr std::size_t per_sum = 2048;
  const auto& all = model_.subcycles.nodes;
  const auto sum = [&](std::size_t first) {
    Works works;
    for (std::size_t i = first; i < std::min(first + per_sum, all.size()); ++i) {
      const Works one = act(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(all[i].value));
      works.internal += one.internal;
      works.reaction += one.reaction;
    }
    return works;
  };
  std::vector<Works> parts((all.size() + per_sum - 1) / per_sum);
  parallel_for(parts.size(), threads_for(all.size()), [&](std::size_t i) { parts[i] = sum(i * per_sum); });
  Works works;
  for (const Works& part : parts) {
    works.internal += part.internal;
    works.reaction += part.reaction;
  }
  return works;
}

/// v += span a_small; the work of an impulse is its product with the mean of the velocities before and after.
Subcycler::Works Subcycler::kick(Nodes& nodes, double span) const {
  return sum_works([&](Eigen::Index i, Eigen::Index node) {
    const Eigen::Vector3d before = nodes.velocity->col(node), change = span * nodes.small.col(i);
    nodes.velocity->col(node) = before + change;
    const Eigen::Vector3d way = span * (before + 0.5 * change), force = nodes.forces->col(i);
    Works works{force.dot(way), 0.0};
    if (nodes.is_held[static_cast<std::size_t>(i)] != 0)
      works.reaction = ((*nodes.mass)(node)*nodes.small.col(i) - force).dot(way);
    return works;
  });
}

Subcycler::Works Subcycler::kick_and_drift(Nodes& nodes, double dt) const {
  const Works works = kick(nodes, 0.5 * dt);
  const auto& all = model_.subcycles.nodes;
  parallel_for(size(), threads_for(all.size()), [&](Eigen::Index i) {
    const Eigen::Index node = all[static_cast<std::size_t>(i)].value;
    const Eigen::Vector3d way = dt * nodes.velocity->col(node);
    nodes.position->col(node) += way;
    nodes.way.col(i) += way;
  });
  return works;
}

void Subcycler::count(const Works& works) {
  state_.energies.internal -= works.internal;
  state_.energies.external += works.reaction;
}

/// The part that begins now: what is left of the step in equal ones.
double Subcycler::part_of(double left, double time, const TimeStepControl& control) {
  constexpr double round_off = 1e-9;
  const double stable = control.scale_factor_at(time) * state_.subcycled.stable_step.held();
  const double dt = left / std::max(1.0, std::ceil(left / stable - round_off));
  SubcycledNodes& own = state_.subcycled;
  if (own.first_dt == 0.0) own.first_dt = dt;
  constexpr double vanishing = 1e-4;
  if (dt > vanishing * own.first_dt) return dt;
  std::string cause = fmt::format("the stable time step of subcycled elements has fallen to {:.3g}", stable);
  if (critical_) cause += fmt::format(", set by element {}", model_.mesh->element_id(*critical_));
  throw SolveError(time, cause);
}

void Subcycler::start() { set_forces(state_.time, 0.0); }

/// What the small forces accelerate in the part that begins now: conditions may come and go with it.
void Subcycler::accelerate() {
  find_free(model_.kinematic_constraints, moving_);
  accelerate(moving_);
  if (!state_.rotations.exist()) return;
  find_free(model_.rotation_constraints, turning_);
  accelerate(turning_);
}

void Subcycler::begin_step() {
  accelerate();
  const auto& all = model_.subcycles.nodes;
  put(state_.subcycled.acceleration, all, state_.acceleration);
  take(all, state_.coordinates, moving_.begun);
  if (!state_.rotations.exist()) return;
  put(state_.subcycled.angular_acceleration, all, state_.rotations.acceleration);
  take(all, state_.rotations.angle, turning_.begun);
}

void Subcycler::move(const TimeStepControl& control) {
  const double clock = clock_now(), step = state_.dt, begun = state_.time - step;
  const bool turn = state_.rotations.exist();
  const auto& all = model_.subcycles.nodes;
  for (Nodes* nodes : {&moving_, &turning_}) {
    if (nodes->begun.cols() == 0) continue;
    put(nodes->begun, all, *nodes->position);
    nodes->way.setZero();
  }
  for (double left = step; left > 0.0;) {
    const double dt = part_of(left, state_.time - left, control);
    left = dt < left ? left - dt : 0.0;
    count(kick_and_drift(moving_, dt));
    if (turn) count(kick_and_drift(turning_, dt));
    set_forces(left > 0.0 ? begun + (step - left) : state_.time, dt);
    count(kick(moving_, 0.5 * dt));
    if (turn) count(kick(turning_, 0.5 * dt));
    ++state_.subcycled.n_parts;
  }
  for (Nodes* nodes : {&moving_, &turning_}) {
    if (nodes->begun.cols() == 0) continue;
    take(all, *nodes->velocity, nodes->ended);
    nodes->way /= step;
    put(nodes->way, all, *nodes->velocity);
  }
  seconds_ += clock_now() - clock;
}

void Subcycler::end_move() {
  const auto& all = model_.subcycles.nodes;
  put(moving_.ended, all, state_.velocity);
  if (state_.rotations.exist()) put(turning_.ended, all, state_.rotations.velocity);
}

void Subcycler::end_step() {
  const auto& all = model_.subcycles.nodes;
  SubcycledNodes& own = state_.subcycled;
  accelerate();
  take(all, state_.acceleration, own.acceleration);
  if (state_.rotations.exist()) take(all, state_.rotations.acceleration, own.angular_acceleration);
  const auto add = [&](Nodes& nodes, Eigen::Matrix3Xd& acceleration, Eigen::Matrix3Xd& forces) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      acceleration.col(all[i].value) += nodes.small.col(static_cast<Eigen::Index>(i));
      forces.col(all[i].value) += nodes.forces->col(static_cast<Eigen::Index>(i));
    }
  };
  add(moving_, state_.acceleration, state_.forces.internal);
  if (state_.rotations.exist())
    add(turning_, state_.rotations.acceleration, state_.rotations.moments.internal);
}

}  // namespace contactsim
