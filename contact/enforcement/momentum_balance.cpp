// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/momentum_balance.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

namespace {

/// Forces that change by less in a pass, over their sum, are balanced.
constexpr double balanced = 1e-4;

/// What neither side can represent, such as slopes across unlike meshes, stays in the forces however many
/// passes there are, and moves no node. A pass that leaves more than this share of the residual is one too
/// many, and that is said sooner where forces are nearly balanced.
constexpr double fruitless = 0.975, nearly_balanced = 2e-3, fruitless_then = 0.9;
constexpr std::int64_t min_passes = 4;

/// By how much of a step of the forces the next pass looks ahead, after some passes without a restart [1].
double momentum_after(double n_passes) { return n_passes / (n_passes + 0.5); }

}  // namespace

void MomentumBalance::begin(const Model& model, const ModelFreeDirections& free,
                            const ContactKinematics& kinematics, const State& state) {
  mobility_.begin(model, free, kinematics, state);
  contacts_.begin(kinematics, state.dt, state.next_dt);
  ties_.begin(kinematics, state.next_dt);
  loss_ = {};
  time_ = state.time;
}

void MomentumBalance::push(ContactNodeIndex node, const Eigen::Vector3d& force,
                           const Eigen::Vector3d& moment) {
  terms_.clear();
  mobility_.add_terms(node, 1.0, Eigen::Vector3d::Zero(), terms_);
  for (const CarrierTerm& term : terms_) {
    const Eigen::Vector3d share = term.weight * force;
    mobility_.push(term.carrier, share, term.arm.cross(share) + term.weight * moment);
  }
}

/// By sums of rows: with the areas a > 0 of the points, |A| a <= D a bounds the eigenvalues of D^-1 A by 1
/// (Collatz and Wielandt). Where nodes are free, D is the lumped mass per area on both sides in series.
void MomentumBalance::set_softness() {
  areas_.assign(mobility_.n_carriers(), {0.0, 0.0});
  ties_.add_areas(areas_);
  contacts_.add_areas(areas_);
  mobility_.spread_areas(areas_);
  const double least = choose_light();
  ties_.set_softness(areas_, light_, least);
  contacts_.set_softness(areas_, light_, least);
  if (light_.empty()) return;
  ties_.add_rows(light_);
  contacts_.add_rows(light_);
}

/// Chooses the rigid bodies that are light beside what they meet. Returns the mean softness by area of that,
/// of which what meets light carriers alone has a share.
double MomentumBalance::choose_light() {
  constexpr double light = 3.0, least = 0.1;
  light_.begin(mobility_.n_carriers());
  if (!mobility_.has_bodies()) return 0.0;
  loads_.assign(mobility_.n_carriers(), {});
  ties_.add_loads(areas_, loads_);
  contacts_.add_loads(areas_, loads_);
  double others = 0.0, area = 0.0;
  for (std::uint32_t i = 0; i < loads_.size(); ++i) {
    const CarrierLoad& load = loads_[i];
    if (!mobility_.is_body(i) || !(load.others > 0.0) || !(load.own > light * load.others)) continue;
    light_.add(i, mobility_.mobility(i));
    others += load.others;
    area += load.area;
  }
  return area > 0.0 ? least * others / area : 0.0;
}

/// Finds the motion of light carriers that comes with the next forces.
void MomentumBalance::move_light() {
  if (light_.empty()) return;
  const std::uint32_t n_ties = ties_.n_light_points();
  light_.solve([&](std::uint32_t row, const Eigen::Vector3d& velocity) {
    return row < n_ties ? ties_.answer(row, velocity) : contacts_.answer(row - n_ties, velocity);
  });
}

/// Has the carriers move by the forces, without momentum beyond them.
void MomentumBalance::push_forces() {
  ties_.push_forces();
  contacts_.push_forces();
  mobility_.end_pass();
}

ConstraintPass MomentumBalance::pass(double momentum) {
  move_light();
  ConstraintPass sums = ties_.pass(momentum, light_);
  sums += contacts_.pass(momentum, light_);
  mobility_.end_pass();
  return sums;
}

/// As many in the next step, one more or one fewer: where passes leave a share of a mode in one step and none
/// of it in the next, the mode grows, however much each pass takes.
///   share     of the residual that the last pass left [1]
void MomentumBalance::choose_passes(std::int64_t n_passes, double share, double residual) {
  const double most = residual < nearly_balanced ? fruitless_then : fruitless;
  n_passes_ = std::max(min_passes, share > most ? n_passes - 1 : n_passes + 1);
}

/// The passes of the second half look ahead as those of the first did. Each half leaves the share q(lambda)
/// of a mode of D^-1 A, both q^2, which is never below 0. That matters: with S = M^-1 B^T P B of the forces
/// -P g for predicted gaps g, and K of elements near their stable step, a motion u continues by
///   z^2 (I - S)^-1 u - ((2 - dt^2 M^-1 K) z - 1) u = 0,
/// where no |z| > 1 only if no eigenvalue of I - S is negative; accelerated passes alone leave negative ones,
/// by which a light sheet between heavier bodies makes energy.
BalanceReport MomentumBalance::solve(int max_iterations, RecoveryEnergy& recovery) {
  BalanceReport report;
  const std::int64_t n_passes =
      ties_.empty() ? std::min<std::int64_t>(n_passes_, max_iterations) : max_iterations;
  const auto half = static_cast<std::size_t>(std::max<std::int64_t>(1, n_passes / 2));
  mobility_.begin_passes();
  contacts_.list_pushes();
  set_softness();
  contacts_.limit_recovery(recovery);
  contacts_.begin_passes();
  push_forces();
  momenta_.clear();
  double momentum = 0.0, before = 1.0, share = 1.0, since_restart = 0.0;
  for (std::size_t i = 0; i < 2 * half; ++i) {
    const bool is_first_half = i < half;
    momentum = !is_first_half ? momenta_[i - half] : i + 1 == half ? 0.0 : momentum_after(since_restart++);
    const ConstraintPass sums = pass(momentum);
    if (!std::isfinite(sums.all)) throw SolveError(time_, "contact forces are not finite");
    ++report.n_iterations;
    report.residual = sums.all > 0.0 ? sums.changed / sums.all : 0.0;
    if (report.residual <= balanced) break;
    share = report.residual / before;
    before = report.residual;
    if (!is_first_half) continue;
    if (sums.uphill > 0.0 && momentum > 0.0) {
      since_restart = 0.0;
      push_forces();
      momentum = 0.0;
    }
    momenta_.push_back(momentum);
  }
  if (momentum > 0.0) push_forces();
  if (report.residual > balanced) choose_passes(n_passes, share, report.residual);
  loss_ = contacts_.finish();
  ties_.finish();
  return report;
}

void MomentumBalance::archive(StateArchive& saved) {
  saved.fixed("contact/passes", std::span(&n_passes_, 1));
  contacts_.memory().archive(saved);
}

void MomentumBalance::remap(const ContactRemap& remap) {
  mobility_.forget();
  contacts_.memory().remap(remap);
}

}  // namespace contactsim
