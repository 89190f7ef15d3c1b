// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/program.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/cli/convert_mesh.hpp"
#include "app/cli/exit_guard.hpp"
#include "app/cli/options.hpp"
#include "app/cli/report_file.hpp"
#include "app/cli/run_deck.hpp"
#include "app/cli/run_decompose.hpp"
#include "app/cli/run_diff.hpp"
#include "app/cli/run_manual.hpp"
#include "app/cli/run_report.hpp"
#include "app/cli/run_sweep.hpp"
#include "app/cli/summary_file.hpp"
#include "app/manual/explain_variables.hpp"
#include "app/manual/foreign_keywords.hpp"
#include "app/reports/log.hpp"
#include "app/reports/run_head.hpp"
#include "app/run/file_clashes.hpp"
#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"
#include "core/base/version.hpp"
#include "core/dynamics/node_shares.hpp"
#include "core/parallel/load_ranks.hpp"
#include "core/parallel/on_root.hpp"
#include "parser/explain.hpp"

namespace contactsim {

namespace {

/// Warnings once more at the end, where they are seen.
void write_summary(const Diagnostics& warnings, Log& log) {
  if (warnings.empty()) return;
  log.write(fmt::format("\n{}\n", pluralize(warnings.all().size(), "warning")));
  log.write(warnings);
}

ExitCode run(const Options& options, Ranks& ranks, StopSignals& signals, Log& log, RunSummary& summary,
             ReportDraft& draft) {
  Diagnostics warnings;
  const auto work = [&] {
    try {
      const ExitCode code = run_deck(options, ranks, signals, log, warnings, summary, draft);
      write_summary(warnings, log);
      summary.found = warnings;
      const bool is_too_strict = options.is_strict && code == ExitCode::done && !warnings.empty();
      if (is_too_strict) log.write_error("contactsim: warnings count as errors with --strict");
      return is_too_strict ? ExitCode::deck : code;
    } catch (const StoppedBySignal& stop) {
      log.write_error(fmt::format("stopped by {} before the first step", stop.signal));
      summary.found = warnings;
      return ExitCode::stopped;
    } catch (const DeckError& error) {
      log.write(error.diagnostics());
      log.write_error("contactsim: " + pluralize(error.diagnostics().error_count(), "error"));
      summary.found = error.diagnostics();
      return ExitCode::deck;
    }
  };
  return guard_exit(work, [&](const std::string& line) {
    log.write(warnings);
    log.write_error(line);
    summary.found = warnings;
  });
}

/// The run with its log, from beginning to end.
ExitCode run_with_log(const Options& options, Ranks& ranks, StopSignals& signals, RunSummary& summary,
                      ReportDraft& draft) {
  std::optional<Log> of_rank;
  on_root(ranks, [&] { of_rank.emplace(log_path(options), options.is_quiet); });
  Log& log = of_rank ? *of_rank : of_rank.emplace();
  log.write(fmt::format("contactsim {}\n", version));
  log.write_to_file(
      format_run_head(options.command_line, options.definitions, ranks.count(), omp_get_max_threads()));
  const ExitCode code = run(options, ranks, signals, log, summary, draft);
  summary.error_lines = log.errors();
  on_root(ranks, [&] { log.close(); });
  return code;
}

/// A mistyped deck leaves no log behind.
void check_deck_is_a_file(const std::string& deck) {
  std::error_code ignored;
  const auto status = std::filesystem::status(deck, ignored);
  if (!std::filesystem::exists(status)) throw FileError(deck, "there is no such deck");
  if (std::filesystem::is_directory(status)) throw FileError(deck, "this is a directory, not a deck");
}

/// The deck language, and output variables of the same name; else what other programs call it.
Explanation explain_all(std::span<const std::string> words) {
  Explanation explanation = explain(words);
  const std::string variables = words.empty() ? "" : explain_variables(words);
  if (!explanation.is_found && variables.empty()) {
    const std::string foreign = explain_foreign_keywords(words);
    return foreign.empty() ? explanation : Explanation{foreign, true};
  }
  if (variables.empty()) return explanation;
  if (!explanation.is_found) return {variables, true};
  explanation.text += "\n" + variables;
  return explanation;
}

/// What the ranks but the first write: nothing.
Options without_files(Options options) {
  options.is_quiet = true;
  for (auto* path : {&options.surfaces_json, &options.surfaces_csv, &options.surfaces_exodus,
                     &options.summary, &options.report})
    path->reset();
  return options;
}

/// Ends all ranks, where some have stopped without the others: they would wait for ever.
void end_together(Ranks& ranks, ExitCode code, std::span<const std::string> errors) {
  constexpr double patience = 30.0;  // for a rank that has the same error a little later [s]
  const bool is_done = code == ExitCode::done;
  if (ranks.wait_for_all(is_done ? std::numeric_limits<double>::infinity() : patience)) return;
  for (const std::string& line : errors) std::fprintf(stderr, "rank %d: %s\n", ranks.rank(), line.c_str());
  std::fprintf(stderr, "rank %d has stopped, and the others have not: the run ends\n", ranks.rank());
  ranks.abort(static_cast<int>(code));
}

///   errors  gains the lines that say why the run has stopped
ExitCode run_on_rank(const Options& options, Ranks& ranks, std::vector<std::string>& errors) {
  check_deck_is_a_file(options.deck);
  const std::string clash = find_file_clash(files_read(options), files_written(options));
  if (!clash.empty()) {
    std::fprintf(stderr, "error: %s\n", clash.c_str());
    return ExitCode::deck;
  }
  if (options.n_threads > 0) omp_set_num_threads(options.n_threads);
  const auto libraries = find_report_libraries(options);
  StopSignals signals(ranks);
  RunSummary summary = begin_summary(options);
  begin_summary_file(options, summary);
  ReportDraft draft;
  const auto write_line = [&](const std::string& line) {
    if (ranks.is_root()) std::fprintf(stderr, "%s\n", line.c_str());
    summary.error_lines.push_back(line);
  };
  summary.exit_code =
      guard_exit([&] { return run_with_log(options, ranks, signals, summary, draft); }, write_line);
  if (libraries) {
    const auto work = [&] { return write_report_file(options, draft, summary, *libraries), ExitCode::done; };
    const ExitCode code = guard_exit(work, write_line);
    if (*summary.exit_code == ExitCode::done) summary.exit_code = code;
  }
  write_summary_file(options, summary);
  errors = summary.error_lines;
  return *summary.exit_code;
}

ExitCode start(const Options& options) {
  const std::unique_ptr<Ranks> several = load_ranks();
  std::vector<std::string> errors;
  if (several && several->count() > NodeShares::max_ranks)
    throw FileError("mpirun", fmt::format("starts {} ranks, and a run takes {}", several->count(),
                                          NodeShares::max_ranks));
  if (!several) return run_on_rank(options, one_rank(), errors);
  Options own = several->is_root() ? options : without_files(options);
  own.n_ranks = static_cast<std::size_t>(several->count());
  const ExitCode code = guard_exit([&] { return run_on_rank(own, *several, errors); },
                                   [&](const std::string& line) {
                                     if (several->is_root()) std::fprintf(stderr, "%s\n", line.c_str());
                                     errors.push_back(line);
                                   });
  end_together(*several, code, errors);
  return code;
}

/// What is no run of a deck.
ExitCode run_command(const Options& options) {
  if (options.diff.is_asked) return static_cast<ExitCode>(run_diff(options.diff));
  if (options.report_of_results.is_asked) return static_cast<ExitCode>(run_report(options.report_of_results));
  if (options.sweep.is_asked) return static_cast<ExitCode>(run_sweep(options.sweep));
  if (options.convert.is_asked) return convert_mesh(options.convert);
  if (options.split.is_asked) return run_split(options.split);
  if (options.join.is_asked) return run_join(options.join);
  if (options.manual.is_asked) return run_manual(options.manual);
  const Explanation explanation = explain_all(options.explain_words);
  std::fputs(explanation.text.c_str(), explanation.is_found ? stdout : stderr);
  return explanation.is_found ? ExitCode::done : ExitCode::deck;
}

bool is_command(const Options& options) {
  return options.diff.is_asked || options.report_of_results.is_asked || options.sweep.is_asked ||
         options.convert.is_asked || options.split.is_asked || options.join.is_asked ||
         options.manual.is_asked || options.explains;
}

/// Where mpirun has started several processes for it, the first one works.
ExitCode run_command_once(const Options& options) {
  const std::unique_ptr<Ranks> several = load_ranks();
  if (!several) return run_command(options);
  const auto work = [&] {
    // Its programs would take themselves for ranks of this one.
    if (options.sweep.is_asked)
      throw FileError(
          "mpirun", fmt::format("starts {} processes, and contactsim sweep starts its runs itself, from one",
                                several->count()));
    return run_command(options);
  };
  const auto write_line = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  return several->of_root(several->is_root() ? guard_exit(work, write_line) : ExitCode::done);
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  const auto work = [&] {
    const CommandLine line = read_command_line(argc, argv);
    if (line.exit_code) return *line.exit_code;
    return is_command(line.options) ? run_command_once(line.options) : start(line.options);
  };
  const ExitCode code =
      guard_exit(work, [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); });
  return static_cast<int>(code);
}

}  // namespace contactsim
