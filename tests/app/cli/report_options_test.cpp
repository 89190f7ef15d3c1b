// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/report_options.hpp"

#include "app/cli/command_words.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::read_words;

namespace {

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("a report takes results in any number", "[app][options]") {
  const auto [options, exit_code] = read_words({"report", "a.e", "b.e", "-o", "page.html"});
  REQUIRE_FALSE(exit_code);
  CHECK(options.report_of_results.is_asked);
  CHECK(options.report_of_results.results == Texts{"a.e", "b.e"});
  CHECK(options.report_of_results.output == "page.html");
  CHECK_FALSE(options.report);  // that a run writes of itself
  CHECK(read_words({"report"}).exit_code == ExitCode::deck);
}

TEST_CASE("a report of one run may name what lies beside the results", "[app][options]") {
  const auto [options, exit_code] = read_words({"report", "--heartbeat", "h.csv", "a.e", "--heartbeat",
                                                "k.csv", "--deck", "a.i", "--summary", "s.json"});
  REQUIRE_FALSE(exit_code);
  const ReportOptions& report = options.report_of_results;
  CHECK(report.results == Texts{"a.e"});
  CHECK(report.heartbeats == Texts{"h.csv", "k.csv"});
  CHECK(report.deck == "a.i");
  CHECK(report.summary == "s.json");
  CHECK_FALSE(report.output);
  for (const char* name : {"--deck", "--summary", "--heartbeat"}) {
    INFO(name);
    CHECK(read_words({"report", "a.e", "b.e", name, "x"}).exit_code == ExitCode::deck);
  }
}
