// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/study_files.hpp"

#include "app/reports/csv.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

const std::vector<SweepRun> runs{{1, {{"mu", "0.1"}, {"a, b", "x"}}, "one"},
                                 {2, {{"mu", "0.2"}, {"a, b", "<y>"}}, "two"},
                                 {3, {{"mu", "0.3"}, {"a, b", "z"}}, "three"}};

std::vector<std::optional<RunRecord>> records() {
  RunRecord done, failed;
  done.state = "done";
  done.exit_code = 0;
  done.wall_time = 1.5;
  done.n_steps = 12;
  done.peak_force = 3.25;
  failed.state = "failed";
  failed.exit_code = 4;
  failed.first_error = "element 3, \"inverted\" & <gone>";
  return {done, failed, std::nullopt};
}

}  // namespace

TEST_CASE("the table of a study has a line per run, and nothing where nothing is known", "[app][sweep]") {
  const auto lines = split_csv(format_study_csv(runs, records()));
  REQUIRE(lines.size() == 4);
  for (const CsvLine& line : lines) CHECK(line.fields.size() == lines[0].fields.size());
  const auto column = [&](const std::string& name) {
    const auto& names = lines[0].fields;
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  CHECK(lines[1].fields[column("a, b")] == "x");
  CHECK(lines[1].fields[column("exit_code")] == "0");
  CHECK(lines[1].fields[column("steps")] == "12");
  CHECK(lines[1].fields[column("peak_force")] == "3.25");
  CHECK(lines[1].fields[column("deepest_share")] == "");
  CHECK(lines[2].fields[column("error")] == "element 3, \"inverted\" & <gone>");
  CHECK(lines[3].fields[column("state")] == "not run");
  CHECK(lines[3].fields[column("exit_code")] == "");
}

TEST_CASE("a study as JUnit XML counts failures and what was not run", "[app][sweep]") {
  const std::string xml = format_study_xml("plate", runs, records());
  CHECK_THAT(xml, Contains("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" time=\"1.500\""));
  CHECK_THAT(xml,
             Contains("name=\"mu=0.2 a, b=&lt;y&gt;\"") &&
                 Contains("<failure message=\"failed, exit code 4\">element 3, &quot;inverted&quot; &amp; "
                          "&lt;gone&gt;</failure>") &&
                 Contains("<skipped/>"));
}
