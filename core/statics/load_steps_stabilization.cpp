// SPDX-License-Identifier: BSD-3-Clause
// Load steps in which contact resists the motion of sides that do not touch yet.
#include "core/statics/load_steps.hpp"

namespace contactsim {

/// The ramp of a step is that of its end; the one that ends a time stepping block begins with that of its
/// start, which end_stabilization() takes away.
void LoadSteps::begin_stabilization(double dt) {
  StaticContact* contact = problem_.contact();
  if (contact == nullptr || !contact->is_stabilized()) return;
  const double start = schedule_.start_of_period(step_begun_), end = schedule_.end_of_period(step_begun_);
  const double begun = (end - step_begun_) / (end - start);
  const double ended = (end - schedule_.end_of(step_begun_, dt)) / (end - start);
  stabilization_ = {ended > 0.0 ? ended : begun, (end - start) / dt};
  contact->stabilize(stabilization_);
}

/// Seeks the equilibrium that ends a time stepping block, where nothing is stabilized any more, by that of
/// ever less stabilization: what moves by it comes to touch in small motions. Returns whether it was found.
bool LoadSteps::end_stabilization(double dt, const CgSettings& cg, Eigen::VectorXd& increment) {
  StaticContact* contact = problem_.contact();
  if (contact == nullptr || !contact->is_stabilized()) return true;
  constexpr double less = 0.1;
  constexpr int most = 9;  // times: by then the stiffness of elements has a billionth of it to the ground
  const auto seek_with = [&](double ramp) {
    stabilization_.ramp = ramp;
    contact->stabilize(stabilization_);
    find_free();
    renew_preconditioner(increment, true);
    const std::int64_t n_before = report_.search.n_iterations;
    search(cg, increment);
    report_.search.n_iterations += n_before;
    return report_.search.end != CgReport::End::failed;
  };
  Eigen::VectorXd residual;
  const auto is_still = [&] {
    ++report_.n_evaluations;
    return problem_.evaluate(increment, residual) &&
           contact->stabilizing_force() <= cg.target_relative_residual * report_.search.reference;
  };
  report_.ends_block = schedule_.end_of(step_begun_, dt) >= schedule_.end_of_period(step_begun_);
  if (!report_.ends_block) return true;
  for (int i = 0; i < most && !is_still(); ++i) {
    if (!seek_with(less * stabilization_.ramp)) return false;
  }
  return seek_with(0.0);
}

}  // namespace contactsim
