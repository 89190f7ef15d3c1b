// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/decompose_options.hpp"
#include "app/cli/diff_options.hpp"
#include "app/cli/manual_options.hpp"
#include "app/cli/mesh_options.hpp"
#include "app/cli/report_options.hpp"
#include "app/cli/sweep_options.hpp"
#include "app/run/file_clashes.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// How far a run goes.
enum class Stage {
  parse,   ///< read and bind the deck, no mesh
  tables,  ///< resolve the contact surfaces
  check,   ///< and prepare the run, so that what it would refuse is found
  run      ///< everything
};

/// What the command line asks for.
struct Options {
  std::string command_line;  ///< as it was typed, words joined by blanks
  std::string deck;
  std::optional<std::string> mesh;     ///< in place of the deck's DATABASE NAME
  std::optional<std::string> results;  ///< in place of the deck's results file
  Stage stage = Stage::run;
  std::optional<std::string> surfaces_json;    ///< file for the ownership table
  std::optional<std::string> surfaces_csv;     ///< file for the list of facets
  std::optional<std::string> surfaces_exodus;  ///< file for the surfaces as a mesh
  std::optional<std::string> summary;          ///< file for what the run came to, as JSON
  std::optional<std::string> report;           ///< file for a page that shows the run
  std::optional<std::string> includes_folder;  ///< where relative paths of includes start, if not here
  bool is_lenient = false;
  bool is_strict = false;                ///< a warning counts as an error
  bool is_quiet = false;                 ///< only problems are printed
  int n_threads = 0;                     ///< 0: as many as OpenMP chooses
  std::size_t n_ranks = 1;               ///< that mpirun has started
  bool writes_pieces = false;            ///< of results, a piece of each rank
  std::optional<std::string> log;        ///< in place of <deck base>.log
  std::vector<std::string> definitions;  ///< "name=value" for Aprepro
  bool explains = false;
  std::vector<std::string> explain_words;  ///< of `contactsim explain`
  DiffOptions diff;
  SweepOptions sweep;
  ManualOptions manual;
  MeshOptions convert;
  SplitOptions split;
  JoinOptions join;
  ReportOptions report_of_results;  ///< of `contactsim report`
};

/// Whether a table of contact surfaces is to be written.
bool asks_for_tables(const Options& options);

/// The log file of a run: the one asked for, else <deck base>.log in the run directory.
std::string log_path(const Options& options);

/// The files that the command line has the run read.
std::vector<RunFile> files_read(const Options& options);

/// The files that the command line has the run write, the log first.
std::vector<RunFile> files_written(const Options& options);

/// What the command line means: options, or an exit code when all is said and done (--help, --version,
/// mistakes).
struct CommandLine {
  Options options;
  std::optional<ExitCode> exit_code;
};

/// Reads the command line; prints help, version and mistakes itself.
CommandLine read_command_line(int argc, const char* const* argv);

}  // namespace contactsim
