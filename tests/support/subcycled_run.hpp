// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "core/dynamics/integrator.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/dynamics/subcycler.hpp"

namespace contactsim::test {

/// The same force along x on every node.
class SamePull final : public ForceTerm {
 public:
  explicit SamePull(double force = 0.0) : force_(force) {}
  ForceReport set_forces(const Motion&, Eigen::Matrix3Xd& forces) override {
    forces.setZero();
    forces.row(0).setConstant(force_);
    return {};
  }

 private:
  double force_;
};

/// A run of a model, subcycled where the model says so.
struct SubcycledRun {
  SubcycledRun(const Model& of, const std::function<void(State&)>& begin, double force = 0.0,
               Ranks* ranks = nullptr, std::optional<double> step = step_of_rods)
      : model(of),
        state(make_state(of.mesh->coordinates(), of.blocks, 0.0)),
        pull(force),
        control{{period(step)}, 1e9} {
    begin(state);
    if (ranks != nullptr) share.emplace(*ranks, model, model.subcycles.nodes);
    internal.emplace(model, state, share ? &*share : nullptr);
    if (!model.subcycles.empty()) subcycler.emplace(model, state);
    start(model, terms(), control, state, share ? &*share : nullptr);
  }
  SubcycledRun(const SubcycledRun&) = delete;
  SubcycledRun& operator=(const SubcycledRun&) = delete;

  ForceTerms terms() { return {*internal, pull, nullptr, subcycler ? &*subcycler : nullptr}; }
  void advance(int n_steps) {
    for (int i = 0; i < n_steps; ++i)
      contactsim::advance(model, terms(), control, state, share ? &*share : nullptr);
    if (share) share->complete(state);
  }

  /// Steps of one size, so that energies are known to round-off: rods are stable at 1.
  static constexpr double step_of_rods = 0.85;

  static TimePeriod period(std::optional<double> step) {
    TimePeriod all{"all", 0.0, {}};
    all.parameters.user_time_step = step;
    return all;
  }

  const Model& model;
  State state;
  SamePull pull;
  TimeStepControl control;
  std::optional<RankShare> share;
  std::optional<InternalForce> internal;
  std::optional<Subcycler> subcycler;
};

/// A blow on the left end, so small that strains are those of linear theory.
inline void strike(State& state) {
  for (Eigen::Index i = 0; i < state.velocity.cols(); ++i) {
    if (state.coordinates(0, i) < 5.0) state.velocity(0, i) = 1e-7;
  }
}

inline double total(const State& state) { return state.energies.kinetic + state.energies.internal; }

}  // namespace contactsim::test
