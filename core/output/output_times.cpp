// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contactsim {

namespace {

constexpr double rounding = 1e-9;  // far above that of a million summed steps, far below any output interval

// How far below a scheduled time still counts as having reached it.
double tolerance(double time, double increment) { return rounding * std::max(std::abs(time), increment); }

// Number of scheduled times of a phase up to `time`, none of them at `end` or later.
std::int64_t count_times(const TimePhase& phase, double end, double time) {
  const double last =
      std::min(time + tolerance(time, phase.increment), end - tolerance(end, phase.increment));
  if (last < phase.start) return 0;
  const double n = std::floor((last - phase.start) / phase.increment);
  constexpr double max_count = 1e15;  // a double still counts them one by one
  return 1 + static_cast<std::int64_t>(std::clamp(n, 0.0, max_count));
}

std::int64_t count_steps(const StepPhase& phase, std::int64_t end, std::int64_t step) {
  const std::int64_t last = std::min(step, end - 1);
  return last < phase.start ? 0 : 1 + (last - phase.start) / phase.increment;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// The first phase that begins after phases[i] ends it.
template <class Phases, class Value>
Value end_of(const Phases& phases, std::size_t i, Value never) {
  return i + 1 < phases.size() ? phases[i + 1].start : never;
}

template <class Phases>
void sort_by_start(Phases& phases) {
  std::stable_sort(phases.begin(), phases.end(),
                   [](const auto& a, const auto& b) { return a.start < b.start; });
}

}  // namespace

OutputSchedule resolve_schedule(const OutputSchedule& schedule, std::span<const OutputScheduler> schedulers,
                                Diagnostics& diagnostics) {
  OutputSchedule resolved = schedule;
  if (!schedule.scheduler) return resolved;
  const DeckName& name = *schedule.scheduler;
  std::vector<std::string> known;
  for (const OutputScheduler& scheduler : schedulers) {
    known.push_back(scheduler.name.text);
    if (fold(scheduler.name.text) != fold(name.text)) continue;
    const OutputSchedule& further = scheduler.schedule;
    append(resolved.time_phases, further.time_phases);
    append(resolved.step_phases, further.step_phases);
    append(resolved.additional_times, further.additional_times);
    append(resolved.additional_steps, further.additional_steps);
    if (!resolved.start_time) resolved.start_time = further.start_time;
    if (!resolved.termination_time) resolved.termination_time = further.termination_time;
    if (!resolved.adjustment_interval) resolved.adjustment_interval = further.adjustment_interval;
    return resolved;
  }
  diagnostics.add_error(name.location, "the output scheduler '" + name.text + "' is not defined",
                        suggest(name.text, known), static_cast<int>(name.text.size()));
  return resolved;
}

OutputTimes::OutputTimes(OutputSchedule schedule, std::int64_t default_step_increment)
    : schedule_(std::move(schedule)) {
  OutputSchedule& s = schedule_;
  sort_by_start(s.time_phases);
  sort_by_start(s.step_phases);
  const bool is_silent = s.time_phases.empty() && s.step_phases.empty() && s.additional_times.empty() &&
                         s.additional_steps.empty();
  if (!is_silent) return;
  if (default_step_increment > 0) s.step_phases.push_back({0, default_step_increment});
  if (default_step_increment == 0) s.additional_steps.push_back(0);
}

bool OutputTimes::is_due(const OutputTime& now) {
  const std::int64_t n_times = count_times(now.time), n_steps = count_steps(now.step);
  const bool is_scheduled = n_times > n_times_ || n_steps > n_steps_;
  n_times_ = n_times;
  n_steps_ = n_steps;
  const bool is_due = is_in_window(now.time) && (is_scheduled || now.is_last) && last_due_ != now.step;
  if (is_due) last_due_ = now.step;
  return is_due;
}

bool OutputTimes::is_in_window(double time) const {
  const double slack = rounding * std::abs(time);
  if (schedule_.start_time && time < *schedule_.start_time - slack) return false;
  return !schedule_.termination_time || time <= *schedule_.termination_time + slack;
}

std::int64_t OutputTimes::count_times(double time) const {
  constexpr double never = std::numeric_limits<double>::max();
  std::int64_t n = 0;
  const auto& phases = schedule_.time_phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    n += contactsim::count_times(phases[i], end_of(phases, i, never), time);
  }
  for (const double additional : schedule_.additional_times) {
    n += additional <= time + tolerance(time, 0.0) ? 1 : 0;
  }
  return n;
}

std::int64_t OutputTimes::count_steps(std::int64_t step) const {
  constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  std::int64_t n = 0;
  const auto& phases = schedule_.step_phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    n += contactsim::count_steps(phases[i], end_of(phases, i, never), step);
  }
  for (const std::int64_t additional : schedule_.additional_steps) n += additional <= step ? 1 : 0;
  return n;
}

std::optional<double> OutputTimes::next_time(double time) const {
  std::optional<double> next;
  const auto offer = [&](double candidate) {
    if (candidate <= time + tolerance(time, 0.0) || !is_in_window(candidate)) return;
    if (!next || candidate < *next) next = candidate;
  };
  constexpr double never = std::numeric_limits<double>::max();
  const auto& phases = schedule_.time_phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double end = end_of(phases, i, never);
    const auto n = static_cast<double>(contactsim::count_times(phases[i], end, time));
    const double candidate = phases[i].start + n * phases[i].increment;
    if (candidate < end - tolerance(end, phases[i].increment)) offer(candidate);
  }
  for (const double additional : schedule_.additional_times) offer(additional);
  return next;
}

}  // namespace contactsim
