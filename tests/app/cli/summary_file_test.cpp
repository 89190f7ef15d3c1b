// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/summary_file.hpp"

#include <csignal>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::TwoBlocks;
using nlohmann::json;

namespace {

struct Blocks : TwoBlocks {
  json summary() const { return json::parse(read("s.json")); }
};

}  // namespace

TEST_CASE("a check and a parse have a summary as far as they go", "[app][summary]") {
  const Blocks directory;
  CHECK(directory.run({"two_blocks.i", "--parse", "--summary", "s.json"}).exit_code == 0);
  json summary = directory.summary();
  CHECK(summary["stage"] == "parse");
  CHECK(summary["state"] == "done");
  CHECK(summary["mesh"].is_null());
  CHECK(summary["run"].is_null());
  CHECK(summary["deck"]["digest"].is_string());

  const auto check =
      directory.run({"two_blocks.i", "--check", "-D", "order=2", "--threads", "2", "--summary", "s.json"});
  CHECK(check.exit_code == 0);
  summary = directory.summary();
  CHECK(summary["stage"] == "check");
  CHECK(summary["definitions"] == json{{"order", "2"}});
  CHECK(summary["threads"] == 2);
  CHECK(summary["mesh"]["path"] == "two_blocks.g");
  CHECK(summary["mesh"]["elements"] == 72);
  CHECK(summary["pairs"].size() == summary["pairs_in_all"]);
  CHECK(summary["pairs"][0]["peak_force"].is_null());
  CHECK(summary["warnings"][0]["id"] == "surface-empty");
  CHECK(summary["warnings"][0]["count"] == 1);
}

TEST_CASE("a run has steps, energies, pairs and wall times in its summary", "[app][summary]") {
  const Blocks directory;
  CHECK(directory.run({"two_blocks.i", "--summary", "s.json"}).exit_code == 0);
  const json summary = directory.summary();
  const json& run = summary["run"];
  CHECK(summary["exit_code"] == 0);
  CHECK(run["steps"].get<int>() > 1);
  CHECK(run["time"].get<double>() >= run["termination_time"].get<double>());
  CHECK(run["stable_step"].get<double>() > 0.0);
  CHECK(run["energies"]["kinetic"].is_number());
  CHECK(run["wall_time"]["parts"][0]["name"] == "elements");
  CHECK(summary["pairs"][0]["contact_time"].is_number());
  CHECK(summary["warnings"].size() == 1);
  CHECK(summary["warnings"][0]["count"] == 2);
}

TEST_CASE("errors are in the summary with their place", "[app][summary]") {
  const Blocks directory;
  directory.write("wrong.i", "begin sierra\n  bogus = 3\nend\n");
  CHECK(directory.run({"wrong.i", "--summary", "s.json"}).exit_code == 2);
  json summary = directory.summary();
  CHECK(summary["state"] == "failed");
  CHECK(summary["exit_code"] == 2);
  REQUIRE(summary["errors"].size() == 1);
  CHECK(summary["errors"][0]["file"] == "wrong.i");
  CHECK(summary["errors"][0]["line"] == 2);
  CHECK(summary["errors"][0]["text"] == "unknown command 'bogus = 3' in 'sierra'");

  CHECK(directory.run({"two_blocks.i", "none.g", "--summary", "s.json"}).exit_code == 3);
  summary = directory.summary();
  CHECK(summary["exit_code"] == 3);
  CHECK(summary["mesh"]["digest"].is_null());
  CHECK_THAT(summary["errors"].back()["text"].get<std::string>(), Contains("none.g"));
}

TEST_CASE("a log that cannot be written is in the summary", "[app][summary]") {
  const Blocks directory;
  CHECK(directory.run({"two_blocks.i", "--log", "no/l.log", "--summary", "s.json"}).exit_code == 3);
  CHECK_THAT(directory.summary()["errors"][0]["text"].get<std::string>(), Contains("no/l.log"));
}

TEST_CASE("a summary that cannot be written ends a run before it begins", "[app][summary]") {
  const Blocks directory;
  const auto [code, out, err] = directory.run({"two_blocks.i", "--summary", "no/such/s.json"});
  CHECK(code == 3);
  CHECK(out == "");
  CHECK(err == "error: no/such/s.json: the file cannot be written\n");
  CHECK_FALSE(directory.has("two_blocks.log"));
  CHECK(directory.run({"two_blocks.i", "--summary", "/dev/full"}).exit_code == 3);
}

TEST_CASE("a summary never overwrites another file of the run", "[app][summary]") {
  const Blocks directory;
  const std::string deck = directory.read("two_blocks.i"), mesh = directory.read("two_blocks.g");
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), "two_blocks.i");
    return directory.run(more);
  };
  CHECK_THAT(run({"--summary", "two_blocks.i"}).err, Contains("--summary would overwrite the deck"));
  CHECK_THAT(run({"two_blocks.g", "--summary", "two_blocks.g"}).err, Contains("would overwrite the mesh"));
  CHECK_THAT(run({"--summary", "two_blocks.g"}).err, Contains("would overwrite a file that is no JSON"));
  CHECK_THAT(run({"--surfaces-json", "s.json", "--summary", "s.json"}).err,
             Contains("the file of --summary would overwrite the file of --surfaces-json"));
  const auto results = run({"--summary", "two_blocks.e"});
  CHECK(results.exit_code == 3);
  CHECK_THAT(results.err, Contains("would overwrite the file of --summary"));
  CHECK(json::parse(directory.read("two_blocks.e"))["exit_code"] == 3);
  CHECK(directory.read("two_blocks.i") == deck);
  CHECK(directory.read("two_blocks.g") == mesh);
}

TEST_CASE("a run that a signal stops says so in its summary", "[app][summary]") {
  const ProgramDirectory directory;
  directory.copy_decks({"impact.i", "impact.g"});
  const auto stopped = directory.run_and_signal({"impact.i", "--summary", "s.json"}, "impact.csv", SIGTERM);
  CHECK(stopped.exit_code == 5);
  const json summary = json::parse(directory.read("s.json"));
  CHECK(summary["state"] == "stopped");
  CHECK(summary["run"]["ended_by"] == "SIGTERM");
  CHECK(summary["run"]["steps"].is_number());
}

TEST_CASE("a run that a signal stops while it is set up says so as well", "[app][summary]") {
  const ProgramDirectory directory;
  directory.copy_decks({"impact.i", "impact.g"});
  // The summary is written before the deck is read.
  const auto stopped = directory.run_and_signal({"impact.i", "--summary", "s.json"}, "s.json", SIGTERM);
  CHECK(stopped.exit_code == 5);
  CHECK_THAT(stopped.err, Contains("stopped by SIGTERM"));
  const json summary = json::parse(directory.read("s.json"));
  CHECK(summary["state"] == "stopped");
  CHECK(summary["exit_code"] == 5);
}

TEST_CASE("a run that is killed leaves a summary that says running", "[app][summary]") {
  const ProgramDirectory directory;
  directory.copy_decks({"impact.i", "impact.g"});
  directory.run_and_signal({"impact.i", "--summary", "s.json"}, "impact.csv", SIGKILL);
  const json summary = json::parse(directory.read("s.json"));
  CHECK(summary["state"] == "running");
  CHECK(summary["exit_code"].is_null());
}

TEST_CASE("includes are read from the folder that is asked for", "[app][options]") {
  const ProgramDirectory directory;
  directory.write("shared/parts.inc", "contact surface a contains b\n");
  directory.write("plate.i", "{include(parts.inc)}\n");
  CHECK(directory.run({"plate.i", "--parse"}).exit_code == 2);
  CHECK(directory.run({"plate.i", "--parse", "--includes-from", "shared"}).exit_code == 0);
}
