// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/sweep_options.hpp"

#include <CLI/CLI.hpp>

#include "app/cli/number_checks.hpp"

namespace contactsim {

namespace {

constexpr const char* sweep_footer =
    "Each run has a folder of its own below that of the study, named by its parameters. Runs that are done "
    "with\n"
    "the same parameters, deck and mesh are not done again: the same command goes on where it was stopped.\n"
    "Exit codes: 0 every run is done, 2 command line, 3 file, 5 stopped by a signal; else that of the first "
    "run\n"
    "            that failed.\n"
    "Examples:   contactsim sweep plate.i plate.g -D mu=0:0.5:0.1 -D order=1,2 --jobs 4 -o study\n"
    "            contactsim sweep plate.i -D speed=10:90 -D mu=0:0.5 --latin 40 --seed 7\n"
    "            contactsim sweep plate.i --points points.csv --array slurm";

void add_values(CLI::App& sweep, SweepOptions& options) {
  sweep.add_option("deck", options.deck, "Input deck")->type_name("DECK")->required();
  sweep.add_option("mesh", options.mesh, "Exodus mesh, in place of the deck's")->type_name("MESH");
  sweep
      .add_option("-D,--define", options.definitions,
                  "Aprepro variable: first:last:step, the last included; a,b,c; or a value. All are combined")
      ->type_name("NAME=VALUES")
      ->allow_extra_args(false)
      ->take_all();
  auto* points = sweep
                     .add_option("--points", options.points,
                                 "CSV of points: a line of names, then a line of values for each")
                     ->type_name("FILE");
  sweep.add_option("--latin", options.n_samples, "Latin hypercube of N points over ranges and lists")
      ->type_name("N")
      ->check(positive_number())
      ->excludes(points);
  sweep.add_option("--seed", options.seed, "Of the Latin hypercube, 1 unless given")->type_name("S");
  sweep.add_option("--max-runs", options.max_runs, "More runs are refused; 10000 unless given")
      ->type_name("N")
      ->check(positive_number());
}

}  // namespace

CLI::App* add_sweep(CLI::App& app, SweepOptions& options) {
  auto* sweep = app.add_subcommand("sweep", "Run a deck for many values of its Aprepro variables");
  sweep->footer(sweep_footer);
  add_values(*sweep, options);
  sweep->add_option("-o,--output", options.folder, "Folder of the study, 'study' unless given")
      ->type_name("FOLDER");
  sweep->add_option("-j,--jobs", options.n_jobs, "Runs beside each other, 1 unless given")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  sweep
      ->add_option("--threads", options.n_threads, "Threads of each run; without it all runs fit the machine")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  sweep->add_flag("--lenient", options.is_lenient, "As for a run");
  auto* array = sweep
                    ->add_option("--array", options.array,
                                 "Do one run alone, by its number from 1, or by SLURM_ARRAY_TASK_ID")
                    ->type_name("N|slurm");
  auto* collect =
      sweep->add_flag("--collect", options.collects, "Only write study.csv and study.xml from what is there");
  sweep->add_flag("--list", options.lists, "Only print the runs: number, folder, parameters")
      ->excludes(array)
      ->excludes(collect);
  array->excludes(collect);
  return sweep;
}

}  // namespace contactsim
