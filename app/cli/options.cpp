// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "core/base/version.hpp"

namespace contactsim {

namespace {

constexpr const char* footer =
    "Exit codes: 0 done, 1 a bug in contactsim, 2 deck or command line, 3 mesh or other file, 4 solution,\n"
    "            5 stopped by a signal after a whole step.\n"
    "Examples:   contactsim plate.i plate.g -o plate.e\n"
    "            contactsim plate.i plate.g --check --surfaces plate_surfaces.exo\n"
    "            contactsim diff stored.json surfaces.json\n"
    "            contactsim sweep plate.i plate.g -D mu=0:0.5:0.1 --jobs 4\n"
    "            contactsim report plate.e -o plate.html";

void add_run_options(CLI::App& app, Options& options) {
  app.add_option("deck", options.deck, "Input deck")->type_name("DECK");
  app.add_option("mesh", options.mesh, "Exodus mesh, in place of the deck's DATABASE NAME")
      ->type_name("MESH");
  app.add_option("-o,--output", options.results, "Results file, in place of the deck's")->type_name("FILE");
  app.add_option("-D,--define", options.definitions, "Aprepro variable, name=value; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--log", options.log, "Log file, in place of <deck base>.log")->type_name("FILE");
  app.add_option("--summary", options.summary, "Write what the run came to as JSON")->type_name("FILE");
  app.add_option("--report", options.report, "Write a page that shows the run, however it ends")
      ->type_name("FILE");
  app.add_option("--includes-from", options.includes_folder,
                 "Folder where relative paths of includes start, in place of the run directory")
      ->type_name("FOLDER");
  app.add_option("--threads", options.n_threads, "Number of threads; results do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--pieces", options.writes_pieces,
               "Write results in pieces <results>.P.r, one of each rank of mpirun");
  auto* strict = app.add_flag("--strict", options.is_strict,
                              "Exit code 2 when there is a warning; a run does not begin then");
  app.add_flag("-q,--quiet", options.is_quiet,
               "Print warnings and errors alone; the log file has everything");
  app.add_flag("--lenient", options.is_lenient, "Pass over unknown and unsupported commands with a warning")
      ->excludes(strict);
}

/// The files that hold the surfaces; a parse alone resolves none.
///   parse  the option --parse
void add_surface_options(CLI::App& app, CLI::Option* parse, Options& options) {
  const auto add = [&](const char* name, std::optional<std::string>& path, const char* help) {
    app.add_option(name, path, help)->type_name("FILE")->excludes(parse);
  };
  add("--surfaces-json", options.surfaces_json, "Write the ownership table as JSON");
  add("--surfaces-csv", options.surfaces_csv, "Write every owned facet as CSV");
  add("--surfaces", options.surfaces_exodus, "Write the surfaces as an Exodus mesh to look at");
}

/// How far to go; the last stage when none is named.
CLI::Option* add_stages(CLI::App& app, Stage& stage) {
  auto* parse = app.add_flag_callback(
      "--parse", [&stage] { stage = Stage::parse; }, "Read and bind the deck, without a mesh, and stop");
  auto* tables = app.add_flag_callback(
      "--tables", [&stage] { stage = Stage::tables; },
      "Resolve the contact surfaces, print their tables and stop; for decks that cannot be run too");
  auto* check = app.add_flag_callback(
      "--check", [&stage] { stage = Stage::check; },
      "The same, then find all that a run would refuse or warn of, and estimate what it takes");
  tables->excludes(parse);
  check->excludes(parse)->excludes(tables);
  return parse;
}

}  // namespace

bool asks_for_tables(const Options& options) {
  return options.surfaces_json || options.surfaces_csv || options.surfaces_exodus;
}

std::string log_path(const Options& options) {
  return options.log.value_or(std::filesystem::path(options.deck).stem().string() + ".log");
}

std::vector<RunFile> files_read(const Options& options) {
  std::vector<RunFile> files{{options.deck, "the deck"}};
  if (options.mesh) files.push_back({*options.mesh, "the mesh"});
  return files;
}

std::vector<RunFile> files_written(const Options& options) {
  std::vector<RunFile> files{{log_path(options), "the log"}};
  const auto add = [&](const std::optional<std::string>& path, const char* what) {
    if (path) files.push_back({*path, what});
  };
  add(options.results, "the results file");
  add(options.surfaces_json, "the file of --surfaces-json");
  add(options.surfaces_csv, "the file of --surfaces-csv");
  add(options.surfaces_exodus, "the file of --surfaces");
  add(options.summary, "the file of --summary");
  add(options.report, "the file of --report");
  return files;
}

CommandLine read_command_line(int argc, const char* const* argv) {
  CommandLine line;
  Options& options = line.options;
  for (int i = 0; i < argc; ++i) options.command_line += std::string(i == 0 ? "" : " ") + argv[i];
  CLI::App app(
      "Contact simulator: reads a Sierra/SM-style deck and an Exodus mesh, moves solids by explicit "
      "dynamics, "
      "tells which contact surface owns which face.",
      "contactsim");
  app.footer(footer);
  app.set_version_flag("--version", std::string("contactsim ") + version);
  add_run_options(app, options);
  add_surface_options(app, add_stages(app, options.stage), options);
  auto* explain =
      app.add_subcommand("explain", "Print the reference of deck blocks, commands and output variables");
  explain->add_option("words", options.explain_words, "What to explain, such as: contact surface")
      ->type_name("WORDS");
  const auto* diff = add_diff(app, options.diff);
  const auto* sweep = add_sweep(app, options.sweep);
  const auto* manual = add_manual(app, options.manual);
  const auto* mesh = add_mesh(app, options.convert);
  const auto* split = add_split(app, options.split);
  const auto* join = add_join(app, options.join);
  const auto* report = add_report(app, options.report_of_results);
  try {
    app.parse(argc, argv);
    options.explains = explain->parsed();
    options.diff.is_asked = diff->parsed();
    options.sweep.is_asked = sweep->parsed();
    options.manual.is_asked = manual->parsed();
    options.convert.is_asked = mesh->parsed();
    options.split.is_asked = split->parsed();
    options.join.is_asked = join->parsed();
    if (manual->parsed()) options.manual.command_line = describe(app);
    options.report_of_results.is_asked = report->parsed();
    if (app.get_subcommands().empty() && options.deck.empty()) throw CLI::RequiredError("DECK");
  } catch (const CLI::ParseError& error) {
    line.exit_code = app.exit(error) == 0 ? ExitCode::done : ExitCode::deck;
  }
  return line;
}

}  // namespace contactsim
