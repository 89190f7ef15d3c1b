// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/definition/declarations.hpp"
#include "core/definition/time_control.hpp"

namespace contactsim {

/// A time stepping block of the deck as one region sees it.
struct TimePeriod {
  std::string name;
  double start = 0.0;  ///< [time]
  ExplicitTimeParameters parameters;
};

/// Someone who wants steps to end at certain times. Source: Sierra/SM 5.22, TIMESTEP ADJUSTMENT INTERVAL.
struct StepTarget {
  std::function<std::optional<double>(double time)> next_time;  ///< the first after a time [time]
  std::int64_t n_steps = 1;  ///< over so many steps before its time the steps may be shortened, >= 1
};

/// The stable step that a run may use: the least of late, from which it comes back step by step. Steps that
/// followed the stable one through every vibration, larger as the elements grow and smaller as they shrink,
/// would feed the vibration: central differences keep an energy that depends on the step. Held, they change
/// for good reasons only, and what has passed is forgotten; one that jumped up afterwards would change that
/// energy at once. Source: Skeel and Gear, Physica D 60 (1992) 311-313, for why.
struct HeldStableStep {
  static constexpr std::int64_t n_steps = 100;  ///< at least so many are remembered, at most twice as many
  static constexpr double recovery = 1.005;     ///< by no more than this it grows from step to step [1]
  static constexpr double forever = std::numeric_limits<double>::infinity();

  double now = forever;     ///< the least of the last `count` steps [time]
  double before = forever;  ///< the least of the n_steps before those [time]
  std::int64_t count = 0;
  double returning = 0.0;  ///< what it has come back to so far; 0 where it is held [time]

  /// Takes in the stable step of the elements and of contact; returns what the run may use.
  double take(double stable);
  /// What was returned last [time].
  double held() const { return returning > 0.0 ? returning : std::min(now, before); }

 private:
  double min_with(double stable);
};

/// How long the run is and how large its steps are. Source: Sierra/SM 5.22, 3.1.
class TimeStepControl {
 public:
  /// Precondition: the periods are in order of time, at least one.
  TimeStepControl(std::vector<TimePeriod> periods, double termination_time)
      : periods_(std::move(periods)), termination_time_(termination_time) {}

  std::span<const TimePeriod> periods() const { return periods_; }
  /// Whether a run that has come to this time by this step ends: at the first step at or past the termination
  /// time.
  bool is_over(double time, double step) const;
  double start_time() const { return periods_.front().start; }
  double termination_time() const { return termination_time_; }
  /// Position of the period that a time belongs to; each one begins at its start.
  std::size_t period_at(double time) const;

  /// When that ends: at the start of the next one, or at the termination time [time].
  double end_of_period(double time) const {
    const std::size_t next = period_at(time) + 1;
    return next < periods_.size() ? periods_[next].start : termination_time_;
  }

  /// The share of the stable step that is taken [1].
  double scale_factor_at(double time) const {
    return periods_[period_at(time)].parameters.time_step_scale_factor;
  }

  /// From now on shortens steps such that one of them ends at each time of the target.
  void add_target(StepTarget target) { targets_.push_back(std::move(target)); }

  /// Size of the step that begins at a time: the user's; else the stable one scaled, grown by no more than
  /// the increase factor, the first no larger than the initial one; shortened for the targets.
  ///   stable   the largest that is stable [time]
  ///   before   size of the step before, 0 if there is none [time]
  double step_after(double time, double before, double stable) const;

 private:
  double free_step_after(double time, double before, double stable) const;

  std::vector<TimePeriod> periods_;
  std::vector<StepTarget> targets_;
  double termination_time_;
};

/// The time control of a region's procedure. Precondition: the binder found no error in it.
TimeStepControl make_time_step_control(const Procedure& procedure, const Region& region);

}  // namespace contactsim
