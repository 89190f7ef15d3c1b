// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/time_step.hpp"

#include <algorithm>
#include <cmath>

#include "core/definition/procedure.hpp"
#include "core/definition/region.hpp"

namespace contactsim {

double HeldStableStep::min_with(double stable) {
  if (count == n_steps) *this = {.before = now};
  now = std::min(now, stable);
  ++count;
  return std::min(now, before);
}

double HeldStableStep::take(double stable) {
  if (returning > 0.0) {
    const double next = recovery * returning;
    if (stable > next) return returning = next;
    *this = {};
    return min_with(stable);
  }
  const double last = std::min(now, before), held = min_with(stable);
  if (!(held > recovery * last)) return held;
  *this = {.returning = recovery * last};
  return returning;
}

std::size_t TimeStepControl::period_at(double time) const {
  std::size_t period = 0;
  while (period + 1 < periods_.size() && periods_[period + 1].start <= time) ++period;
  return period;
}

double TimeStepControl::step_after(double time, double before, double stable) const {
  double step = free_step_after(time, before, stable);
  for (const StepTarget& target : targets_) {
    const std::optional<double> next = target.next_time(time);
    if (!next) continue;
    constexpr double round_off = 1e-9;  // of a step: a target so near is met by the step as it is
    const double left = *next - time, n = std::max(1.0, std::ceil(left / step - round_off));
    if (n <= static_cast<double>(target.n_steps)) step = std::min(step, left / n);
  }
  return step;
}

double TimeStepControl::free_step_after(double time, double before, double stable) const {
  const std::size_t period = period_at(time);
  const ExplicitTimeParameters& parameters = periods_[period].parameters;
  if (parameters.user_time_step) return *parameters.user_time_step;
  double step = parameters.time_step_scale_factor * stable;
  if (before > 0.0) step = std::min(step, parameters.time_step_increase_factor * before);
  const bool is_first_of_period = before == 0.0 || period_at(time - before) != period;
  if (is_first_of_period && parameters.initial_time_step)
    step = std::min(step, *parameters.initial_time_step);
  return step;
}

bool TimeStepControl::is_over(double time, double step) const {
  constexpr double round_off = 1e-9;  // of a step, far above what adding up steps loses
  return time + round_off * step >= termination_time_;
}

TimeStepControl make_time_step_control(const Procedure& procedure, const Region& region) {
  std::vector<TimePeriod> periods;
  const TimeControl& control = *procedure.time_control;
  for (const TimeSteppingBlock& block : control.time_stepping_blocks) {
    TimePeriod period{block.name.text, block.start_time, {}};
    const auto is_ours = [&](const ExplicitTimeParameters& p) { return p.name == region.name; };
    const auto found =
        std::find_if(block.explicit_parameters.begin(), block.explicit_parameters.end(), is_ours);
    if (found != block.explicit_parameters.end()) period.parameters = *found;
    if (procedure.implicit_by) period.parameters.step_interval = 1;
    periods.push_back(std::move(period));
  }
  return {std::move(periods), control.termination_time};
}

}  // namespace contactsim
