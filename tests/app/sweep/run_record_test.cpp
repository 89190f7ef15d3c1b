// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/run_record.hpp"

#include "app/reports/run_summary.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;

namespace {

RunSummary whole_summary() {
  RunSummary summary;
  summary.exit_code = ExitCode::done;
  summary.definitions = {{"mu", "0.1"}};
  summary.deck_digest = "0123456789abcdef";
  summary.run.emplace().n_steps = 5;
  summary.run->seconds = 2.0;
  SummaryPair small, large;
  small.history.emplace().peak_force = 1.0;
  large.history.emplace().peak_force = 4.0;
  summary.pairs = {large, small};
  summary.found.add_warning("a", {}, "x");
  summary.found.add_warning("a", {}, "y");
  return summary;
}

}  // namespace

TEST_CASE("a record holds what a summary says, of pairs the largest", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  test::write_bytes(directory.file(summary_name), format_summary(whole_summary()));
  const auto record = read_record(directory.file(""), {{"mu", "0.1"}});
  REQUIRE(record);
  CHECK(record->state == "done");
  CHECK(record->exit_code == 0);
  CHECK(record->deck_digest == "0123456789abcdef");
  CHECK(record->mesh_digest == "");
  CHECK(record->n_steps == 5);
  CHECK(record->wall_time == 2.0);
  CHECK(record->peak_force == 4.0);
  CHECK(record->n_warnings == 2);
}

TEST_CASE("a run that has not ended says so", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  RunSummary summary = whole_summary();
  summary.exit_code.reset();
  test::write_bytes(directory.file(summary_name), format_summary(summary));
  const auto record = read_record(directory.file(""), {{"mu", "0.1"}});
  REQUIRE(record);
  CHECK(record->state == "not ended");
  CHECK_FALSE(record->exit_code);
}

TEST_CASE("of another point, or from half a summary, there is no record", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  CHECK_FALSE(read_record(directory.file(""), {}));
  const std::string text = format_summary(whole_summary());
  test::write_bytes(directory.file(summary_name), text);
  CHECK_FALSE(read_record(directory.file(""), {{"mu", "0.2"}}));
  CHECK_FALSE(read_record(directory.file(""), {}));
  for (const std::string& broken : {text.substr(0, text.size() / 2), std::string(), std::string("{}")}) {
    test::write_bytes(directory.file(summary_name), broken);
    CHECK_FALSE(read_record(directory.file(""), {{"mu", "0.1"}}));
  }
}
