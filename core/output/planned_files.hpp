// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/conditions/condition_scope.hpp"
#include "core/output/output_times.hpp"
#include "core/output/output_writers.hpp"
#include "core/output/requested_fields.hpp"

namespace contactsim {

/// A results or history file: what it holds, and when it is written.
struct PlannedResults {
  ResultsFile file;
  OutputTimes times;
  RequestedFields fields;
};

/// A heartbeat: what its lines hold, and when they are written.
struct PlannedHeartbeat {
  HeartbeatFile file;
  bool has_schedule = false;  ///< of its own
  OutputTimes times;
  RequestedFields values;
};

/// Whether the lines of a heartbeat go to the log, as those of STREAM NAME = COUT, LOG and the like.
bool goes_to_log(const HeartbeatOutput& output);

/// The results of a run that is asked for a file by the command line alone.
ResultsOutput make_default_results();

/// The file of a RESULTS OUTPUT. Unknown variables are warnings, as is a missing schedule. The variables must
/// outlive it.
///   path  in place of the deck's
PlannedResults plan_results(const ConditionScope& scope, const ResultsOutput& output,
                            const std::optional<std::string>& path, const OutputVariables& variables);

/// The file of a HISTORY OUTPUT: of every step without a schedule.
PlannedResults plan_history(const ConditionScope& scope, const HistoryOutput& output,
                            const OutputVariables& variables);

/// The lines of a HEARTBEAT OUTPUT: of every step without a schedule.
PlannedHeartbeat plan_heartbeat(const ConditionScope& scope, const HeartbeatOutput& output,
                                const OutputVariables& variables);

}  // namespace contactsim
