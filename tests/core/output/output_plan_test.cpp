// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;
using Names = std::vector<std::string>;
using Monitored = HeartbeatOutput::Monitored;

/// A region whose plan writes into a list of what was called, over a run whose time is its step.
class PlannedRun {
 public:
  PlannedRun() {
    definition.deck_base = "deck";
    settings.writers.open_results = [this](
                                        const ResultsFile& file, const Mesh& mesh,
                                        std::span<const OutputField> fields) -> OutputWriters::OpenResults {
      calls.push_back(
          fmt::format("open {} of {} nodes for {} fields", file.path, mesh.n_nodes(), fields.size()));
      return {.append =
                  [this, path = file.path, n_fields = fields.size()](
                      double time, const OutputWriters::FieldValues& values) {
                    calls.push_back(fmt::format("{} at {}", path, time));
                    for (std::size_t i = 0; i < n_fields; ++i) n_values += values(i).size();
                  },
              .piece = piece};
    };
    settings.writers.open_heartbeat = [this](const HeartbeatFile& file, const Names& names) {
      calls.push_back(fmt::format("open '{}' for {}", file.path, fmt::join(names, " ")));
      return [this, path = file.path](double time, std::span<const double> values) {
        calls.push_back(fmt::format("'{}' at {}: {}", path, time, fmt::join(values, " ")));
      };
    };
  }
  PlannedRun(const PlannedRun&) = delete;
  PlannedRun& operator=(const PlannedRun&) = delete;

  OutputPlan make_plan() {
    const ConditionScope scope{definition, region, {}, run.mesh, diagnostics};
    return {scope, run.model, settings};
  }
  void set_step(int step) {
    run.state.step = step;
    run.state.time = step;
    run.deform((1.0 + step) * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  }
  /// Runs to a step, or to where the deck ends the run. Returns why.
  std::optional<std::string> advance(OutputPlan& plan, int n_steps) {
    std::optional<EarlyEnd> end;
    for (int step = 0; step <= n_steps && !end; ++step) {
      set_step(step);
      end = plan.check_termination(run.state);
      plan.write(run.state, end || step == n_steps);
    }
    return end ? std::optional(end->reason) : std::nullopt;
  }
  Names messages() const {
    Names messages;
    for (const Diagnostic& found : diagnostics.all())
      messages.push_back((found.severity == Severity::error ? "error: " : found.id + ": ") + found.text);
    return messages;
  }

  SampleRun run;
  SimulationDefinition definition;
  Region region;
  OutputSettings settings;
  Diagnostics diagnostics;
  Names calls;
  std::size_t n_values = 0;
  std::shared_ptr<const MeshPiece> piece;  ///< of all results files
};

OutputSchedule every_time(double increment) {
  OutputSchedule schedule;
  schedule.time_phases = {{0.0, increment}};
  return schedule;
}

ResultsOutput results_of(double increment, std::vector<VariableRequest> variables = {}) {
  ResultsOutput output;
  output.schedule = every_time(increment);
  output.variables = std::move(variables);
  return output;
}

HeartbeatOutput steps_to(const std::string& stream, std::optional<Monitored> monitored = {}) {
  HeartbeatOutput output;
  output.stream = DeckName{stream, {}};
  output.variables = {request(L::global, "step")};
  output.monitored = monitored;
  return output;
}

}  // namespace

TEST_CASE("a region without output writes nothing", "[core][output]") {
  PlannedRun run;
  OutputPlan plan = run.make_plan();
  CHECK_FALSE(run.advance(plan, 2));
  CHECK(run.calls.empty());
  CHECK(plan.paths().empty());
}

TEST_CASE("results are written by schedule, with the last state, histories without a mesh",
          "[core][output]") {
  PlannedRun run;
  run.region.results_outputs = {results_of(2.0, {request(L::nodal, "mass")})};
  run.region.history_outputs = {HistoryOutput{}};
  run.region.history_outputs[0].schedule = every_time(3.0);
  OutputPlan plan = run.make_plan();
  run.advance(plan, 3);
  CHECK(run.calls == Names{"open deck.e of 46 nodes for 9 fields", "open deck.h of 0 nodes for 0 fields",
                           "deck.e at 0", "deck.h at 0", "deck.e at 2", "deck.e at 3", "deck.h at 3"});
  // The mass of each node, seven numbers and a vector, three times.
  CHECK(run.n_values == 3 * (46 + 7 + 3));
}

TEST_CASE("a piece of results has its own values, and needs no whole state", "[core][output]") {
  PlannedRun run;
  run.piece = std::make_shared<const MeshPiece>(MeshPiece{{5, 3, 4}, {{8, 0}, {}}});
  run.settings.complete_state = [&run] { run.calls.push_back("all"); };
  run.region.results_outputs = {
      results_of(2.0, {request(L::nodal, "velocity"), request(L::element, "von_mises")})};
  run.region.heartbeat_outputs = {steps_to("log"), steps_to("all.csv")};
  run.region.heartbeat_outputs[1].variables = {request(L::global, "dead_elements")};
  run.region.heartbeat_outputs[1].schedule = every_time(3.0);
  run.region.heartbeat_outputs[0].schedule = every_time(2.0);
  OutputPlan plan = run.make_plan();
  run.advance(plan, 3);
  run.calls.erase(run.calls.begin(), run.calls.begin() + 3);
  // A number of elements is counted over all of them.
  CHECK(run.calls == Names{"all", "deck.e at 0", "'' at 0: 0", "'all.csv' at 0: 0", "deck.e at 2",
                           "'' at 2: 2", "all", "deck.e at 3", "'' at 3: 3", "'all.csv' at 3: 0"});
  // Three nodes and two elements, seven numbers and a vector, three times.
  CHECK(run.n_values == 3 * (9 + 2 + 7 + 3));
}

TEST_CASE("a heartbeat may watch results, history or restart, and have a schedule besides",
          "[core][output]") {
  PlannedRun run;
  run.region.results_outputs = {results_of(2.0)};
  run.region.heartbeat_outputs = {steps_to("cout"), steps_to("results", Monitored::results),
                                  steps_to("restart", Monitored::restart),
                                  steps_to("both", Monitored::results)};
  run.region.heartbeat_outputs[3].schedule = every_time(3.0);
  OutputPlan plan = run.make_plan();
  for (int step = 0; step <= 3; ++step) {
    run.set_step(step);
    plan.write(run.run.state, false);
    if (step == 1) plan.write_at_restart(run.run.state);
    if (step == 1) plan.write_at_restart(run.run.state);  // a step is one line
  }
  Names lines;
  std::copy_if(run.calls.begin(), run.calls.end(), std::back_inserter(lines), [](const std::string& call) {
    return call.find("at ") != std::string::npos && call[0] == '\'';
  });
  CHECK(lines == Names{"'' at 0: 0", "'results' at 0: 0", "'both' at 0: 0", "'' at 1: 1", "'restart' at 1: 1",
                       "'' at 2: 2", "'results' at 2: 2", "'both' at 2: 2", "'' at 3: 3", "'both' at 3: 3"});
}

TEST_CASE("a run that goes on has files of its own, but for heartbeats that append", "[core][output]") {
  PlannedRun run;
  run.region.results_outputs = {results_of(1.0)};
  run.region.heartbeat_outputs = {steps_to("a.csv"), steps_to("b.csv"), steps_to("log")};
  run.region.heartbeat_outputs[1].appends = true;
  OutputPlan plan = run.make_plan();
  plan.add_suffix("-s0002");
  CHECK(plan.paths() == Names{"deck.e-s0002", "a.csv-s0002", "b.csv"});
  run.set_step(2);
  plan.resume(run.run.state);
  plan.write(run.run.state, false);
  CHECK(run.calls.back() == "open '' for step");  // what was due then has been written
}

TEST_CASE("outputs that may stretch steps say to which times", "[core][output]") {
  PlannedRun run;
  run.region.results_outputs = {results_of(2.0), results_of(1.0)};
  run.region.results_outputs[1].schedule.adjustment_interval = 4;
  run.region.results_outputs[1].database.name = DeckName{"other.e", {}};
  const std::vector<StepTarget> targets = run.make_plan().step_targets();
  REQUIRE(targets.size() == 1);
  CHECK(targets[0].next_time(0.5) == 1.0);
}

TEST_CASE("a file that only the command line asks for has the usual fields", "[core][output]") {
  PlannedRun run;
  run.settings.results_path = "mine.e";
  OutputPlan plan = run.make_plan();
  run.advance(plan, 0);
  // Displacement, velocity, stress and von Mises of two blocks, and eight globals.
  CHECK(run.calls.front() == "open mine.e of 46 nodes for 14 fields");
}

TEST_CASE("what outputs cannot do is said before anything is written", "[core][output]") {
  PlannedRun run;
  ResultsOutput output = results_of(1.0, {request(L::element, "memb_stress")});
  output.mesh = ResultsOutput::OutputMesh::exposed_surface;
  run.region.results_outputs = {output, ResultsOutput{}};
  run.make_plan();
  CHECK(run.messages() ==
        Names{"output-mesh-whole: the file holds the whole mesh as it was read",
              "output-variable-unknown: no element variable 'memb_stress' is known here",
              "output-schedule-missing: only the first and the last state are written to deck.e",
              "error: two outputs would write deck.e"});
  CHECK(run.calls.empty());
}

TEST_CASE("outputs in pieces clash by their names, and by what they write", "[core][output]") {
  const auto messages = [](const std::string& heartbeat, std::vector<ResultsOutput> results) {
    PlannedRun run;
    run.settings.writers.name_results = [](const ResultsFile& file) {
      return Names{file.path + ".2.0", file.path + ".2.1"};
    };
    run.region.results_outputs = std::move(results);
    run.region.heartbeat_outputs = {steps_to(heartbeat)};
    run.make_plan();
    return run.messages();
  };
  CHECK(messages("a.csv", {results_of(1.0)}).empty());
  CHECK(messages("a.csv", {results_of(1.0), results_of(2.0)}) ==
        Names{"error: two outputs would write deck.e"});
  CHECK(messages("deck.e.2.1", {results_of(1.0)}) == Names{"error: two outputs would write deck.e.2.1"});
}

TEST_CASE("outputs of one file are found however their paths are spelled", "[core][output]") {
  const auto clashes = [](const std::string& one, const std::string& other) {
    PlannedRun run;
    run.region.results_outputs = {ResultsOutput{}, ResultsOutput{}};
    run.region.results_outputs[0].database.name = DeckName{one, {}};
    run.region.results_outputs[1].database.name = DeckName{other, {}};
    run.make_plan();
    const auto messages = run.messages();
    return std::ranges::count(messages, "error: two outputs would write " + other) == 1;
  };
  CHECK(clashes("a.e", (std::filesystem::current_path() / "a.e").string()));
  CHECK(clashes("a.e", "./a.e"));
  CHECK(clashes("a.e", "a.e.part"));
  CHECK_FALSE(clashes("a.e", "b.e"));
}

TEST_CASE("a termination ends the run, and its last state is written", "[core][output]") {
  PlannedRun run;
  run.region.results_outputs = {results_of(100.0)};
  SolutionTermination termination;
  termination.criteria.resize(1);
  termination.criteria[0].test = {{{"volume_sum", {}}, "", {}}, Comparison::greater, 200.0};
  run.region.terminations = {termination};
  UserOutput sum;
  sum.variables = {
      ReducedVariable{{"volume_sum", {}}, OutputReduction::sum, L::element, {{"volume", {}}, "", {}}}};
  run.region.user_outputs = {sum};
  OutputPlan plan = run.make_plan();
  // 11 elements of (1 + t)^3: 297 at time 2.
  CHECK(run.advance(plan, 10) == "volume_sum is 297 > 200");
  CHECK(run.calls.back() == "deck.e at 2");
}

TEST_CASE("output does not touch the state", "[core][output]") {
  PlannedRun run;
  std::vector<VariableRequest> everything;
  const OutputVariables variables(run.run.model);
  for (const auto& [field, location] : {std::pair{FieldLocation::node, L::nodal},
                                        {FieldLocation::element, L::element},
                                        {FieldLocation::global, L::global}}) {
    for (const std::string& name : variables.names(field)) everything.push_back(request(location, name));
  }
  run.region.results_outputs = {results_of(1.0, everything)};
  OutputPlan plan = run.make_plan();
  run.advance(plan, 0);
  CHECK(run.messages().empty());
  const SampleRun fresh;
  CHECK(run.run.state.coordinates == fresh.state.coordinates);
  CHECK(run.run.state.velocity == fresh.state.velocity);
  for (std::size_t b = 0; b < 2; ++b) {
    const auto& values = run.run.state.blocks[b].values;
    std::size_t n_changed = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      n_changed += (values[i] != fresh.state.blocks[b].values[i]).any();
    CHECK(n_changed == 0);
  }
}
