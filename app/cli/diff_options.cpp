// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/diff_options.hpp"

#include <CLI/CLI.hpp>

#include "app/cli/number_checks.hpp"

namespace contactsim {

namespace {

constexpr const char* diff_footer =
    "A and B are of one kind, which shows by their content:\n"
    "  tables of --surfaces-json or lists of --surfaces-csv: what moved from which surface to which\n"
    "  summaries of --summary: which value, both values, their difference\n"
    "  heartbeats in CSV: which column, from which time on\n"
    "  decks: both are resolved on MESH, else on their own, and their tables are compared\n"
    "Numbers are the same within atol + rtol times the larger of the two; energies of a summary, times the\n"
    "largest of them; columns of a heartbeat, times the largest of the column.\n"
    "Exit codes: 0 no differences, 1 differences, 2 a file that cannot be read, or the command line.\n"
    "Examples:   contactsim diff stored.json surfaces.json\n"
    "            contactsim diff a.i b.i plate.g --faces\n"
    "            contactsim diff plate.i plate.i plate.g --define-second order=2\n"
    "            contactsim diff last_week.csv plate.csv --rtol 1e-3";

void add_words(CLI::App& app, const char* name, std::vector<std::string>& words, const char* help) {
  app.add_option(name, words, help)->type_name("NAME=VALUE")->allow_extra_args(false)->take_all();
}

}  // namespace

CLI::App* add_diff(CLI::App& app, DiffOptions& options) {
  auto* diff = app.add_subcommand("diff", "Compare two tables of surfaces, summaries, heartbeats or decks");
  diff->footer(diff_footer);
  diff->add_option("A", options.first, "First file")->required();
  diff->add_option("B", options.second, "Second file, of the same kind")->required();
  diff->add_option("MESH", options.mesh, "Exodus mesh of two decks, in place of their own");
  diff->add_option("--rtol", options.tolerance.rtol, "Relative tolerance, 1e-6 unless given")
      ->type_name("R")
      ->check(non_negative_number());
  diff->add_option("--atol", options.tolerance.atol, "Absolute tolerance beside it, 0 unless given")
      ->type_name("A")
      ->check(non_negative_number());
  diff->add_flag("--faces", options.lists_faces,
                 "List each facet that has another owner, by element and side");
  diff->add_flag("--json", options.writes_json, "Print the differences as JSON");
  diff->add_flag("--lenient", options.is_lenient, "As for a run, of decks");
  add_words(*diff, "-D,--define", options.definitions, "Aprepro variable of both decks");
  add_words(*diff, "--define-first", options.first_definitions, "Aprepro variable of the first deck");
  add_words(*diff, "--define-second", options.second_definitions, "Aprepro variable of the second deck");
  return diff;
}

}  // namespace contactsim
