// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/sweep_options.hpp"

#include "app/cli/command_words.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using contactsim::test::read_words;

TEST_CASE("a sweep of a deck has its usual folder, jobs and limit", "[app][options]") {
  const auto [options, exit_code] = read_words({"sweep", "a.i"});
  REQUIRE_FALSE(exit_code);
  const SweepOptions& sweep = options.sweep;
  CHECK(sweep.is_asked);
  CHECK(sweep.deck == "a.i");
  CHECK_FALSE(sweep.mesh);
  CHECK(sweep.folder == "study");
  CHECK(sweep.n_jobs == 1);
  CHECK(sweep.n_threads == 0);
  CHECK(sweep.seed == 1);
  CHECK(sweep.max_runs == 1e4);
  CHECK_FALSE(sweep.n_samples);
  CHECK_FALSE(sweep.array);
  CHECK_FALSE((sweep.collects || sweep.lists || sweep.is_lenient));
}

TEST_CASE("every option of a sweep reaches its field", "[app][options]") {
  const auto [options, exit_code] =
      read_words({"sweep",  "-D", "mu=0:1:0.5", "a.i",       "m.g",     "-D",        "n=1,2",   "-o",
                  "out",    "-j", "4",          "--threads", "2",       "--lenient", "--latin", "40",
                  "--seed", "7",  "--max-runs", "1e6",       "--array", "slurm"});
  REQUIRE_FALSE(exit_code);
  const SweepOptions& sweep = options.sweep;
  CHECK(sweep.deck == "a.i");
  CHECK(sweep.mesh == "m.g");
  CHECK(sweep.definitions == std::vector<std::string>{"mu=0:1:0.5", "n=1,2"});
  CHECK(sweep.folder == "out");
  CHECK(sweep.n_jobs == 4);
  CHECK(sweep.n_threads == 2);
  CHECK(options.n_threads == 0);  // of a run
  CHECK(sweep.is_lenient);
  CHECK(sweep.n_samples == 40u);
  CHECK(sweep.seed == 7);
  CHECK(sweep.max_runs == 1e6);
  CHECK(sweep.array == "slurm");
  CHECK(read_words({"sweep", "a.i", "--points", "p.csv"}).options.sweep.points == "p.csv");
  CHECK(read_words({"sweep", "a.i", "--collect"}).options.sweep.collects);
  CHECK(read_words({"sweep", "a.i", "--list"}).options.sweep.lists);
}

TEST_CASE("options of a sweep that mean nothing together, or no number, are a wrong command line",
          "[app][options]") {
  for (const std::vector<const char*>& more :
       std::vector<std::vector<const char*>>{{"--points", "p.csv", "--latin", "3"},
                                             {"--list", "--array", "1"},
                                             {"--list", "--collect"},
                                             {"--collect", "--array", "1"},
                                             {"--latin", "0"},
                                             {"--jobs", "0"},
                                             {"--jobs", "1025"},
                                             {"--threads", "0"},
                                             {"--max-runs", "-1"},
                                             {"--seed", "x"},
                                             {"m.g", "n.g"}}) {
    std::vector<const char*> words{"sweep", "a.i"};
    words.insert(words.end(), more.begin(), more.end());
    INFO(more.front());
    CHECK(read_words(words).exit_code == ExitCode::deck);
  }
  CHECK(read_words({"sweep"}).exit_code == ExitCode::deck);
}
