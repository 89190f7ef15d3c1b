// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// BEGIN PARAMETERS FOR PRESTO REGION <region>. Source: Sierra/SM 5.22, 3.1.
struct ExplicitTimeParameters {
  DeckName name;                            ///< of the region
  std::optional<double> initial_time_step;  ///< absent: the critical step, > 0 [time]
  double time_step_scale_factor = 0.9;      ///< of the critical step, > 0 [1]
  double time_step_increase_factor = 1.1;   ///< largest growth from step to step, > 0 [1]
  std::int64_t step_interval = 100;         ///< steps between two lines of the log, >= 1
  std::optional<double> user_time_step;     ///< replaces the estimate, > 0 [time]
};

/// BEGIN PARAMETERS FOR ADAGIO REGION <region>. It makes the procedure implicit.
struct ImplicitTimeParameters {
  DeckName name;                               ///< of the region
  std::optional<double> time_increment;        ///< > 0 [time]
  std::optional<std::int64_t> n_time_steps;    ///< >= 1
  std::optional<DeckName> increment_function;  ///< of time, value [time]
};

/// BEGIN TIME STEPPING BLOCK <name>: a period, from its start to the start of the next one.
struct TimeSteppingBlock {
  DeckName name;
  double start_time = std::numeric_limits<double>::quiet_NaN();  ///< [time]
  std::vector<ExplicitTimeParameters> explicit_parameters;       ///< by region
  std::vector<ImplicitTimeParameters> implicit_parameters;       ///< by region
};

/// BEGIN TIME CONTROL. Source: Sierra/SM 5.22, 3.1.
struct TimeControl {
  DeckName name;
  std::vector<TimeSteppingBlock> time_stepping_blocks;                 ///< in deck order, start times rise
  double termination_time = std::numeric_limits<double>::quiet_NaN();  ///< [time]
};

}  // namespace contactsim
