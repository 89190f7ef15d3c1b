// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/program.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <cstdio>
#include <filesystem>

#include "app/cli/convert_mesh.hpp"
#include "app/cli/exit_guard.hpp"
#include "app/cli/options.hpp"
#include "app/cli/report_file.hpp"
#include "app/cli/run_deck.hpp"
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
#include "parser/explain.hpp"

namespace contactsim {

namespace {

/// Warnings once more at the end, where they are seen.
void write_summary(const Diagnostics& warnings, Log& log) {
  if (warnings.empty()) return;
  log.write(fmt::format("\n{}\n", pluralize(warnings.all().size(), "warning")));
  log.write(warnings);
}

ExitCode run(const Options& options, StopSignals& signals, Log& log, RunSummary& summary,
             ReportDraft& draft) {
  Diagnostics warnings;
  const auto work = [&] {
    try {
      const ExitCode code = run_deck(options, signals, log, warnings, summary, draft);
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
ExitCode run_with_log(const Options& options, StopSignals& signals, RunSummary& summary, ReportDraft& draft) {
  Log log(log_path(options), options.is_quiet);
  log.write(fmt::format("contactsim {}\n", version));
  log.write_to_file(format_run_head(options.command_line, options.definitions, omp_get_max_threads()));
  const ExitCode code = run(options, signals, log, summary, draft);
  summary.error_lines = log.errors();
  log.close();
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

ExitCode start(const Options& options) {
  check_deck_is_a_file(options.deck);
  const std::string clash = find_file_clash(files_read(options), files_written(options));
  if (!clash.empty()) {
    std::fprintf(stderr, "error: %s\n", clash.c_str());
    return ExitCode::deck;
  }
  if (options.n_threads > 0) omp_set_num_threads(options.n_threads);
  const auto libraries = find_report_libraries(options);
  StopSignals signals;
  RunSummary summary = begin_summary(options);
  begin_summary_file(options, summary);
  ReportDraft draft;
  const auto write_line = [&](const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
    summary.error_lines.push_back(line);
  };
  summary.exit_code = guard_exit([&] { return run_with_log(options, signals, summary, draft); }, write_line);
  if (libraries) {
    const auto work = [&] { return write_report_file(options, draft, summary, *libraries), ExitCode::done; };
    const ExitCode code = guard_exit(work, write_line);
    if (*summary.exit_code == ExitCode::done) summary.exit_code = code;
  }
  write_summary_file(options, summary);
  return *summary.exit_code;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  const auto work = [&] {
    const CommandLine line = read_command_line(argc, argv);
    if (line.exit_code) return *line.exit_code;
    if (line.options.diff.is_asked) return static_cast<ExitCode>(run_diff(line.options.diff));
    if (line.options.report_of_results.is_asked)
      return static_cast<ExitCode>(run_report(line.options.report_of_results));
    if (line.options.sweep.is_asked) return static_cast<ExitCode>(run_sweep(line.options.sweep));
    if (line.options.convert.is_asked) return convert_mesh(line.options.convert);
    if (line.options.manual.is_asked) return run_manual(line.options.manual);
    if (!line.options.explains) return start(line.options);
    const Explanation explanation = explain_all(line.options.explain_words);
    std::fputs(explanation.text.c_str(), explanation.is_found ? stdout : stderr);
    return explanation.is_found ? ExitCode::done : ExitCode::deck;
  };
  const ExitCode code =
      guard_exit(work, [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); });
  return static_cast<int>(code);
}

}  // namespace contactsim
