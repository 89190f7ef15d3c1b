// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_summaries.hpp"

#include "app/reports/run_summary.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Lines = std::vector<std::string>;

/// A run of 10 steps with a pair that touched.
RunSummary summary() {
  RunSummary one;
  one.exit_code = ExitCode::done;
  one.definitions = {{"mu", "0.1"}};
  SummaryRun& run = one.run.emplace();
  run.n_steps = 10;
  run.energies.kinetic = 1000.0;
  run.energies.error = 1e-9;
  run.seconds = 1.0;
  SummaryPair pair;
  pair.first = "a";
  pair.second = "c.d";
  pair.interaction = "general contact";
  pair.history.emplace().peak_force = 5.0;
  one.pairs = {pair};
  one.n_pairs = 1;
  return one;
}

Lines texts(const RunSummary& first, const RunSummary& second, Tolerance tolerance = {}) {
  Lines lines;
  for (const Difference& one :
       compare_summaries({"a", format_summary(first)}, {"b", format_summary(second)}, tolerance))
    lines.push_back(one.text);
  return lines;
}

}  // namespace

TEST_CASE("wall times, threads and paths of summaries do not count", "[app][compare]") {
  RunSummary other = summary();
  other.run->seconds = 7.0;
  other.n_threads = 5;
  other.deck = "elsewhere/plate.i";
  CHECK(texts(summary(), other).empty());
}

TEST_CASE("values that differ are reported with both and the difference", "[app][compare]") {
  RunSummary other = summary();
  other.definitions = {{"mu", "0.2"}};
  other.run->n_steps = 12;
  other.pairs[0].history->peak_force = 6.0;
  CHECK(texts(summary(), other) == Lines{"definitions.mu: '0.1' -> '0.2'",
                                         "pair a - c.d (general contact).peak_force: 5 -> 6, by 1",
                                         "run.steps: 10 -> 12, by 2"});
  CHECK(texts(summary(), other, {0.5, 0.0}) == Lines{"definitions.mu: '0.1' -> '0.2'"});
}

TEST_CASE("energies of summaries are compared by the largest", "[app][compare]") {
  RunSummary other = summary();
  other.run->energies.error = -4e-9;
  CHECK(texts(summary(), other).empty());
  other.run->energies.error = 0.5;
  CHECK(texts(summary(), other) == Lines{"run.energies.error: 1e-09 -> 0.5, by 0.5"});
}

TEST_CASE("a pair or a run that one summary lacks is one line", "[app][compare]") {
  RunSummary other = summary();
  other.pairs.clear();
  other.n_pairs = 0;
  CHECK(texts(summary(), other) ==
        Lines{"pair a - c.d (general contact): 'present' -> 'absent'", "pairs_in_all: 1 -> 0, by -1"});
  other = summary();
  other.run.reset();
  CHECK(texts(other, summary()) == Lines{"run: 'absent' -> 'present'"});
}

TEST_CASE("warnings of summaries are compared by their numbers, errors by their text", "[app][compare]") {
  RunSummary first = summary(), second = summary();
  first.found.add_warning("odd", {}, "x");
  second.found.add_warning("odd", {}, "x");
  second.found.add_warning("odd", {}, "y");
  second.error_lines = {"error: z"};
  CHECK(texts(first, second) == Lines{"error 1: 'absent' -> 'z'", "warning odd: 1 -> 2, by 1"});
}

TEST_CASE("what only looks like a summary is refused", "[app][compare]") {
  CHECK_THROWS_AS(compare_summaries({"a", "{\"schema\": \"contactsim-summary/1\"}"},
                                    {"b", format_summary(summary())}, {}),
                  FileError);
}
