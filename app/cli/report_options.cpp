// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/report_options.hpp"

#include <CLI/CLI.hpp>

namespace contactsim {

namespace {

constexpr const char* report_footer =
    "RESULTS is an Exodus file of a run; of <name>.e the summary <name>.json and the heartbeat <name>.csv "
    "are\n"
    "taken if they are there, and the deck is the one that the run stored in it. Two results or more stand "
    "side\n"
    "by side, turned and played together. A run writes the same itself with --report FILE.\n"
    "three.js and Chart.js, which draw it, are taken from /usr/share/javascript (Debian: libjs-three,\n"
    "libjs-chart.js) or the folder CONTACTSIM_JAVASCRIPT, and put into the file.\n"
    "Exit codes: 0 done, 2 command line, 3 a file that cannot be read or written.\n"
    "Examples:   contactsim report impact.e -o impact.html\n"
    "            contactsim report slow/impact.e fast/impact.e -o speeds.html";

}  // namespace

CLI::App* add_report(CLI::App& app, ReportOptions& options) {
  auto* report = app.add_subcommand("report", "Write a page that shows the results of runs, in one file");
  report->footer(report_footer);
  report->add_option("RESULTS", options.results, "Exodus results")->required();
  report->add_option("-o,--output", options.output, "The page, in place of <first results>.html")
      ->type_name("FILE");
  const auto add = [&](const char* name, auto& value, const char* help) {
    return report->add_option(name, value, help)->type_name("FILE");
  };
  add("--deck", options.deck, "Deck to show, in place of the one in the results; of one run");
  add("--summary", options.summary, "Summary of --summary, in place of <results>.json; of one run");
  add("--heartbeat", options.heartbeats,
      "Heartbeat in CSV, in place of <results>.csv; of one run; may be repeated")
      ->allow_extra_args(false)
      ->take_all();
  report->callback([&options] {
    const bool has_own = options.deck || options.summary || !options.heartbeats.empty();
    if (has_own && options.results.size() > 1)
      throw CLI::ValidationError("--deck, --summary and --heartbeat are for the report of one run");
  });
  return report;
}

}  // namespace contactsim
