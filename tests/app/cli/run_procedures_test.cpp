// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_procedures.hpp"

#include <csignal>
#include <filesystem>

#include "support/catch.hpp"
#include "support/staged_deck.hpp"
#include "support/two_cube_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Two cubes and procedures that are ready to run.
struct ReadyDeck : StagedDeck {
  explicit ReadyDeck(const std::string& procedures)
      : StagedDeck(mesh_with_corner(), two_cube_deck(procedures)), regions(chosen()) {
    for (const ChosenRegion& one : regions) prepared.push_back(prepare_region(way(), one, meshes, false));
  }
  static Mesh mesh_with_corner() {
    return two_cube_mesh(0.5).add_node_set(1, "corner", std::vector<std::uint32_t>{0}).build();
  }
  ExitCode run() { return run_procedures(way(), prepared); }
  /// Steps of each procedure that has begun.
  std::vector<std::string> begun() const {
    std::vector<std::string> names;
    for (const SummaryRun& one : summary.earlier_runs) names.push_back(one.procedure);
    if (summary.run) names.push_back(summary.run->procedure);
    return names;
  }

  std::vector<ChosenRegion> regions;
  MeshesByModel meshes;
  std::vector<PreparedRegion> prepared;
};

std::string two_in_turn(const std::string& first, const std::string& second = "") {
  return text_of({.name = "one", .region = first}) +
         text_of({.name = "two",
                  .start = 0.1,
                  .end = 0.2,
                  .region = second,
                  .more = "begin procedural transfer\ninclude all blocks\nend\n"});
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("procedures run in turn, the last with the summary's run and the others before it",
          "[app][procedures]") {
  ReadyDeck deck(two_in_turn("begin initial velocity\nblock = high\ncomponent = z\nmagnitude = 1\nend\n"));
  CHECK(deck.run() == ExitCode::done);
  CHECK(deck.begun() == Names{"one", "two"});
  CHECK(deck.summary.earlier_runs[0].time == Approx(0.1).epsilon(1e-12));
  CHECK(deck.summary.run->time >= 0.2);
  CHECK(deck.summary.run->energies.kinetic == Approx(0.5));  // the velocity goes on
  CHECK_THAT(deck.logged(), Contains("one") && Contains("two"));
}

TEST_CASE("a check tells what each procedure would come to, and runs none", "[app][procedures]") {
  ReadyDeck deck(two_in_turn(""));
  deck.options.stage = Stage::check;
  CHECK(deck.run() == ExitCode::done);
  CHECK(deck.begun().empty());
  const std::string logged = deck.logged();
  std::size_t n = 0;
  const std::string head = "A run of this deck";
  for (std::size_t at = logged.find(head); at != std::string::npos; at = logged.find(head, at + 1)) ++n;
  CHECK(n == 2);
}

TEST_CASE("a strict run with warnings does not begin, one without does", "[app][procedures]") {
  const bool has_warning = GENERATE(false, true);
  ReadyDeck deck(text_of({}));
  deck.options.is_strict = true;
  if (has_warning) deck.warnings.add_warning("w", {}, "a warning");
  CHECK(deck.run() == ExitCode::done);
  CHECK(deck.begun() == (has_warning ? Names{} : Names{"p"}));
}

TEST_CASE("a procedure that ends early may end those behind it, too", "[app][procedures]") {
  const bool ends_one = GENERATE(false, true);
  ReadyDeck deck(two_in_turn(std::string("begin solution termination\nterminate global time >= 0.05\n") +
                             (ends_one ? "terminate type = procedure\n" : "") + "end\n"));
  CHECK(deck.run() == ExitCode::done);
  CHECK(deck.begun() == (ends_one ? Names{"one", "two"} : Names{"one"}));
  const std::string left = "The procedure two is not run.";
  if (ends_one) CHECK_THAT(deck.logged(), !Contains(left));
  if (!ends_one) CHECK_THAT(deck.logged(), Contains(left));
}

TEST_CASE("a procedure that cannot go on is the last, with its exit code", "[app][procedures]") {
  // A corner of the cube low goes a hundred cells in a step.
  std::string procedures =
      two_in_turn("begin initial velocity\nnode set = corner\ncomponent = x\nmagnitude = 1000\nend\n");
  const std::string begin = "start time = 0.000000\n";
  procedures.insert(procedures.find(begin) + begin.size(),
                    "begin parameters for presto region one\nuser time step = 0.05\nend\n");
  ReadyDeck deck(procedures);
  CHECK(deck.run() == ExitCode::solve);
  CHECK(deck.begun() == Names{"one"});
  CHECK_THAT(deck.logged(), Contains("The procedure two is not run."));
}

TEST_CASE("a signal that came before the first step ends the set-up", "[app][procedures]") {
  ReadyDeck deck(text_of({}));
  std::raise(SIGTERM);
  CHECK_THROWS_AS(deck.run(), StoppedBySignal);
  CHECK(deck.begun().empty());
}

TEST_CASE("results of the command line are those of the last procedure", "[app][procedures]") {
  const std::string results =
      "begin results output r\ndatabase name = NAME\nnodal variables = velocity\nend\n";
  const TemporaryDirectory directory;
  const auto at = [&](const std::string& name) {
    std::string lines = results;
    return lines.replace(lines.find("NAME"), 4, directory.file(name));
  };
  ReadyDeck deck(two_in_turn(at("one.e"), at("two.e")));
  deck.options.results = directory.file("asked.e");
  CHECK(deck.run() == ExitCode::done);
  CHECK(std::filesystem::exists(directory.file("one.e")));
  CHECK_FALSE(std::filesystem::exists(directory.file("two.e")));
  CHECK(std::filesystem::exists(directory.file("asked.e")));
  CHECK(deck.draft.output_paths == Names{directory.file("one.e"), directory.file("asked.e")});
}
