// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/load_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/dynamics/rigid_motion.hpp"
#include "core/dynamics/state_motion.hpp"
#include "core/statics/free_bodies.hpp"
#include "core/statics/no_equilibrium.hpp"

namespace contactsim {

namespace {

/// Of conjugate gradients with nodal blocks at most.
std::int64_t nodal_iterations(const Mesh& mesh) { return std::max<std::int64_t>(mesh.n_nodes(), 1000); }

/// The settings of a time stepping block, with what the deck leaves open. Source: Sierra/SM 5.20, BEGIN CG,
/// MAXIMUM ITERATIONS.
CgSettings settings_of(const CgSettings& settings, const DeckName& period, const Mesh& mesh) {
  CgSettings cg = settings_during(settings, period);
  if (cg.max_iterations == 0) cg.max_iterations = cg.full_tangent ? 100 : nodal_iterations(mesh);
  return cg;
}

}  // namespace

LoadSteps::LoadSteps(const Model& model, ForceTerms terms, StaticContact* contact,
                     const SolverSettings& settings, LoadSchedule schedule, State& state)
    : model_(model),
      terms_(terms),
      settings_(settings),
      schedule_(std::move(schedule)),
      state_(state),
      problem_(model, terms, contact, settings_.cg.reference, state),
      graph_(model.mesh->n_nodes(), *model.mesh, model.blocks, problem_.bodies().size()),
      blocks_(problem_, graph_) {
  if (!settings_.cg.full_tangent) return;
  const FullTangentSettings& full = *settings_.cg.full_tangent;
  linear_solver_ = choose_linear_solver(problem_, graph_, full.linear_solver);
  tangent_ = make_tangent(problem_, graph_, full);
  linearised_.emplace(problem_, *tangent_, [this](const Eigen::VectorXd& at, bool may_keep_elements) {
    renew_preconditioner(at, may_keep_elements);
  });
}

void LoadSteps::start(bool takes_over) {
  state_.velocity.setZero();
  state_.rotations.velocity.setZero();
  if (!model_.rigid.empty()) start_rigid_bodies(model_, state_);
  const Motion motion = motion_of(state_, 0.0);
  terms_.internal.set_forces(motion, state_.forces.internal);
  terms_.external.set_forces(motion, state_.forces.external);
  if (terms_.contact != nullptr) terms_.contact->set_forces(motion, state_.forces.contact);
  if (state_.rotations.exist()) {
    NodalForces& moments = state_.rotations.moments;
    terms_.internal.set_moments(motion, moments.internal);
    terms_.external.set_moments(motion, moments.external);
    if (terms_.contact != nullptr) {
      moments.contact.resizeLike(moments.internal);
      terms_.contact->set_moments(motion, moments.contact);
    }
  }
  problem_.complete_elements();
  problem_.hold_lifeless(find_lifeless());
  problem_.begin();
  if (takes_over) problem_.let_go_until(schedule_.end_of_period(state_.time));
  state_.acceleration.setZero();
  state_.next_dt = schedule_.step_at(state_.time);
  state_.first_dt = state_.next_dt;
}

std::optional<FactorMemory> LoadSteps::factor_memory() const {
  return has_tangent() ? tangent_->factor_memory() : std::nullopt;
}

bool LoadSteps::has_tangent() const { return tangent_ && tangent_->exists(); }

void LoadSteps::renew_preconditioner(const Eigen::VectorXd& increment, bool may_keep_elements) {
  if (tangent_) report_.n_evaluations += tangent_->renew(increment, may_keep_elements);
  if (!has_tangent()) report_.n_evaluations += blocks_.renew(increment);
  // Of solids: what turns has moments, too, which are taken over lengths.
  if (!state_.rotations.exist())
    problem_.set_stiffness(has_tangent() ? tangent_->largest() : blocks_.largest());
}

/// The increment of the last step, scaled, of all nodes: nothing before the first.
Eigen::VectorXd LoadSteps::first_guess(double dt) const {
  const LoadstepPredictor& predictor = settings_.predictor;
  double factor = predictor.type == LoadstepPredictor::Type::scale_factor ? predictor.scale_factor : 1.0;
  if (schedule_.begins_period(state_.time)) factor = predictor.first_scale_factor.value_or(factor);
  if (state_.step == 0 || factor == 0.0) return Eigen::VectorXd::Zero(problem_.size());
  return problem_.steady_motion(factor * dt);
}

/// Searches for equilibrium: with a full tangent by Newton's steps, and where these lead nowhere, or without
/// one, by conjugate gradients.
void LoadSteps::search(const CgSettings& cg, Eigen::VectorXd& increment) {
  const Eigen::VectorXd begun = increment;
  if (has_tangent()) {
    report_.search = newton(problem_, *linearised_, cg, increment);
    report_.n_evaluations += report_.search.n_evaluations;
    report_.n_linear += report_.search.n_linear;
    meets_negative_ = meets_negative_ || report_.search.meets_negative;
    report_.has_left_newton = false;
    if (report_.search.end == CgReport::End::converged) return;
    increment = begun;
    report_.n_evaluations += blocks_.renew(increment);
  }
  if (linearised_) linearised_->free_slip_limits();
  report_.has_left_newton = tangent_ != nullptr;
  CgSettings nodal = cg;
  const bool is_given = settings_during(settings_.cg, schedule_.period_name(step_begun_)).max_iterations > 0;
  if (!is_given) nodal.max_iterations = nodal_iterations(*model_.mesh);
  report_.search = nonlinear_cg(problem_, blocks_, nodal, increment);
  report_.n_evaluations += report_.search.n_evaluations;
}

/// Updates multipliers and searches again until contact no longer changes. Returns whether equilibrium was
/// found, and contact is acceptable. Source: Sierra/SM 5.22, BEGIN CONTROL CONTACT.
bool LoadSteps::control_contact(const CgSettings& cg, Eigen::VectorXd& increment) {
  const ControlContact control =
      settings_during(settings_.control_contact, schedule_.period_name(step_begun_));
  const auto is_below = [&](double share) {
    return report_.contact.change <= share * report_.contact.reference;
  };
  if (control.max_iterations > 0) report_.contact_target = control.target_relative_residual;
  // What an update changes may be less than is looked at as out of balance, over and over.
  CgSettings again = cg;
  again.min_iterations = std::max<std::int64_t>(again.min_iterations, 1);
  Eigen::VectorXd residual;
  std::int64_t n_iterations = report_.search.n_iterations;
  for (;;) {
    report_.n_evaluations += 1;
    if (!problem_.evaluate(increment, residual)) return false;
    const bool is_last = report_.n_updates >= control.max_iterations;
    const bool is_forced = report_.n_updates < control.min_iterations;
    const double tolerance = is_last     ? std::numeric_limits<double>::infinity()
                             : is_forced ? 0.0
                                         : control.target_relative_residual;
    report_.contact = problem_.contact()->update_multipliers(tolerance);
    if (is_below(control.target_relative_residual) && report_.n_updates >= control.min_iterations)
      return true;
    if (is_last) return control.max_iterations == 0 || is_below(control.acceptable_relative());
    ++report_.n_updates;
    search(again, increment);
    n_iterations += report_.search.n_iterations;
    report_.search.n_iterations = n_iterations;
    if (report_.search.end == CgReport::End::failed) return false;
  }
}

/// Bodies that only contact may hold drift until they touch: no farther in one trial than contact sees.
void LoadSteps::find_free() {
  const StaticBodies& bodies = problem_.bodies();
  if (!tangent_ && problem_.contact() == nullptr && bodies.empty()) return;
  StaticContact* contact = problem_.contact();
  const Stabilization stabilization = contact != nullptr ? contact->stabilization() : Stabilization{};
  FreeBodies free =
      find_free_bodies(problem_, living_graph_ ? *living_graph_ : graph_,
                       problem_.coordinates_at(Eigen::VectorXd::Zero(problem_.size())), stabilization);
  problem_.limit_motion(free.are_any && contact != nullptr ? contact->longest_motion()
                                                           : std::numeric_limits<double>::infinity());
  free_ = std::move(free.rigid);
  if (tangent_) tangent_->set_free(std::move(free.shares));
  if (linearised_) linearised_->set_free(free.are_any);
}

/// Seeks the equilibrium of a step, which it begins.
bool LoadSteps::seek(double dt, Eigen::VectorXd& increment) {
  const CgSettings cg = settings_of(settings_.cg, schedule_.period_name(state_.time), *model_.mesh);
  increment = first_guess(dt);
  step_begun_ = state_.time;
  problem_.begin_step(dt);
  report_.n_updates = 0;
  begin_stabilization(dt);
  find_free();
  Eigen::VectorXd residual;
  if (linearised_ && problem_.contact() != nullptr) {
    ++report_.n_evaluations;
    problem_.evaluate(Eigen::VectorXd::Zero(problem_.size()), residual);
    linearised_->hold_slip_limits();
  }
  ++report_.n_evaluations;
  if (!increment.isZero(0.0) && !problem_.evaluate(increment, residual)) increment.setZero();
  renew_preconditioner(increment);

  Eigen::VectorXd held = increment;
  problem_.project(held);
  const Eigen::VectorXd left = problem_.prescribed() - (increment - held);
  report_.n_evaluations += has_tangent()
                               ? predict_by_newton(problem_, *linearised_, left, increment)
                               : predict_linearly(problem_, blocks_, left, cg.max_iterations, increment);

  search(cg, increment);
  bool is_found = report_.search.end != CgReport::End::failed;
  if (is_found) is_found = end_stabilization(dt, cg, increment);
  if (is_found && problem_.contact() != nullptr) is_found = control_contact(cg, increment);
  ++report_.n_evaluations;
  const bool exists = problem_.evaluate(increment, residual);
  report_.search_target =
      std::max(cg.target_relative_residual, cg.target_residual.value_or(0.0) / report_.search.reference);
  if (exists && problem_.contact() != nullptr && problem_.contact()->is_stabilized())
    report_.stabilizing_force = problem_.contact()->stabilizing_force() / report_.search.reference;
  if (!is_found || !exists) residual_ = exists ? residual : Eigen::VectorXd();
  return is_found && exists;
}

bool LoadSteps::try_step(double dt) {
  Eigen::VectorXd increment;
  std::int64_t n_iterations = 0;
  for (std::int64_t n_rounds = 0;; ++n_rounds) {
    if (!seek(dt, increment)) return false;
    problem_.complete_elements();
    n_iterations += report_.search.n_iterations;
    if (!has_deaths(n_rounds)) break;
  }
  report_.search.n_iterations = n_iterations;
  problem_.accept(increment);
  before_deaths_.reset();
  return true;
}

bool LoadSteps::advance() {
  const LoadSchedule begun = schedule_;
  try {
    find_next();
  } catch (const SearchGivenUp&) {
    problem_.restore();
    undo_deaths();
    schedule_ = begun;
    return false;
  }
  return true;
}

void LoadSteps::find_next() {
  report_ = {};
  double dt = state_.next_dt;
  const double begun = state_.time;
  meets_negative_ = false;
  while (!try_step(dt)) {
    const CgReport failed = report_.search;
    problem_.restore();
    undo_deaths();
    if (!schedule_.cut_back(begun)) {
      report_.search = failed;
      fail(fmt::format("no equilibrium is found with a step of {:.4g}: ", dt));
    }
    ++report_.n_cutbacks;
    dt = schedule_.step_at(begun);
  }
  if (has_tangent()) {
    report_.n_negative = std::max<std::int64_t>(tangent_->n_negative(), meets_negative_ ? 1 : 0);
  }
  schedule_.note_success(begun, report_.search.n_iterations);
  state_.dt = dt;
  state_.time = schedule_.end_of(begun, dt);
  ++state_.step;
  state_.next_dt = schedule_.is_over(state_.time) ? dt : schedule_.step_at(state_.time);
}

void LoadSteps::fail(std::string text) const {
  throw SolveError(state_.time, text + describe_imbalance(problem_, *model_.mesh, report_.search, residual_) +
                                    name_free_bodies(problem_, free_));
}

void LoadSteps::archive(StateArchive& saved) {
  schedule_.archive(saved);
  problem_.archive(saved);
  if (saved.restores()) problem_.hold_lifeless(find_lifeless());
}

}  // namespace contactsim
