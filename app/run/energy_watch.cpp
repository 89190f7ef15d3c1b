// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/energy_watch.hpp"

#include <cmath>
#include <limits>

namespace contactsim {

namespace {

/// An energy that appears or vanishes is worth a warning when it is this share of the largest.
constexpr double worrying_error = 0.01;

/// Growth of the largest term in a step that is fast. The energy of constant forces grows as the square of
/// the number of steps: fast for the first twenty.
constexpr double fast_growth = 1.1;

/// What grows fast for longer does not settle: it blows up.
constexpr int longest_settling = 30;

}  // namespace

double energy_of_round_off(const Model& model, double dt) {
  const double speed =
      std::numeric_limits<double>::epsilon() * model.mesh->coordinates().cwiseAbs().maxCoeff() / dt;
  return 0.5 * model.mass.sum() * speed * speed;
}

bool EnergyWatch::is_off(const State& state) {
  const Energies& e = state.energies;
  n_unsettled_ = e.largest > fast_growth * largest_ ? n_unsettled_ + 1 : 0;
  largest_ = e.largest;
  if (n_unsettled_ > 0 && n_unsettled_ <= longest_settling) return false;
  if (std::abs(e.error) <= worrying_error * e.largest) return false;
  return e.largest > energy_of_round_off(model_, state.dt);
}

}  // namespace contactsim
