// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/load_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "core/definition/procedure.hpp"
#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

/// A step that ends this near to the end of its period, over its size, ends there [1].
constexpr double round_off = 1e-6;

constexpr double no_bound = std::numeric_limits<double>::infinity();

}  // namespace

LoadSchedule::LoadSchedule(std::vector<LoadPeriod> periods, std::optional<AdaptiveTimeStepping> adaption)
    : periods_(std::move(periods)),
      adaption_(adaption.value_or(AdaptiveTimeStepping{})),
      no_multiplier_(adaption ? no_bound : 1.0) {}

const LoadPeriod& LoadSchedule::period_at(double time) const {
  const auto next = std::find_if(periods_.begin(), periods_.end() - 1,
                                 [time](const LoadPeriod& period) { return time < period.end; });
  return *next;
}

bool LoadSchedule::begins_period(double time) const { return time == period_at(time).start; }

double LoadSchedule::step_at(double time) const {
  const LoadPeriod& period = period_at(time);
  const double increment = period.function ? period.function->evaluate(time) : period.increment;
  if (!(increment > 0.0) || !std::isfinite(increment))
    throw SolveError(time, fmt::format("TIME INCREMENT FUNCTION gives a step of {}", increment));
  double step = multiplier_ * increment;
  if (!period.function && multiplier_ <= 1.0) {
    const double n_done = std::floor((time - period.start) / increment + round_off);
    const double left = period.start + (n_done + 1.0) * increment - time;
    if (step * (1.0 + round_off) >= left) step = left;
  }
  return end_of(time, step) - time;
}

double LoadSchedule::end_of(double time, double dt) const {
  const LoadPeriod& period = period_at(time);
  return time + dt * (1.0 + round_off) >= period.end ? period.end : time + dt;
}

void LoadSchedule::note_success(double begun, std::int64_t n_iterations) {
  n_cutbacks_ = 0;
  const AdaptiveTimeStepping adaption = adaption_at(begun);
  const std::int64_t target = adaption.target_iterations, window = adaption.iteration_window;
  if (target > 0 && n_iterations > target + window) {
    multiplier_ = std::max(adaption.min_multiplier, multiplier_ * adaption.cutback_factor);
    return;
  }
  const bool is_easy = target == 0 || n_iterations < target - window;
  if (is_easy)
    multiplier_ =
        std::min(adaption.max_multiplier.value_or(no_multiplier_), multiplier_ * adaption.growth_factor);
}

bool LoadSchedule::cut_back(double begun) {
  const AdaptiveTimeStepping adaption = adaption_at(begun);
  if (n_cutbacks_ >= adaption.max_failure_cutbacks) return false;
  if (multiplier_ <= adaption.min_multiplier) return false;
  ++n_cutbacks_;
  multiplier_ = std::max(adaption.min_multiplier, multiplier_ * adaption.cutback_factor);
  return true;
}

void LoadSchedule::archive(StateArchive& saved) {
  saved.numbers("run/load_schedule", multiplier_, n_cutbacks_);
}

namespace {

/// What a period says about its steps.
LoadPeriod make_period(const TimeSteppingBlock& block, double end, const Region& region,
                       const SimulationDefinition& definition, Diagnostics& diagnostics) {
  LoadPeriod period{block.name, block.start_time, end, end - block.start_time, {}};
  const auto found = std::ranges::find_if(block.implicit_parameters, [&](const ImplicitTimeParameters& p) {
    return fold(p.name.text) == fold(region.name.text);
  });
  if (found == block.implicit_parameters.end()) {
    diagnostics.add_error(block.name.location,
                          fmt::format("the time stepping block '{}' has no steps for the region '{}'",
                                      block.name.text, region.name.text),
                          "PARAMETERS FOR ADAGIO REGION with TIME INCREMENT or NUMBER OF TIME STEPS");
    return period;
  }
  if (found->increment_function) {
    period.function = make_named_function(*found->increment_function, definition.functions, diagnostics);
  } else if (found->n_time_steps) {
    period.increment /= static_cast<double>(*found->n_time_steps);
  } else if (found->time_increment) {
    period.increment = *found->time_increment;
  } else {
    diagnostics.add_error(
        found->name.location,
        fmt::format("the parameters for adagio region '{}' give no steps", region.name.text),
        "TIME INCREMENT = <real> or NUMBER OF TIME STEPS = <integer>");
  }
  return period;
}

}  // namespace

LoadSchedule make_load_schedule(const SimulationDefinition& definition, const Procedure& procedure,
                                const Region& region, Diagnostics& diagnostics) {
  const TimeControl& control = *procedure.time_control;
  const auto& blocks = control.time_stepping_blocks;
  std::vector<LoadPeriod> periods;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double next = i + 1 < blocks.size() ? blocks[i + 1].start_time : control.termination_time;
    const double end = std::min(next, control.termination_time);
    if (blocks[i].start_time < end)
      periods.push_back(make_period(blocks[i], end, region, definition, diagnostics));
  }
  return {std::move(periods), region.adaptive_time_stepping};
}

}  // namespace contactsim
