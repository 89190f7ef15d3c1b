// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <nlohmann/json.hpp>

#include "app/reports/run_summary.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using nlohmann::json;

TEST_CASE("a number that is not finite is null in a summary", "[app][summary]") {
  RunSummary summary;
  summary.run.emplace();
  summary.run->energies.internal = std::numeric_limits<double>::quiet_NaN();
  summary.run->energies.error = std::numeric_limits<double>::infinity();
  SummaryPair pair;
  pair.history.emplace().deepest_share = std::numeric_limits<double>::infinity();
  summary.pairs = {pair};
  const json written = json::parse(format_summary(summary));
  CHECK(written["run"]["energies"]["internal"].is_null());
  CHECK(written["run"]["energies"]["error"].is_null());
  CHECK(written["run"]["energies"]["kinetic"] == 0.0);
  CHECK(written["pairs"][0]["deepest_share"].is_null());
  CHECK(written["run"]["wall_time"].is_null());
}

TEST_CASE("warnings of a summary are counted by id, errors keep their order", "[app][summary]") {
  RunSummary summary;
  summary.found.add_warning("b-id", {}, "first of b");
  summary.found.add_warning("a-id", {}, "of a");
  summary.found.add_warning("b-id", {}, "second of b");
  summary.found.add_error({}, "z", "do this");
  summary.error_lines = {"error: a file"};
  const json written = json::parse(format_summary(summary));
  REQUIRE(written["warnings"].size() == 2);
  CHECK(written["warnings"][0]["id"] == "a-id");
  CHECK(written["warnings"][1]["count"] == 2);
  CHECK(written["warnings"][1]["text"] == "first of b");
  REQUIRE(written["errors"].size() == 2);
  CHECK(written["errors"][0]["text"] == "z; do this");
  CHECK(written["errors"][0]["line"].is_null());
  CHECK(written["errors"][1]["text"] == "a file");
}

TEST_CASE("a state of a summary follows from its exit code", "[app][summary]") {
  RunSummary summary;
  const auto state = [&] { return json::parse(format_summary(summary))["state"]; };
  CHECK(state() == "running");
  summary.exit_code = ExitCode::done;
  CHECK(state() == "done");
  summary.exit_code = ExitCode::stopped;
  CHECK(state() == "stopped");
  summary.exit_code = ExitCode::solve;
  CHECK(state() == "failed");
}

TEST_CASE("what a summary does not know is null", "[app][summary]") {
  const json written = json::parse(format_summary({}));
  CHECK(written["mesh"].is_null());
  CHECK(written["run"].is_null());
  CHECK(written["exit_code"].is_null());
  CHECK(written["deck"]["digest"].is_null());
  CHECK(written["definitions"] == json::object());
  CHECK(written["pairs"] == json::array());
  CHECK(written["warnings"] == json::array());

  RunSummary begun;
  begun.mesh = SummaryMesh{"m.g", "", {}, {}};
  begun.run.emplace();
  begun.pairs.resize(1);
  const json more = json::parse(format_summary(begun));
  CHECK(more["mesh"]["path"] == "m.g");
  CHECK(more["mesh"]["digest"].is_null());
  CHECK(more["mesh"]["nodes"].is_null());
  CHECK(more["run"]["ended_by"].is_null());
  CHECK(more["run"]["stable_step"].is_null());
  CHECK(more["run"]["energies"]["error_share"] == 0.0);
  CHECK_FALSE(more["run"]["energies"].contains("contact_stabilization"));
  CHECK(more["pairs"][0]["peak_force"].is_null());
  CHECK(more["pairs"][0]["passages"].is_null());
}

TEST_CASE("a run of a summary has what it came to, and runs before it stand by procedure", "[app][summary]") {
  RunSummary summary;
  SummaryRun& run = summary.run.emplace();
  run.n_steps = 12;
  run.time = 0.5;
  run.stable_step = 1e-3;
  run.ended_by = "SIGTERM";
  run.seconds = 2.0;
  run.parts = {{"elements", 1.5}};
  run.energies.error = -3.0;
  run.energies.largest = 100.0;
  run.energies.stabilization = 0.25;
  SummaryRun before;
  before.procedure = "press";
  before.n_steps = 3;
  summary.earlier_runs = {before};
  const json written = json::parse(format_summary(summary));
  CHECK(written["run"]["steps"] == 12);
  CHECK(written["run"]["ended_by"] == "SIGTERM");
  CHECK(written["run"]["stable_step"] == 1e-3);
  CHECK(written["run"]["wall_time"]["whole"] == 2.0);
  CHECK(written["run"]["wall_time"]["parts"][0] == json{{"name", "elements"}, {"seconds", 1.5}});
  CHECK(written["run"]["energies"]["error_share"] == -0.03);
  CHECK(written["run"]["energies"]["contact_stabilization"] == 0.25);
  CHECK(written["earlier_runs"][0]["procedure"] == "press");
  CHECK(written["earlier_runs"][0]["run"]["steps"] == 3);
}
