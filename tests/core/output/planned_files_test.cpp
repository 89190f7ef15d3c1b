// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/planned_files.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// What is planned for the sample run in the deck "crash.i" titled "a crash".
struct Plans {
  Plans() {
    definition.deck_base = "crash";
    definition.title = "a crash";
  }
  PlannedResults results(const ResultsOutput& output, const std::optional<std::string>& path = {}) {
    return plan_results(scope, output, path, variables);
  }
  PlannedResults history(const HistoryOutput& output) { return plan_history(scope, output, variables); }
  PlannedHeartbeat heartbeat(const HeartbeatOutput& output) {
    return plan_heartbeat(scope, output, variables);
  }

  SampleRun run;
  SimulationDefinition definition;
  Region region;
  Diagnostics diagnostics;
  OutputVariables variables{run.model};
  ConditionScope scope{definition, region, {}, run.mesh, diagnostics};
};

HeartbeatOutput to_stream(const std::string& name) {
  HeartbeatOutput output;
  output.stream = DeckName{name, {}};
  return output;
}

}  // namespace

TEST_CASE("files have the deck's name and title unless it says otherwise", "[core][output]") {
  Plans plans;
  CHECK(plans.results({}).file.path == "crash.e");
  CHECK(plans.results({}).file.title == "a crash");
  CHECK(plans.history({}).file.path == "crash.h");
  CHECK(plans.heartbeat({}).file.path == "crash.csv");
  ResultsOutput own;
  own.database.name = DeckName{"%B_2.exo", {}};
  own.database.title = "mine";
  own.database.overwrites = false;
  CHECK(plans.results(own).file.path == "crash_2.exo");
  CHECK(plans.results(own).file.title == "mine");
  CHECK_FALSE(plans.results(own).file.overwrites);
  CHECK(plans.results(own, "given.e").file.path == "given.e");
  plans.definition.title.clear();
  plans.definition.name.text = "sierra crash";
  CHECK(plans.results({}).file.title == "sierra crash");
}

TEST_CASE("heartbeats to the terminal go to the log", "[core][output]") {
  Plans plans;
  for (const char* name : {"cout", "STDOUT", "outputP0", "Log"})
    CHECK(plans.heartbeat(to_stream(name)).file.path.empty());
  CHECK(plans.heartbeat(to_stream("logs")).file.path == "logs");
}

TEST_CASE("without a schedule results have their ends, the others every step", "[core][output]") {
  Plans plans;
  OutputTimes results = plans.results({}).times, history = plans.history({}).times;
  CHECK(plans.diagnostics.all()[0].id == "output-schedule-missing");
  PlannedHeartbeat heartbeat = plans.heartbeat({});
  CHECK_FALSE(heartbeat.has_schedule);
  for (OutputTimes* times : {&results, &history, &heartbeat.times}) CHECK(times->is_due({0, 0.0, false}));
  CHECK_FALSE(results.is_due({1, 1.0, false}));
  CHECK(results.is_due({1, 1.0, true}));
  CHECK(history.is_due({1, 1.0, false}));
  CHECK(heartbeat.times.is_due({1, 1.0, false}));
}

TEST_CASE("an output uses the scheduler that it names", "[core][output]") {
  Plans plans;
  OutputScheduler scheduler;
  scheduler.name = {"rare", {}};
  scheduler.schedule.step_phases = {{0, 5}};
  plans.definition.output_schedulers = {scheduler};
  HeartbeatOutput output;
  output.schedule.scheduler = DeckName{"Rare", {}};
  PlannedHeartbeat heartbeat = plans.heartbeat(output);
  CHECK(heartbeat.has_schedule);
  CHECK(heartbeat.times.is_due({0, 0.0, false}));
  CHECK_FALSE(heartbeat.times.is_due({4, 4.0, false}));
  CHECK(heartbeat.times.is_due({5, 5.0, false}));
}
