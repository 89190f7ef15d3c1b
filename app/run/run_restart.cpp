// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "app/run/timed_force.hpp"
#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "core/parallel/on_root.hpp"
#include "io/pieces/piece_files.hpp"

namespace contactsim {

namespace {

OutputSchedule wall_schedule(const std::vector<WallTimePhase>& phases) {
  OutputSchedule schedule;
  for (const WallTimePhase& phase : phases) schedule.time_phases.push_back({phase.start, phase.increment});
  return schedule;
}

std::int64_t nanoseconds_now() {
  using std::chrono::system_clock, std::chrono::nanoseconds;
  return std::chrono::duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

RunRestart::RunRestart(const RunInput& input, Ranks& ranks, Diagnostics& diagnostics)
    : ranks_(ranks),
      time_(input.definition.restart.time),
      resumes_(input.definition.restart.is_automatic || input.definition.restart.time),
      begun_(nanoseconds_now()) {
  const std::vector<RestartData>& blocks = input.region.restart_data;
  if (blocks.empty()) {
    if (!resumes_) return;
    diagnostics.add_error(input.region.name.location, "RESTART needs a BEGIN RESTART DATA in the region",
                          "its DATABASE NAME says where the states are");
    return;
  }
  const RestartData& restart = blocks.front();
  for (std::size_t i = 1; i < blocks.size(); ++i)
    diagnostics.add_error(blocks[i].name.location, "a region has one BEGIN RESTART DATA");
  const auto path = [&](const std::optional<DeckName>& own) {
    const std::optional<DeckName>& name = own ? own : restart.database;
    return expand_file_name(input.definition, name ? name->text : "%B.rsout");
  };
  input_ = path(restart.input_database);
  output_ = path(restart.output_database);
  is_optional_ = restart.is_optional;
  overwrites_ = restart.overwrites;
  shifts_ = restart.shifts_to_start_time;
  resumes_ = resumes_ || restart.is_automatic || restart.restart_time;
  if (restart.restart_time) time_ = restart.restart_time;
  slots_ = RestartSlots(restart.overlay_count.value_or(0),
                        restart.file_cycle_count ? restart.file_cycle_count : restart.cycle_count);
  constexpr std::int64_t ends_only = 0;
  times_.emplace(resolve_schedule(restart.schedule, input.definition.output_schedulers, diagnostics),
                 ends_only);
  if (!restart.wall_time_phases.empty())
    wall_times_.emplace(wall_schedule(restart.wall_time_phases), ends_only);
}

std::vector<StoredState> RunRestart::stored_states(Diagnostics& warnings) const {
  std::vector<std::string> unusable;
  std::vector<StoredState> states = find_stored_states(input_, unusable);
  for (const std::string& problem : unusable) warnings.add_warning("restart-file-damaged", {}, problem);
  if (time_)
    std::ranges::stable_sort(states, {}, [&](const StoredState& state) { return distance_to(state); });
  if (states.empty() && !unusable.empty())
    throw FileError(input_, "none of the restart files of this name can be used");
  return states;
}

double RunRestart::distance_to(const StoredState& state) const {
  return time_ ? std::abs(state.head.time - *time_) : 0.0;
}

std::optional<StoredState> RunRestart::find_best() const {
  if (!resumes_) return std::nullopt;
  Diagnostics discarded;  // reported by find_state()
  const std::vector<StoredState> states = stored_states(discarded);
  return states.empty() ? std::nullopt : std::optional(states.front());
}

void RunRestart::check_overwriting() const {
  std::vector<std::string> unusable;
  if (overwrites_ || !times_) return;
  const std::vector<StoredState> states = find_stored_states(output_, unusable);
  if (!states.empty()) throw FileError(states.front().path, "exists, and the deck says OVERWRITE = OFF");
}

void RunRestart::find_state(const std::vector<std::string>& outputs, Diagnostics& warnings) {
  if (!resumes_) return check_overwriting();
  const std::vector<StoredState> states = stored_states(warnings);
  for (const StoredState& state : states) {
    try {
      earlier_ = read_restart_file(state.path);
    } catch (const FileError& problem) {
      warnings.add_warning("restart-file-damaged", {}, problem.what(), "an older state is taken");
      continue;
    }
    begun_ = state.head.begun;
    run_ = state.head.run + 1;
    is_of_latest_run_ = std::ranges::none_of(
        states, [&](const StoredState& other) { return other.head.begun > state.head.begun; });
    choose_run(outputs);
    source_ = state;
    return;
  }
  if (!states.empty()) throw FileError(input_, "none of the restart files of this name can be used");
  if (time_ && !is_optional_)
    throw FileError(restart_path(input_, 1, 1), "does not exist, and RESTART TIME needs it");
}

/// The first run from the one that follows the stored one on whose files do not exist.
void RunRestart::choose_run(const std::vector<std::string>& outputs) {
  std::vector<std::string> unusable;
  for (const StoredState& state : find_stored_states(output_, unusable))
    run_ = std::max(run_, state.head.run + 1);
  const auto exists = [&](const std::string& path) {
    std::error_code ignored;
    const std::string named = path + suffix();
    return std::filesystem::exists(named, ignored) || !find_decompositions(named).empty();
  };
  while (std::ranges::any_of(outputs, exists)) ++run_;
}

std::optional<StepTarget> RunRestart::step_target() const {
  if (!times_ || !times_->adjustment_interval()) return std::nullopt;
  return StepTarget{[times = *times_](double time) { return times.next_time(time); },
                    *times_->adjustment_interval()};
}

void RunRestart::begin(const State& state) {
  clock_begun_ = clock_seconds();
  if (times_) times_->is_due({state.step, state.time, false});
  if (wall_times_) wall_times_->is_due({state.step, 0.0, false});
}

bool RunRestart::is_due(const State& state, bool is_last) {
  const bool by_time = times_->is_due({state.step, state.time, is_last});
  if (!wall_times_) return by_time;
  const double seconds = ranks_.of_root(clock_seconds() - clock_begun_);
  return wall_times_->is_due({state.step, seconds, false}) || by_time;
}

bool RunRestart::is_due(const State& state, bool is_last, bool is_wanted) {
  return times_ && (is_due(state, is_last) || is_wanted) && last_step_ != state.step;
}

void RunRestart::store(const Checkpoint& checkpoint) {
  const State& state = checkpoint.state;
  last_path_ = restart_path(output_, run_, slots_.take());
  on_root(ranks_, [&] {
    StateArchive saved;
    archive(checkpoint, saved);
    write_restart_file(last_path_, {begun_, run_, state.step, state.time}, saved.take());
  });
  last_step_ = state.step;
  ++n_written_;
}

void warn_of_restart(const RunRestart& restart, std::span<const RunMark> changed, bool is_over,
                     Diagnostics& warnings) {
  const StoredState& state = *restart.source();
  // Steps end where they end, and decks write times to a few digits.
  const double time = std::abs(state.head.time);
  const double step = time / static_cast<double>(std::max<std::int64_t>(state.head.step, 1));
  if (restart.distance_to(state) > std::max(0.01 * time, 2.0 * step)) {
    warnings.add_warning(
        "restart-time", {},
        fmt::format("no state of t = {:.6g} is stored; the nearest one, of t = {:.6g} in {}, "
                    "is taken",
                    restart.time(), state.head.time, state.path));
  }
  if (!restart.is_of_latest_run()) {
    warnings.add_warning(
        "restart-run", {},
        fmt::format("{} is of an earlier run than other states of {}", state.path, restart.input()),
        "a DATABASE NAME of its own for each study keeps runs apart");
  }
  if (is_over) {
    warnings.add_warning(
        "restart-over", {},
        fmt::format("the state in {} is of t = {:.6g}, where the run ends: nothing is left to do", state.path,
                    state.head.time),
        "a later TERMINATION TIME, or another SOLUTION TERMINATION where one ended it, lets it go on");
  }
  for (const RunMark& mark : changed) {
    warnings.add_warning("restart-changed", mark.location,
                         fmt::format("{} is not as it was in the run that stored {}", mark.what, state.path),
                         "the run goes on with the new one from the old state");
  }
}

}  // namespace contactsim
