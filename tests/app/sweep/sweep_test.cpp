// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/sweep.hpp"

#include <csignal>
#include <filesystem>

#include "app/reports/run_summary.hpp"
#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// A study whose runs are lines of shell, which may use $n for the number of their point.
struct ShellStudy : TemporaryDirectory {
  explicit ShellStudy(std::string shell, std::size_t n_runs = 3) : line(std::move(shell)) {
    for (std::size_t i = 1; i <= n_runs; ++i) {
      const SweepPoint point{{"n", std::to_string(i)}};
      runs.push_back({i, point, folder_of(point)});
    }
    settings.folder = file("study");
    settings.name = "a study";
    settings.make_request = [this](const SweepPoint& point) {
      return RunRequest{{"/bin/sh", "-c", "n=" + point.front().second + "; " + line}, "deck", "mesh"};
    };
    settings.wants_stop = [this] { return wants_stop; };
    settings.write_line = [this](std::string_view text) { lines.emplace_back(text); };
  }

  /// The summary that a run which has ended well leaves, as a text for a line of shell.
  static std::string summary(const std::string& n, const std::string& digest = "deck") {
    RunSummary done;
    done.exit_code = ExitCode::done;
    done.definitions = {{"n", n}};
    done.deck_digest = digest;
    done.mesh = SummaryMesh{"m.g", "mesh", {}, {}};
    return format_summary(done);
  }
  void leave_summary(std::size_t i, const std::string& digest = "deck") const {
    std::filesystem::create_directories(file("study/" + runs[i].folder));
    write_bytes(file("study/" + runs[i].folder + "/summary.json"),
                summary(runs[i].point.front().second, digest));
  }
  std::string read_of(std::size_t i, const std::string& name) const {
    return read_bytes(file("study/" + runs[i].folder + "/" + name));
  }
  bool has_of(std::size_t i, const std::string& name) const {
    return std::filesystem::exists(file("study/" + runs[i].folder + "/" + name));
  }

  std::string line;
  std::vector<SweepRun> runs;
  SweepSettings settings;
  bool wants_stop = false;
  std::vector<std::string> lines;
};

}  // namespace

TEST_CASE("every run has its folder, is asked to leave a summary, and is reported", "[app][sweep]") {
  ShellStudy study("echo \"$n $0 $1\" > said");
  const SweepOutcome outcome = run_sweep_of(study.runs, study.settings);
  CHECK(outcome.n_done == 3);
  CHECK(outcome.n_failed + outcome.n_stopped + outcome.n_kept + outcome.n_left == 0);
  CHECK(outcome.first_failure == 0);
  CHECK_FALSE(outcome.is_stopped);
  CHECK(study.read_of(1, "said") == "2 --summary summary.json\n");
  CHECK_FALSE(study.has_of(1, "messages.txt"));  // nothing was said
  REQUIRE(study.lines.size() == 3);
  CHECK(study.lines[0].starts_with("     1 of 3  n=1: done in 0."));
  CHECK_THAT(study.lines[0], Contains(" left"));
  CHECK_THAT(study.lines[2], Contains("     3 of 3  n=3: done in ") && !Contains(" left"));
  CHECK_THAT(read_bytes(study.file("study/study.csv")), Contains("\n3,"));
  CHECK_THAT(read_bytes(study.file("study/study.xml")), Contains("a study"));
}

TEST_CASE("a run that fails keeps no other from being run, the first of them gives the code",
          "[app][sweep]") {
  ShellStudy study("[ $n = 1 ] || { echo \"no $n\" >&2; exit 1$n; }");
  const SweepOutcome outcome = run_sweep_of(study.runs, study.settings);
  CHECK(outcome.n_done == 1);
  CHECK(outcome.n_failed == 2);
  CHECK(outcome.first_failure == 12);
  CHECK(study.read_of(2, "messages.txt") == "no 3\n");
  CHECK_THAT(study.lines[1], Contains("n=2: failed, exit code 12 in "));
}

TEST_CASE("what is done with the same deck and mesh is kept, else run again", "[app][sweep]") {
  ShellStudy study("echo run > ran");
  study.leave_summary(0);
  study.leave_summary(1, "another deck");
  const SweepOutcome outcome = run_sweep_of(study.runs, study.settings);
  CHECK(outcome.n_kept == 1);
  CHECK(outcome.n_done == 2);
  CHECK_FALSE(study.has_of(0, "ran"));
  CHECK(study.has_of(1, "ran"));
  CHECK_FALSE(study.has_of(1, "summary.json"));  // that of before is not taken for one of now
  CHECK(study.lines.size() == 2);
}

TEST_CASE("a run of a deck that cannot be read is never kept", "[app][sweep]") {
  ShellStudy study("echo run > ran", 1);
  study.leave_summary(0, "");
  study.settings.make_request = [&](const SweepPoint&) {
    return RunRequest{{"/bin/sh", "-c", study.line}, "", "mesh"};
  };
  CHECK(run_sweep_of(study.runs, study.settings).n_done == 1);
}

TEST_CASE("as many runs as jobs are beside each other", "[app][sweep]") {
  // Each waits for the other.
  ShellStudy study("touch ../$n; while [ ! -e ../1 ] || [ ! -e ../2 ]; do sleep 0.01; done", 2);
  study.settings.n_jobs = 2;
  CHECK(run_sweep_of(study.runs, study.settings).n_done == 2);
}

TEST_CASE("a stop asks the runs that last to end, and begins no others", "[app][sweep]") {
  ShellStudy study("trap 'exit 5' TERM; touch begun; while :; do sleep 0.01; done");
  study.settings.wants_stop = [&] { return study.has_of(0, "begun"); };
  const SweepOutcome outcome = run_sweep_of(study.runs, study.settings);
  CHECK(outcome.is_stopped);
  CHECK(outcome.n_stopped == 1);
  CHECK(outcome.n_left == 2);
  CHECK(outcome.n_failed == 0);
  CHECK(outcome.first_failure == 5);
  CHECK_THAT(study.lines.at(0), Contains("n=1: stopped, exit code 5 in ") && !Contains(" left"));
}

TEST_CASE("a stop before the first run leaves all of them", "[app][sweep]") {
  ShellStudy study("touch ran");
  study.wants_stop = true;
  const SweepOutcome outcome = run_sweep_of(study.runs, study.settings);
  CHECK(outcome.n_left == 3);
  CHECK_FALSE(study.has_of(0, "ran"));
}

TEST_CASE("one run alone has its exit code, and writes no table", "[app][sweep]") {
  ShellStudy study("echo no >&2; exit 7");
  CHECK(run_one_of(study.runs[1], study.settings) == 7);
  CHECK(study.read_of(1, "messages.txt") == "no\n");
  CHECK_FALSE(std::filesystem::exists(study.file("study/study.csv")));
  study.leave_summary(1);
  CHECK(run_one_of(study.runs[1], study.settings) == 0);
}

TEST_CASE("a study is collected from what is there", "[app][sweep]") {
  ShellStudy study("");
  study.leave_summary(1);
  const auto records = collect_study(study.runs, study.settings);
  REQUIRE(records.size() == 3);
  CHECK_FALSE(records[0]);
  REQUIRE(records[1]);
  CHECK(records[1]->state == "done");
  CHECK_FALSE(records[2]);
  write_bytes(study.file("taken"), "");
  study.settings.folder = study.file("taken");
  CHECK_THROWS_AS(collect_study(study.runs, study.settings), FileError);
  CHECK_THROWS_AS(run_sweep_of(study.runs, study.settings), FileError);
}
