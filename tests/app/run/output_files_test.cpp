// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/output_files.hpp"

#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "core/output/output_plan.hpp"
#include "io/exodus/qa_records.hpp"
#include "support/catch.hpp"
#include "support/exodus_times.hpp"
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
    files.command_line = "contactsim deck.i";
    files.clock = [] { return std::time_t{0}; };
  }

  /// Runs to a step. Returns the messages of the set-up.
  Names advance(int n_steps) {
    Diagnostics diagnostics;
    const ConditionScope scope{definition, region, {}, run.mesh, diagnostics};
    OutputPlan outputs(scope, run.model, {make_output_writers(files), results_path, {}, {}, {}, {}});
    paths = outputs.paths();
    for (int step = 0; step <= n_steps && !diagnostics.has_errors(); ++step) {
      run.state.step = step;
      run.state.time = step;
      run.deform((1.0 + step) * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
      outputs.write(run.state, step == n_steps);
    }
    Names messages;
    for (const Diagnostic& found : diagnostics.all()) messages.push_back(found.id + ": " + found.text);
    return messages;
  }

  std::string path(const std::string& name) const { return directory_.file(name); }

  SampleRun run;
  SimulationDefinition definition;
  Region region;
  OutputFileSettings files;
  std::optional<std::string> results_path;
  Names paths;

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

TEST_CASE("results hold the scheduled states and the last", "[app][outputs]") {
  OutputRun run;
  run.definition.title = "a plate";
  run.files.deck_lines = {"begin sierra", "end"};
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

TEST_CASE("the command line's results file goes before the deck's, and can do without", "[app][outputs]") {
  OutputRun run;
  run.results_path = run.path("mine.e");
  CHECK(run.advance(2).front() ==
        "output-schedule-missing: only the first and the last state are written to " + run.path("mine.e"));
  CHECK(read_times(NetcdfFile(run.path("mine.e"))) == std::vector<double>{0, 2});
  run.results_path = run.path("other.e");
  run.region.results_outputs = {results_of(1.0, {}), results_of(1.0, {})};
  run.region.results_outputs[1].database.name = DeckName{"%B_second.e", {}};
  run.advance(1);
  CHECK(run.paths == Names{run.path("other.e"), run.path("deck_second.e")});
}

TEST_CASE("history is an Exodus file of globals", "[app][outputs]") {
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

TEST_CASE("a heartbeat has a line for each step, or for each output that it watches", "[app][outputs]") {
  OutputRun run;
  HeartbeatOutput all, watching;
  all.variables = {request(L::global, "step")};
  all.precision = 1;
  watching = all;
  watching.stream = DeckName{"cout", {}};
  watching.monitored = HeartbeatOutput::Monitored::results;
  watching.has_labels = true;
  std::string log;
  run.files.log = [&](std::string_view text) { log += text; };
  run.region.results_outputs = {results_of(2.0, {})};
  run.region.heartbeat_outputs = {all, watching};
  CHECK(run.advance(2).empty());
  CHECK(run.paths == Names{run.path("deck.e"), run.path("deck.csv")});
  CHECK(read_bytes(run.path("deck.csv")) == "Time, step\n0e+00, 0e+00\n1e+00, 1e+00\n2e+00, 2e+00\n");
  CHECK(log == "Time, step\nTime=0e+00, step=0e+00\nTime=2e+00, step=2e+00\n");
}

TEST_CASE("a heartbeat that is continued keeps its lines and its legend", "[app][outputs]") {
  OutputRun run;
  HeartbeatOutput heartbeat;
  heartbeat.appends = true;
  heartbeat.precision = 1;
  run.region.heartbeat_outputs = {heartbeat};
  run.advance(0);
  run.advance(0);
  CHECK(read_bytes(run.path("deck.csv")) == "Time\n0e+00\n0e+00\n");
}

TEST_CASE("the format of a heartbeat gives its style, the deck's words go before", "[app][outputs]") {
  using Format = HeartbeatOutput::Format;
  HeartbeatOutput form;
  form.has_labels = true;
  form.precision = 1000000;
  CHECK(heartbeat_style(form).has_labels);
  CHECK(heartbeat_style(form).has_legend);
  CHECK(heartbeat_style(form).n_digits == 17);
  form.format = Format::spyhis;
  CHECK(heartbeat_style(form).is_spyhis);
  CHECK_FALSE(heartbeat_style(form).has_labels);
  form = {};
  form.format = Format::original;
  form.has_legend = true;
  CHECK(heartbeat_style(form).has_legend);
  CHECK(heartbeat_style(form).has_labels);
  CHECK(heartbeat_style(form).timestamp_format == "[%H:%M:%S]");
  form.timestamp_format = "";
  CHECK(heartbeat_style(form).timestamp_format == "");
}

TEST_CASE("programs that had their hand in the mesh stand before contactsim", "[app][outputs]") {
  OutputRun run;
  run.results_path = run.path("first.e");
  run.advance(0);
  run.files.mesh_path = run.path("first.e");
  run.results_path = run.path("second.e");
  run.advance(0);
  CHECK(read_qa_records(run.path("second.e")).size() == 2);
}

TEST_CASE("OVERWRITE = OFF keeps an older file", "[app][outputs]") {
  OutputRun run;
  run.region.results_outputs = {results_of(1.0, {})};
  run.region.results_outputs[0].database.overwrites = false;
  run.advance(0);
  CHECK_THROWS_WITH(run.advance(0), run.path("deck.e") + ": exists, and the deck says OVERWRITE = OFF");
}

// Written here and looked at by outputs_in_vtk.py, which CTest runs afterwards where VTK is installed.
TEST_CASE("output of a run for VTK to read", "[.][vtk]") {
  OutputRun run;
  run.results_path = std::string(CONTACTSIM_BINARY_DIR) + "/outputs_for_vtk.e";
  run.region.results_outputs = {
      results_of(1.0, {request(L::nodal, "displacement", "", "displ"), request(L::nodal, "velocity"),
                       request(L::element, "stress"), request(L::element, "log_strain"),
                       request(L::element, "eqps"), request(L::element, "principal_stresses")})};
  run.run.set_point_value(0, 0, 3, 7.0);
  run.advance(3);
}
