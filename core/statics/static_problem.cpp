// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_problem.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/base/threads.hpp"
#include "core/dynamics/state_motion.hpp"

namespace contactsim {

namespace {

/// A share of the distance between nodes that changes strains by 1e-6: far above round-off and far below what
/// bends a stress-strain curve.
constexpr double probe_share = 1e-6;

/// What stands for the distance between nodes: the diagonal of the model's box over the cube root of their
/// number [length].
double node_distance(const Eigen::Matrix3Xd& coordinates) {
  const Eigen::Vector3d box = coordinates.rowwise().maxCoeff() - coordinates.rowwise().minCoeff();
  return box.norm() / std::cbrt(static_cast<double>(coordinates.cols()));
}

/// Turns moments into forces at the radius of gyration that a node's inertia has.
Eigen::VectorXd residual_weights(const Model& model, Eigen::Index n, Eigen::Index size) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(size);
  for (Eigen::Index i = n; i < size; ++i) {
    const Eigen::Index node = (i - n) / 3;
    if (node >= model.inertia.cols()) break;  // those of rigid bodies have displacements alone
    const double mass = model.mass(0, node), inertia = model.inertia(0, node);
    weights(i) = inertia > minimum_nodal_mass ? mass / inertia : 0.0;
  }
  return weights;
}

void copy_values(const std::vector<Lanes>& from, std::vector<Lanes>& to) {
  to.resize(from.size());
  const auto n = static_cast<std::int64_t>(from.size());
  parallel_for_ranges(n, threads_for(from.size()), [&](std::int64_t begin, std::int64_t end) {
    std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin);
  });
}

/// Projects the vectors of held nodes on their free directions.
///   first  of the nodes' part
void project_nodes(const std::vector<FreeDirections>& free, Eigen::Index first, Eigen::VectorXd& vector) {
  for (const FreeDirections& node : free) {
    auto part = vector.segment<3>(first + 3 * static_cast<Eigen::Index>(node.node.value));
    part = (node.projection * part).eval();
  }
}

}  // namespace

StaticProblem::StaticProblem(const Model& model, ForceTerms terms, StaticContact* contact,
                             ResidualReference reference, State& state)
    : model_(model),
      terms_(terms),
      contact_(contact),
      kind_(reference),
      state_(state),
      bodies_(model, state),
      n_mesh_(state.coordinates.size()),
      n_(3 * Eigen::Index{bodies_.n_nodes()}),
      probe_length_(probe_share * node_distance(state.coordinates)),
      weights_(residual_weights(model, n_, size())) {}

Eigen::VectorXd StaticProblem::forces_of(Part part, const NodalForces& forces,
                                         const NodalForces& moments) const {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(size());
  if ((forces.*part).size() > 0) vector.head(n_mesh_) = (forces.*part).reshaped();
  if (size() > n_ && (moments.*part).size() > 0) vector.segment(n_, n_mesh_) = (moments.*part).reshaped();
  return vector;
}

Eigen::VectorXd StaticProblem::mean_forces(Part part) const {
  return 0.5 * (forces_of(part, forces_, rotations_.moments) + forces_of(part));
}

/// On nodes; those on bodies are not summed yet.
Eigen::VectorXd StaticProblem::all_forces() const {
  return forces_of(&NodalForces::internal) + forces_of(&NodalForces::external) +
         forces_of(&NodalForces::contact);
}

/// Summed over bodies where they were.
Eigen::VectorXd StaticProblem::all_forces_of_start() const {
  Eigen::VectorXd forces = forces_of(&NodalForces::internal, forces_, rotations_.moments) +
                           forces_of(&NodalForces::external, forces_, rotations_.moments) +
                           forces_of(&NodalForces::contact, forces_, rotations_.moments);
  bodies_.gather_at_start(forces);
  return forces;
}

void StaticProblem::find_free() {
  free_ = model_.kinematic_constraints.find_free_directions(state_.time);
  bodies_.add_free(free_);
  if (state_.rotations.exist())
    free_rotations_ = model_.rotation_constraints.find_free_directions(state_.time);
  hold_nodes();
}

void StaticProblem::begin() {
  find_free();
  largest_reference_ = reference_now();
  bodies_.note_forces(free_);
}

void StaticProblem::let_go_until(double time) {
  held_ = gathered(all_forces());
  project(held_);
  held_from_ = state_.time;
  held_until_ = time;
}

/// How much of it is still held [1].
double StaticProblem::share_held(double time) const {
  if (held_.size() == 0) return 0.0;
  return std::clamp((held_until_ - time) / (held_until_ - held_from_), 0.0, 1.0);
}

void StaticProblem::remember() {
  time_ = state_.time;
  coordinates_ = state_.coordinates;
  velocity_ = state_.velocity;
  rotations_ = state_.rotations;
  forces_ = state_.forces;
  element_values_.resize(state_.blocks.size());
  hourglass_work_.clear();
  for (std::size_t i = 0; i < state_.blocks.size(); ++i) {
    copy_values(state_.blocks[i].values, element_values_[i]);
    hourglass_work_.push_back(state_.blocks[i].hourglass_work);
  }
}

void StaticProblem::begin_step(double dt) {
  remember();
  dt_ = dt;
  if (contact_ != nullptr) {
    Motion motion = motion_of(state_, dt);
    motion.time += dt;
    contact_->begin_trials(motion);
  }
  bodies_.begin_step();
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, n_mesh_ / 3);
  // An acceleration from rest whose half step brings the mean velocity of the step about.
  const auto increment_of = [&](const KinematicConstraints& constraints, const Eigen::Matrix3Xd* angle) {
    Eigen::Matrix3Xd acceleration = still;
    constraints.constrain({state_.time, dt, dt, state_.coordinates, still, angle}, acceleration);
    return Eigen::VectorXd(dt * dt * acceleration.reshaped());
  };
  prescribed_.setZero(size());
  prescribed_.head(n_mesh_) = increment_of(model_.kinematic_constraints, nullptr);
  bodies_.set_prescribed(dt, prescribed_);
  find_free();
  if (state_.rotations.exist())
    prescribed_.segment(n_, n_mesh_) = increment_of(model_.rotation_constraints, &state_.rotations.angle);
  let_go_ = has_deaths_ ? unbalanced_at_start() : Eigen::VectorXd();
}

void StaticProblem::recall_elements() {
  for (std::size_t i = 0; i < state_.blocks.size(); ++i) {
    copy_values(element_values_[i], state_.blocks[i].values);
    state_.blocks[i].hourglass_work = hourglass_work_[i];
  }
}

void StaticProblem::restore() {
  recall_elements();
  state_.time = time_;
  state_.coordinates = coordinates_;
  state_.velocity = velocity_;
  state_.rotations = rotations_;
  state_.forces = forces_;
  bodies_.restore();
  if (contact_ != nullptr) contact_->give_up_trials();
}

void StaticProblem::move_to(const Eigen::VectorXd& increment) {
  state_.time = time_ + dt_;
  increment_ = increment.head(n_mesh_).cwiseAbs().maxCoeff();  // rigid motion alone rounds nothing off
  state_.coordinates = coordinates_ + increment.head(n_mesh_).reshaped(3, n_mesh_ / 3);
  state_.velocity = increment.head(n_mesh_).reshaped(3, n_mesh_ / 3) / dt_;
  if (state_.rotations.exist()) {
    const auto turns = increment.segment(n_, n_mesh_).reshaped(3, n_mesh_ / 3);
    state_.rotations.angle = rotations_.angle + turns;
    state_.rotations.velocity = turns / dt_;
  }
  bodies_.move(increment, dt_, coordinates_);
}

Eigen::Matrix3Xd StaticProblem::coordinates_at(const Eigen::VectorXd& increment) const {
  Eigen::Matrix3Xd coordinates(3, n_ / 3);
  coordinates.leftCols(n_mesh_ / 3) = coordinates_ + increment.head(n_mesh_).reshaped(3, n_mesh_ / 3);
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    coordinates.col(bodies_.centre_node(i)) = state_.rigid[i].position;
    coordinates.col(bodies_.turning_node(i)) = state_.rigid[i].position;
  }
  return coordinates;
}

Eigen::VectorXd StaticProblem::steady_motion(double duration) const {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(size());
  motion.head(n_mesh_) = duration * state_.velocity.reshaped();
  if (state_.rotations.exist()) motion.segment(n_, n_mesh_) = duration * state_.rotations.velocity.reshaped();
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    const RigidBodyState::Motion& now = state_.rigid[i].now;
    for (const NodeIndex node : bodies_.body(i).nodes) {
      motion.segment<3>(3 * Eigen::Index{node.value}).setZero();
      if (state_.rotations.exist()) motion.segment<3>(n_ + 3 * Eigen::Index{node.value}).setZero();
    }
    motion.segment<3>(3 * Eigen::Index{bodies_.centre_node(i)}) = duration * now.velocity;
    motion.segment<3>(3 * Eigen::Index{bodies_.turning_node(i)}) = duration * bodies_.length(i) * now.turning;
  }
  return motion;
}

/// What all nodes move by, in the place of an increment.
Eigen::VectorXd StaticProblem::moved(const Eigen::VectorXd& increment) const {
  if (bodies_.empty()) return increment;
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(size());
  motion.head(n_mesh_) = (state_.coordinates - coordinates_).reshaped();
  if (state_.rotations.exist())
    motion.segment(n_, n_mesh_) = (state_.rotations.angle - rotations_.angle).reshaped();
  return motion;
}

void StaticProblem::set_forces(const Motion& motion) {
  set_forces_of_mesh(motion);
  if (contact_ != nullptr && !holds_contact_)
    contact_->try_forces(motion, state_.forces.contact,
                         state_.rotations.exist() ? &state_.rotations.moments.contact : nullptr);
}

void StaticProblem::set_forces_of_mesh(const Motion& motion) {
  terms_.external.set_forces(motion, state_.forces.external);
  terms_.internal.set_forces(motion, state_.forces.internal);
  if (!state_.rotations.exist()) return;
  NodalForces& moments = state_.rotations.moments;
  terms_.internal.set_moments(motion, moments.internal);
  terms_.external.set_moments(motion, moments.external);
}

bool StaticProblem::evaluate(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) {
  if (!evaluate_nodes(increment, residual)) return false;
  if (bodies_.empty()) return true;
  bodies_.gather(residual);
  project(residual);
  return true;
}

bool StaticProblem::evaluate_nodes(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) {
  if (wants_end_ && wants_end_()) throw SearchGivenUp{};
  recall_elements();
  move_to(increment);
  try {
    set_forces(motion_of(state_, dt_));
  } catch (const SolveError&) {
    return false;
  }
  residual = all_forces();
  if (const double share = share_held(state_.time); share > 0.0) residual -= share * held_;
  project(residual);
  return true;
}

void StaticProblem::accept(const Eigen::VectorXd& increment) {
  if (contact_ != nullptr) {
    const ForceReport report = contact_->accept_trial(motion_of(state_, dt_), state_.forces.contact);
    state_.energies.friction += report.friction_work;
    state_.energies.stabilization += report.stabilization_work;
    state_.energies.external += report.supplied_work;
    state_.energies.contact += report.supplied_work;
  }
  const Eigen::VectorXd internal = mean_forces(&NodalForces::internal);
  const Eigen::VectorXd external = mean_forces(&NodalForces::external);
  const Eigen::VectorXd contact = mean_forces(&NodalForces::contact);
  Eigen::VectorXd all = internal + external + contact;
  if (!bodies_.empty()) all = 0.5 * (all_forces_of_start() + gathered(all_forces()));
  const double share = 0.5 * (share_held(time_) + share_held(state_.time));
  Eigen::VectorXd free = all;
  if (share > 0.0) free -= share * held_;
  if (let_go_.size() > 0) free -= 0.5 * let_go_;
  project(free);
  largest_reference_ = std::max(largest_reference_, reference_now());
  Energies& energies = state_.energies;
  const Eigen::VectorXd way = moved(increment);
  energies.internal -= internal.dot(way);
  energies.contact -= contact.dot(way);
  energies.external += external.dot(way) - (all - free).dot(increment);
  bodies_.note_forces(free_);
  // What has held a start that was out of balance lets go steadily.
  if (state_.step == 0 && held_.size() == 0 && let_go_.size() == 0)
    energies.external -= 0.5 * unbalanced_at_start().dot(increment);
  has_deaths_ = false;
  energies.hourglass = 0.0;
  for (const ModelBlockState& block : state_.blocks) energies.hourglass += block.hourglass_work;
  energies.error = energies.internal + energies.contact - energies.external - energies.start;
  for (const double term : {energies.internal, energies.external, energies.contact})
    energies.largest = std::max(energies.largest, std::abs(term));
}

Eigen::VectorXd StaticProblem::unknown_scales(std::uint32_t node) const {
  const Eigen::Index per_node = 3 * size() / n_;
  Eigen::VectorXd scales = Eigen::VectorXd::Ones(per_node);
  if (per_node > 3) scales.tail<3>() = weights_.segment<3>(n_ + 3 * Eigen::Index{node}).cwiseSqrt();
  return scales;
}

NodeIndex StaticProblem::largest_at(const Eigen::VectorXd& residual) const {
  Eigen::Index node = 0;
  residual.head(n_).reshaped(3, n_ / 3).colwise().squaredNorm().maxCoeff(&node);
  return {static_cast<std::uint32_t>(node)};
}

double StaticProblem::norm(const Eigen::VectorXd& residual) const {
  return std::sqrt(residual.cwiseAbs2().dot(weights_));
}

/// What comes back to rest without loads has no reference of its own: it is not below a thousandth of the
/// largest so far. Source: what RESIDUAL ROUNDOFF TOLERANCE of Sierra/SM is for.
double StaticProblem::reference() const {
  constexpr double least = 1e-3;
  return std::max(reference_now(), least * largest_reference_);
}

double StaticProblem::round_off() const {
  constexpr double share = 1e-14;
  return share * stiffness_ * increment_ * std::sqrt(static_cast<double>(n_));
}

void StaticProblem::archive(StateArchive& saved) {
  saved.numbers("run/largest_reference", largest_reference_);
  const std::string deaths = "run/has_deaths_to_balance";
  if (saved.restores() ? saved.has(deaths) : has_deaths_) {
    std::int64_t mark = 1;
    saved.numbers(deaths, mark);
    has_deaths_ = true;
  }
  const std::string name = "run/out_of_balance";
  if (saved.restores() ? !saved.has(name) : held_.size() == 0) return;
  held_.resize(size());
  saved.fixed(name, std::span(held_.data(), static_cast<std::size_t>(held_.size())));
  saved.numbers(name + "_times", held_from_, held_until_);
}

double StaticProblem::reference_now() const {
  Eigen::VectorXd reaction = -gathered(all_forces()), free = reaction;
  project(free);
  reaction -= free;
  switch (kind_) {
    case ResidualReference::external:
      return norm(gathered(forces_of(&NodalForces::external)) + reaction);
    case ResidualReference::internal:
      return norm(gathered(forces_of(&NodalForces::internal)));
    case ResidualReference::belytschko:
      break;
  }
  return std::max({norm(gathered(forces_of(&NodalForces::external))),
                   norm(gathered(forces_of(&NodalForces::internal))), norm(reaction)});
}

double StaticProblem::probe_factor(const Eigen::VectorXd& direction) const {
  double factor = probe_length_ / direction.head(n_).cwiseAbs().maxCoeff();
  if (state_.rotations.exist())
    factor = std::min(factor, probe_angle / direction.tail(n_).cwiseAbs().maxCoeff());
  return factor;
}

double StaticProblem::longest_step(const Eigen::VectorXd& direction) const {
  const double longest = std::sqrt(direction.head(n_).reshaped(3, n_ / 3).colwise().squaredNorm().maxCoeff());
  return longest > 0.0 ? longest_motion_ / longest : std::numeric_limits<double>::infinity();
}

void StaticProblem::project(Eigen::VectorXd& vector) const {
  project_nodes(free_, 0, vector);
  if (state_.rotations.exist()) project_nodes(free_rotations_, n_, vector);
}

}  // namespace contactsim
