// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_sweep.hpp"

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/reports/csv.hpp"
#include "support/catch.hpp"
#include "support/file_modes.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::TwoBlocks;

namespace {

/// A directory with a deck that takes a fraction of a second, below a folder of its own, with an include and
/// the mesh beside the place where commands are given.
struct Study : TwoBlocks {
  Study() {
    write("decks/blocks.i", "# {ifndef(end_time)}\n# {end_time = 1e-4}\n# {endif}\n" + read("two_blocks.i"));
    edit("decks/blocks.i", "friction coefficient = 0.3", "{include(friction.inc)}");
    edit("decks/blocks.i", "termination time = 1e-3", "termination time = {end_time}");
    write("friction.inc", "friction coefficient = {mu}\n");
  }
  /// The field of a run in study.csv.
  std::string field(std::size_t run, const std::string& name) const {
    const auto lines = split_csv(read("study/study.csv"));
    for (std::size_t i = 0; i < lines[0].fields.size(); ++i) {
      if (lines[0].fields[i] == name) return lines.at(run).fields.at(i);
    }
    return "no column " + name;
  }
  contactsim::test::ProgramOutput sweep(std::vector<std::string> more) const {
    std::vector<std::string> line{"sweep", "decks/blocks.i", "two_blocks.g"};
    line.insert(line.end(), more.begin(), more.end());
    return run(line);
  }
};

}  // namespace

TEST_CASE("a sweep runs every point in a folder of its own and makes a table", "[app][sweep]") {
  const Study study;
  const auto [code, out, err] = study.sweep({"-D", "mu=0:0.2:0.1", "-D", "order=1,2", "--jobs", "2"});
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, Contains("6 runs in study\n") && Contains(" of 6  mu=0.1 order=2: done in ") &&
                      Contains("6 done, 0 failed; study/study.csv\n"));
  CHECK(study.field(6, "mu") == "0.2");
  CHECK(study.field(6, "order") == "2");
  CHECK(study.field(6, "exit_code") == "0");
  CHECK(study.field(6, "warnings") == "3");
  CHECK(std::stoi(study.field(6, "steps")) >= 1);
  for (const char* file : {"blocks.log", "blocks.e", "summary.json"})
    CHECK(study.has(std::string("study/mu=0.2_order=2/") + file));
  CHECK_FALSE(study.has("study/mu=0.2_order=2/messages.txt.part"));
  CHECK_THAT(study.read("study/mu=0.2_order=2/blocks.log"),
             Contains("friction_coefficient") || Contains("0.2"));
  CHECK_THAT(study.read("study/study.xml"), Contains("tests=\"6\" failures=\"0\""));
}

TEST_CASE("a sweep takes up what is missing, and runs again what has changed", "[app][sweep]") {
  const Study study;
  CHECK(study.sweep({"-D", "mu=0,0.1"}).exit_code == 0);
  const auto again = study.sweep({"-D", "mu=0,0.1,0.2"});
  CHECK_THAT(again.out, Contains("3 done (2 of them before), 0 failed"));
  study.write("study/mu=0/summary.json", study.read("study/mu=0/summary.json").substr(0, 300));
  CHECK_THAT(study.sweep({"-D", "mu=0,0.1"}).out, Contains("2 done (1 of them before)"));
  study.write("friction.inc", "friction coefficient = {mu}  # as measured\n");
  const auto changed = study.sweep({"-D", "mu=0,0.1"});
  CHECK_THAT(changed.out, Contains("2 done, 0 failed") && !Contains("before"));
}

TEST_CASE("a sweep goes on after runs that fail, and its code is that of the first", "[app][sweep]") {
  const Study study;
  const auto [code, out, err] = study.sweep({"-D", "mu=-1,0.1"});
  CHECK(code == 2);
  CHECK_THAT(out, Contains("mu=-1: failed, exit code 2") && Contains("mu=0.1: done") &&
                      Contains("1 done, 1 failed"));
  CHECK(study.field(1, "state") == "failed");
  CHECK_THAT(study.field(1, "error"), Contains("friction coefficient"));
  CHECK_THAT(study.read("study/mu=-1/messages.txt"), Contains("friction.inc"));
  CHECK_THAT(study.read("study/study.xml"), Contains("failures=\"1\""));
}

TEST_CASE("a variable that no line of the deck uses fails every run of a sweep", "[app][sweep]") {
  const Study study;
  const auto [code, out, err] = study.sweep({"-D", "mu=0,0.1", "-D", "bogus=1"});
  CHECK(code == 2);
  CHECK_THAT(out, Contains("0 done, 2 failed"));
  CHECK_THAT(study.field(1, "error"), Contains("the deck does not use 'bogus' of -D"));
}

TEST_CASE("a stop signal ends the runs with their step, and the sweep can go on", "[app][sweep]") {
  const ProgramDirectory directory;
  directory.copy_decks({"impact.i", "impact.g"});
  const std::vector<std::string> sweep{"sweep", "impact.i", "-D", "speed=70,80,90", "--jobs", "2"};
  const auto [code, out, err] = directory.run_and_signal(sweep, "study/speed=70/impact.csv", SIGINT);
  CHECK(code == 5);
  CHECK_THAT(out, Contains("speed=70: stopped, exit code 5"));
  const auto summary = nlohmann::json::parse(directory.read("study/speed=70/summary.json"));
  CHECK(summary["state"] == "stopped");
  CHECK(summary["run"]["ended_by"] == "SIGTERM");
  CHECK_THAT(directory.read("study/study.csv"), Contains(",stopped,5,"));
}

TEST_CASE("one run of an array is done alone, and the table is collected afterwards", "[app][sweep]") {
  const Study study;
  CHECK(study.sweep({"-D", "mu=0,0.1,0.2", "--array", "2"}).exit_code == 0);
  CHECK(study.has("study/mu=0.1/summary.json"));
  CHECK_FALSE(study.has("study/mu=0"));
  CHECK_FALSE(study.has("study/study.csv"));
  setenv("SLURM_ARRAY_TASK_ID", "3", 1);
  CHECK(study.sweep({"-D", "mu=0,0.1,0.2", "--array", "slurm"}).exit_code == 0);
  unsetenv("SLURM_ARRAY_TASK_ID");
  CHECK(study.sweep({"-D", "mu=0,0.1,0.2", "--collect"}).exit_code == 0);
  CHECK(study.field(1, "state") == "not run");
  CHECK(study.field(2, "state") == "done");
  CHECK(study.field(3, "state") == "done");
  CHECK_THAT(study.read("study/study.xml"), Contains("skipped=\"1\""));
  CHECK(study.sweep({"-D", "mu=0,-1", "--array", "2"}).exit_code == 2);
}

TEST_CASE("the runs of a sweep are listed without any being done", "[app][sweep]") {
  const Study study;
  const auto [code, out, err] = study.sweep({"-D", "mu=0,0.1", "-D", "way=a b", "--list"});
  CHECK(code == 0);
  CHECK(out.starts_with("1\tmu=0_way=a_b_"));
  CHECK_THAT(out, Contains("\tmu=0.1 way=a b\n"));
  CHECK_FALSE(study.has("study"));
}

TEST_CASE("a sweep that is asked for wrongly ends with a reason and makes no files", "[app][sweep]") {
  const Study study;
  struct Mistake {
    std::vector<std::string> arguments;
    int code;
    std::string said;
  };
  const auto [arguments, code, said] = GENERATE(values<Mistake>({
      {{"-D", "mu=0:1:0"}, 2, "the step is zero"},
      {{"-D", "mu=0:1:1e-6"}, 2, "these are 1000001 runs"},
      {{"-D", "mu"}, 2, "expected name=value"},
      {{"-D", "mu=1,2", "--array", "3"}, 2, "there is no run 3, they are 1 to 2"},
      {{"-D", "mu=1,2", "--array", "0"}, 2, "there is no run 0"},
      {{"-D", "mu=1,2", "--array", "x"}, 2, "'x' is no number"},
      {{"-D", "mu=1,2", "--array", "slurm"}, 2, "SLURM_ARRAY_TASK_ID is not set"},
      {{"-D", "mu=1,2", "--jobs", "0"}, 2, "--jobs"},
      {{"--points", "none.csv"}, 3, "none.csv: the points cannot be read"},
      {{"--points", "p.csv", "--latin", "3"}, 2, "excludes"},
      {{"-D", "mu=1", "-o", "friction.inc"}, 3, "friction.inc: the folder cannot be made"},
  }));
  const auto files = study.list();
  const auto result = study.sweep(arguments);
  CHECK(result.exit_code == code);
  CHECK_THAT(result.err, Contains(said));
  CHECK(study.list() == files);
  const auto no_deck = study.run({"sweep", "none.i", "-D", "mu=1"});
  CHECK(no_deck.exit_code == 3);
  CHECK(no_deck.err == "error: none.i: there is no such deck\n");
}

TEST_CASE("a folder that cannot be written to ends a sweep before any run", "[app][sweep]") {
  const Study study;
  study.write("study/x", "");
  std::filesystem::permissions(study.path("study"),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (!test::make_programs_obey_modes()) return;
  const auto result = study.sweep({"-D", "mu=0.1"});
  std::filesystem::permissions(study.path("study"), std::filesystem::perms::owner_all);
  CHECK(result.exit_code == 3);
  CHECK_THAT(result.err, Contains("study/study.csv: the file cannot be written"));
  CHECK(study.list().size() > 0);
}
