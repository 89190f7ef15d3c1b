// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/momentum_balance.hpp"

#include <cmath>

namespace contactsim {

namespace {

/// Forces that change by less in a pass, over their sum, are balanced.
constexpr double balanced = 1e-4;

/// What neither side can represent, such as slopes across unlike meshes, stays in the forces however many
/// passes there are. Passes end when after the first few one leaves more than this share of the residual.
constexpr double fruitless = 0.975;
constexpr int n_first_passes = 3;

}  // namespace

void MomentumBalance::begin(const Model& model, const MovingSurface& surface, const State& state) {
  mobility_.begin(model, surface, state);
  contacts_.begin(surface, state.dt, state.next_dt);
  ties_.begin(surface, state.next_dt);
  loss_ = {};
}

/// By sums of rows: with the areas a > 0 of the points, |A| a <= D a bounds the eigenvalues of D^-1 A by 1
/// (Collatz and Wielandt). Where nodes are free, D is the lumped mass per area on both sides in series.
void MomentumBalance::set_softness() {
  areas_.assign(mobility_.n_carriers(), {0.0, 0.0});
  ties_.add_areas(areas_);
  contacts_.add_areas(areas_);
  ties_.set_softness(areas_);
  contacts_.set_softness(areas_);
}

/// Has the carriers move by the forces, without momentum beyond them.
void MomentumBalance::push_forces() {
  ties_.forget_momentum();
  contacts_.forget_momentum();
  ties_.push_all();
  contacts_.push_all();
  mobility_.end_pass();
}

ConstraintPass MomentumBalance::pass(double momentum) {
  ConstraintPass sums = ties_.pass(momentum);
  sums += contacts_.pass(momentum);
  mobility_.end_pass();
  return sums;
}

BalanceReport MomentumBalance::solve(int max_iterations) {
  BalanceReport report;
  mobility_.begin_passes();
  set_softness();
  push_forces();
  double theta = 1.0, momentum = 0.0, before = 0.0;
  while (report.n_iterations < max_iterations) {
    const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * theta * theta));
    const bool is_last = report.n_iterations + 1 == max_iterations;
    momentum = is_last ? 0.0 : (theta - 1.0) / next;
    const ConstraintPass sums = pass(momentum);
    theta = next;
    ++report.n_iterations;
    report.residual = sums.all > 0.0 ? sums.changed / sums.all : 0.0;
    if (report.residual <= balanced) break;
    if (report.n_iterations > n_first_passes && report.residual > fruitless * before) break;
    before = report.residual;
    if (!(sums.uphill > 0.0)) continue;
    theta = 1.0;
    push_forces();
    momentum = 0.0;
  }
  if (momentum > 0.0) push_forces();
  loss_ = contacts_.finish();
  ties_.finish();
  return report;
}

void MomentumBalance::renumber(const ContactRenumbering& places) {
  mobility_.forget();
  contacts_.memory().renumber(places);
}

}  // namespace contactsim
