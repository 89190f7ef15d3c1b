// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_problem.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/dynamics/rank_share.hpp"
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

}  // namespace

StaticProblem::StaticProblem(const Model& model, ForceTerms terms, StaticContact* contact,
                             ResidualReference reference, State& state)
    : model_(model),
      terms_(terms),
      contact_(contact),
      kind_(reference),
      state_(state),
      bodies_(model, state),
      unknowns_(model, bodies_.n_nodes(), state.rotations.exist()),
      probe_length_(probe_share * node_distance(state.coordinates)),
      held_(unknowns_.n(), unknowns_.turn()),
      start_(terms.share) {}

void StaticProblem::begin() {
  held_.find(model_, bodies_, state_.time);
  largest_reference_ = reference_now();
  bodies_.note_forces(held_.displacements());
}

void StaticProblem::let_go_until(double time) {
  Eigen::VectorXd unbalanced = forces().gathered(forces().all());
  project(unbalanced);
  taken_over_.begin(std::move(unbalanced), state_.time, time);
}

void StaticProblem::begin_step(double dt) {
  start_.remember(state_);
  dt_ = dt;
  if (contact_ != nullptr) {
    Motion motion = motion_of(state_, dt);
    motion.time += dt;
    contact_->begin_trials(motion);
  }
  bodies_.begin_step();
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, state_.coordinates.cols());
  // An acceleration from rest whose half step brings the mean velocity of the step about.
  const auto increment_of = [&](const KinematicConstraints& constraints, const Eigen::Matrix3Xd* angle) {
    Eigen::Matrix3Xd acceleration = still;
    constraints.constrain({state_.time, dt, dt, state_.coordinates, still, angle}, acceleration);
    return Eigen::VectorXd(dt * dt * acceleration.reshaped());
  };
  prescribed_.setZero(size());
  prescribed_.head(unknowns_.n_mesh()) = increment_of(model_.kinematic_constraints, nullptr);
  bodies_.set_prescribed(dt, prescribed_);
  held_.find(model_, bodies_, state_.time);
  if (state_.rotations.exist())
    prescribed_.segment(unknowns_.n(), unknowns_.n_mesh()) =
        increment_of(model_.rotation_constraints, &state_.rotations.angle);
  let_go_ = has_deaths_ ? unbalanced_at_start() : Eigen::VectorXd();
}

Ranks& StaticProblem::ranks() const { return terms_.share != nullptr ? terms_.share->ranks() : one_rank(); }

void StaticProblem::complete_elements() {
  if (terms_.share != nullptr) terms_.share->complete_elements(state_);
}

void StaticProblem::restore() {
  start_.restore(state_);
  bodies_.restore();
  if (contact_ != nullptr) contact_->give_up_trials();
}

void StaticProblem::move_to(const Eigen::VectorXd& increment) {
  state_.time = start_.time() + dt_;
  const auto places = unknowns_.places_in(increment);
  increment_ = places.cwiseAbs().maxCoeff();  // rigid motion alone rounds nothing off
  state_.coordinates = start_.coordinates() + places;
  state_.velocity = places / dt_;
  if (state_.rotations.exist()) {
    const auto turns = unknowns_.turns_in(increment);
    state_.rotations.angle = start_.rotations().angle + turns;
    state_.rotations.velocity = turns / dt_;
  }
  bodies_.move(increment, dt_, start_.coordinates());
}

Eigen::Matrix3Xd StaticProblem::coordinates_at(const Eigen::VectorXd& increment) const {
  Eigen::Matrix3Xd coordinates(3, unknowns_.n() / 3);
  coordinates.leftCols(start_.coordinates().cols()) = start_.coordinates() + unknowns_.places_in(increment);
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    coordinates.col(bodies_.centre_node(i)) = state_.rigid[i].position;
    coordinates.col(bodies_.turning_node(i)) = state_.rigid[i].position;
  }
  return coordinates;
}

Eigen::VectorXd StaticProblem::steady_motion(double duration) const {
  Eigen::VectorXd motion =
      unknowns_.vector_of(duration * state_.velocity, duration * state_.rotations.velocity);
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    const RigidBodyState::Motion& now = state_.rigid[i].now;
    for (const NodeIndex node : bodies_.body(i).nodes) {
      motion.segment<3>(3 * Eigen::Index{node.value}).setZero();
      if (unknowns_.turn()) motion.segment<3>(unknowns_.n() + 3 * Eigen::Index{node.value}).setZero();
    }
    motion.segment<3>(3 * Eigen::Index{bodies_.centre_node(i)}) = duration * now.velocity;
    motion.segment<3>(3 * Eigen::Index{bodies_.turning_node(i)}) = duration * bodies_.length(i) * now.turning;
  }
  return motion;
}

/// What all nodes move by, in the place of an increment.
Eigen::VectorXd StaticProblem::moved(const Eigen::VectorXd& increment) const {
  if (bodies_.empty()) return increment;
  return unknowns_.vector_of(state_.coordinates - start_.coordinates(),
                             state_.rotations.angle - start_.rotations().angle);
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
  start_.restore_elements(state_);
  move_to(increment);
  try {
    set_forces(motion_of(state_, dt_));
  } catch (const SolveError&) {
    return false;
  }
  residual = forces().all();
  taken_over_.take_off(taken_over_.share(state_.time), residual);
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
  const Eigen::VectorXd internal = forces().mean(&NodalForces::internal);
  const Eigen::VectorXd external = forces().mean(&NodalForces::external);
  const Eigen::VectorXd contact = forces().mean(&NodalForces::contact);
  Eigen::VectorXd all = internal + external + contact;
  if (!bodies_.empty()) all = 0.5 * (forces().all_at_start() + forces().gathered(forces().all()));
  Eigen::VectorXd free = all;
  taken_over_.take_off(0.5 * (taken_over_.share(start_.time()) + taken_over_.share(state_.time)), free);
  if (let_go_.size() > 0) free -= 0.5 * let_go_;
  project(free);
  largest_reference_ = std::max(largest_reference_, reference_now());
  Energies& energies = state_.energies;
  const Eigen::VectorXd way = moved(increment);
  energies.internal -= internal.dot(way);
  energies.contact -= contact.dot(way);
  energies.external += external.dot(way) - (all - free).dot(increment);
  bodies_.note_forces(held_.displacements());
  // What has held a start that was out of balance lets go steadily.
  if (state_.step == 0 && taken_over_.empty() && let_go_.size() == 0)
    energies.external -= 0.5 * unbalanced_at_start().dot(increment);
  has_deaths_ = false;
  energies.hourglass = 0.0;
  for (const ModelBlockState& block : state_.blocks) energies.hourglass += block.hourglass_work;
  energies.error = energies.internal + energies.contact - energies.external - energies.start;
  for (const double term : {energies.internal, energies.external, energies.contact})
    energies.largest = std::max(energies.largest, std::abs(term));
}

/// What comes back to rest without loads has no reference of its own: it is not below a thousandth of the
/// largest so far. Source: what RESIDUAL ROUNDOFF TOLERANCE of Sierra/SM is for.
double StaticProblem::reference() const {
  constexpr double least = 1e-3;
  return std::max(reference_now(), least * largest_reference_);
}

double StaticProblem::round_off() const {
  constexpr double share = 1e-14;
  return share * stiffness_ * increment_ * std::sqrt(static_cast<double>(unknowns_.n()));
}

void StaticProblem::archive(StateArchive& saved) {
  saved.numbers("run/largest_reference", largest_reference_);
  const std::string deaths = "run/has_deaths_to_balance";
  if (saved.restores() ? saved.has(deaths) : has_deaths_) {
    std::int64_t mark = 1;
    saved.numbers(deaths, mark);
    has_deaths_ = true;
  }
  taken_over_.archive(size(), saved);
}

double StaticProblem::reference_now() const {
  Eigen::VectorXd reaction = -forces().gathered(forces().all()), free = reaction;
  project(free);
  reaction -= free;
  switch (kind_) {
    case ResidualReference::external:
      return norm(forces().gathered(forces().now(&NodalForces::external)) + reaction);
    case ResidualReference::internal:
      return norm(forces().gathered(forces().now(&NodalForces::internal)));
    case ResidualReference::belytschko:
      break;
  }
  return std::max({norm(forces().gathered(forces().now(&NodalForces::external))),
                   norm(forces().gathered(forces().now(&NodalForces::internal))), norm(reaction)});
}

void StaticProblem::add_springs(const Eigen::VectorXd& direction, Eigen::VectorXd& product) const {
  springs_.add(unknowns_.n(), direction, product);
}

double StaticProblem::probe_factor(const Eigen::VectorXd& direction) const {
  double factor = probe_length_ / direction.head(unknowns_.n()).cwiseAbs().maxCoeff();
  if (state_.rotations.exist())
    factor = std::min(factor, probe_angle / direction.tail(unknowns_.n()).cwiseAbs().maxCoeff());
  return factor;
}

double StaticProblem::longest_step(const Eigen::VectorXd& direction) const {
  const double longest = unknowns_.longest_in(direction);
  return longest > 0.0 ? longest_motion_ / longest : std::numeric_limits<double>::infinity();
}

}  // namespace contactsim
