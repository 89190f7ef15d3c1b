// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_summary.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

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

TEST_CASE("files of the same bytes have the same digest", "[app][summary]") {
  const test::TemporaryDirectory directory;
  test::write_bytes(directory.file("a"), "some text");
  test::write_bytes(directory.file("b"), "some text");
  test::write_bytes(directory.file("c"), "some texT");
  CHECK(digest_of_file(directory.file("a")).size() == 16);
  CHECK(digest_of_file(directory.file("a")) == digest_of_file(directory.file("b")));
  CHECK(digest_of_file(directory.file("a")) != digest_of_file(directory.file("c")));
  CHECK(digest_of_file(directory.file("none")) == "");
}
