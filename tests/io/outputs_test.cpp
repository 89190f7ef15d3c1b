// SPDX-License-Identifier: BSD-3-Clause
#include "io/outputs.hpp"

#include <filesystem>

#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "io/exodus/sample_results.hpp"
#include "io/netcdf/netcdf_file.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;
using Names = std::vector<std::string>;

/// A region that writes into a directory of its own, over a run whose time is its step.
class OutputRun {
 public:
  OutputRun() {
    definition.deck_base = directory_.file("deck");
    settings.command_line = "contactsim deck.i";
    settings.clock = [] { return std::time_t{0}; };
  }

  /// Runs to a step. Returns the messages of the set-up.
  Names advance(int n_steps) {
    Diagnostics diagnostics;
    const ConditionScope scope{definition, region, {}, run.mesh, diagnostics};
    Outputs outputs(scope, run.model, settings);
    paths = outputs.paths();
    for (int step = 0; step <= n_steps && !diagnostics.has_errors(); ++step) {
      run.state.step = step;
      run.state.time = step;
      run.deform((1.0 + step) * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
      end = outputs.check_termination(run.state);
      outputs.write(run.state, end || step == n_steps);
      if (end) break;
    }
    Names messages;
    for (const Diagnostic& found : diagnostics.all())
      messages.push_back((found.severity == Severity::error ? "error: " : found.id + ": ") + found.text);
    return messages;
  }

  std::string path(const std::string& name) const { return directory_.file(name); }

  SampleRun run;
  SimulationDefinition definition;
  Region region;
  OutputSettings settings;
  Names paths;
  std::optional<std::string> end;

 private:
  TemporaryDirectory directory_;
};

OutputSchedule every_time(double increment) {
  OutputSchedule schedule;
  schedule.time_phases = {{0.0, increment}};
  return schedule;
}

ResultsOutput results_of(double increment, std::vector<VariableRequest> variables) {
  ResultsOutput output;
  output.schedule = every_time(increment);
  output.variables = std::move(variables);
  return output;
}

VariableRequest at_node(VariableRequest request, std::int64_t id) {
  request.place = SingleEntity{id, {}};
  return request;
}

}  // namespace

TEST_CASE("a region without output writes nothing", "[io][outputs]") {
  OutputRun run;
  CHECK(run.advance(2).empty());
  CHECK(run.paths.empty());
}

TEST_CASE("results hold the scheduled states and the last", "[io][outputs]") {
  OutputRun run;
  run.definition.title = "a plate";
  run.settings.deck_lines = {"begin sierra", "end"};
  run.region.results_outputs = {results_of(2.0, {request(L::nodal, "displacement", "", "displ")})};
  CHECK(run.advance(5).empty());
  CHECK(run.paths == Names{run.path("deck.e")});
  const NetcdfFile file(run.path("deck.e"));
  CHECK(read_times(file) == std::vector<double>{0, 2, 4, 5});
  std::vector<double> x(run.run.mesh.n_nodes());
  file.read_double(*file.find_variable("vals_nod_var1"), {2, 1}, x);
  for (std::size_t n = 0; n < x.size(); ++n)
    CHECK(x[n] == 4.0 * run.run.mesh.coordinates()(0, static_cast<Eigen::Index>(n)));
  CHECK(file.find_global_text("title") == "a plate");
  CHECK(file.read_texts(*file.find_variable("info_records")) ==
        Names{"contactsim deck.i", "begin sierra", "end"});
  const auto records = read_qa_records(run.path("deck.e"));
  REQUIRE(records.size() == 1);
  CHECK(records[0].code == "contactsim");
  CHECK(records[0].date.ends_with("70"));
}

TEST_CASE("the command line's results file goes before the deck's, and can do without", "[io][outputs]") {
  OutputRun run;
  run.settings.results_path = run.path("mine.e");
  CHECK(run.advance(2).front() ==
        "output-schedule-missing: only the first and the last state are written to " + run.path("mine.e"));
  CHECK(read_times(NetcdfFile(run.path("mine.e"))) == std::vector<double>{0, 2});
  run.settings.results_path = run.path("other.e");
  run.region.results_outputs = {results_of(1.0, {}), results_of(1.0, {})};
  run.region.results_outputs[1].database.name = DeckName{"%B_second.e", {}};
  run.advance(1);
  CHECK(run.paths == Names{run.path("other.e"), run.path("deck_second.e")});
}

TEST_CASE("history is an Exodus file of globals", "[io][outputs]") {
  OutputRun run;
  HistoryOutput history;
  history.variables = {at_node(request(L::nodal, "displacement", "", "tip"), 1010)};
  run.region.history_outputs = {history};
  CHECK(run.advance(2).empty());
  const NetcdfFile file(run.path("deck.h"));
  CHECK(read_times(file) == std::vector<double>{0, 1, 2});
  CHECK(file.read_texts(*file.find_variable("name_glo_var")) == Names{"tip_x", "tip_y", "tip_z"});
  std::vector<double> values(3);
  file.read_double(*file.find_variable("vals_glo_var"), {2, 1}, values);
  const Eigen::Vector3d place = run.run.mesh.coordinates().col(run.run.mesh.find_node(1010)->value);
  CHECK(values == std::vector<double>{2.0 * place[0], 2.0 * place[1], 2.0 * place[2]});
}

TEST_CASE("a heartbeat has a line for each step, or for each output that it watches", "[io][outputs]") {
  OutputRun run;
  HeartbeatOutput all, watching;
  all.variables = {request(L::global, "step")};
  all.precision = 1;
  watching = all;
  watching.stream = DeckName{"cout", {}};
  watching.monitored = HeartbeatOutput::Monitored::results;
  watching.has_labels = true;
  std::string log;
  run.settings.log = [&](std::string_view text) { log += text; };
  run.region.results_outputs = {results_of(2.0, {})};
  run.region.heartbeat_outputs = {all, watching};
  CHECK(run.advance(2).empty());
  CHECK(run.paths == Names{run.path("deck.e"), run.path("deck.csv")});
  CHECK(read_bytes(run.path("deck.csv")) == "Time, step\n0e+00, 0e+00\n1e+00, 1e+00\n2e+00, 2e+00\n");
  CHECK(log == "Time, step\nTime=0e+00, step=0e+00\nTime=2e+00, step=2e+00\n");
}

TEST_CASE("a heartbeat that is continued keeps its lines and its legend", "[io][outputs]") {
  OutputRun run;
  HeartbeatOutput heartbeat;
  heartbeat.appends = true;
  heartbeat.precision = 1;
  run.region.heartbeat_outputs = {heartbeat};
  run.advance(0);
  run.advance(0);
  CHECK(read_bytes(run.path("deck.csv")) == "Time\n0e+00\n0e+00\n");
}

TEST_CASE("what outputs cannot do is said before anything is written", "[io][outputs]") {
  OutputRun run;
  ResultsOutput output = results_of(1.0, {request(L::element, "memb_stress")});
  output.mesh = ResultsOutput::OutputMesh::exposed_surface;
  run.region.results_outputs = {output, results_of(1.0, {})};
  CHECK(run.advance(0) == Names{"output-mesh-whole: the file holds the whole mesh as it was read",
                                "output-variable-unknown: no element variable 'memb_stress' is known here",
                                "error: two outputs would write " + run.path("deck.e")});
  CHECK_FALSE(std::filesystem::exists(run.path("deck.e")));
}

TEST_CASE("a termination ends the run, and its last state is written", "[io][outputs]") {
  OutputRun run;
  run.region.results_outputs = {results_of(100.0, {})};
  SolutionTermination termination;
  termination.criteria.resize(1);
  termination.criteria[0].test = {{{"volume_sum", {}}, "", {}}, Comparison::greater, 200.0};
  run.region.terminations = {termination};
  UserOutput sum;
  sum.variables = {
      ReducedVariable{{"volume_sum", {}}, OutputReduction::sum, L::element, {{"volume", {}}, "", {}}}};
  run.region.user_outputs = {sum};
  CHECK(run.advance(10).empty());
  // 11 elements of (1 + t)^3: 297 at time 2.
  CHECK(run.end == "volume_sum is 297 > 200");
  CHECK(read_times(NetcdfFile(run.path("deck.e"))) == std::vector<double>{0, 2});
}

TEST_CASE("OVERWRITE = OFF keeps an older file", "[io][outputs]") {
  OutputRun run;
  run.region.results_outputs = {results_of(1.0, {})};
  run.region.results_outputs[0].database.overwrites = false;
  run.advance(0);
  CHECK_THROWS_WITH(run.advance(0), run.path("deck.e") + ": exists, and the deck says OVERWRITE = OFF");
}

TEST_CASE("output does not touch the state", "[io][outputs]") {
  OutputRun run;
  std::vector<VariableRequest> everything;
  const OutputVariables variables(run.run.model);
  for (const auto& [field, location] : {std::pair{FieldLocation::node, L::nodal},
                                        {FieldLocation::element, L::element},
                                        {FieldLocation::global, L::global}}) {
    for (const std::string& name : variables.names(field)) everything.push_back(request(location, name));
  }
  run.region.results_outputs = {results_of(1.0, everything)};
  CHECK(run.advance(0).empty());
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

// Written here and looked at by outputs_in_vtk.py, which CTest runs afterwards where VTK is installed.
TEST_CASE("output of a run for VTK to read", "[.][vtk]") {
  OutputRun run;
  run.settings.results_path = std::string(CONTACTSIM_BINARY_DIR) + "/outputs_for_vtk.e";
  run.region.results_outputs = {
      results_of(1.0, {request(L::nodal, "displacement", "", "displ"), request(L::nodal, "velocity"),
                       request(L::element, "stress"), request(L::element, "log_strain"),
                       request(L::element, "eqps"), request(L::element, "principal_stresses")})};
  run.run.set_point_value(0, 0, 3, 7.0);
  run.advance(3);
}
