// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// AT TIME <start> INCREMENT = <increment>: from `start` on, until a later phase takes over.
struct TimePhase {
  double start = 0.0;      ///< [time]
  double increment = 0.0;  ///< > 0 [time]
};

/// AT STEP <start> INCREMENT = <increment>: from step `start` on, until a later phase takes over.
struct StepPhase {
  std::int64_t start = 0;      ///< >= 0
  std::int64_t increment = 1;  ///< >= 1
};

/// When an output is written. What several lines ask for adds up. Source: Sierra/SM 5.22, 9.2.
struct OutputSchedule {
  std::vector<TimePhase> time_phases;          ///< in deck order
  std::vector<StepPhase> step_phases;          ///< in deck order
  std::vector<double> additional_times;        ///< [time]
  std::vector<std::int64_t> additional_steps;  ///< >= 0
  std::optional<double> start_time;            ///< nothing is written before it [time]
  std::optional<double> termination_time;      ///< nothing is written after it [time]
  /// Number of steps before an output time over which steps are stretched to hit it; absent: not stretched.
  std::optional<std::int64_t> adjustment_interval;
  std::optional<DeckName> scheduler;  ///< USE OUTPUT SCHEDULER: a schedule defined at Sierra scope
};

/// BEGIN OUTPUT SCHEDULER <name>.
struct OutputScheduler {
  DeckName name;
  OutputSchedule schedule;
};

}  // namespace contactsim
