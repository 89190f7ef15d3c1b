// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <omp.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "app/log.hpp"
#include "app/options.hpp"
#include "app/simulation.hpp"
#include "core/errors.hpp"
#include "parser/explain.hpp"

namespace contactsim {

namespace {

void report(const std::string& text, Log& log) {
  std::fprintf(stderr, "%s\n", text.c_str());
  log.write_to_file(text + "\n");
}

std::string count(std::size_t n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// Warnings once more at the end, where they are seen.
void write_summary(const Diagnostics& warnings, Log& log) {
  if (warnings.empty()) return;
  log.write(fmt::format("\n{}\n", count(warnings.all().size(), "warning")));
  log.write(warnings);
}

/// Runs with every error told to the user and turned into an exit code.
ExitCode run(const Options& options, Log& log) {
  Diagnostics warnings;
  try {
    const ExitCode code = simulate(options, log, warnings);
    write_summary(warnings, log);
    return code;
  } catch (const DeckError& error) {
    log.write(error.diagnostics());
    report(fmt::format("contactsim: {}", count(error.diagnostics().error_count(), "error")), log);
    return ExitCode::deck;
  } catch (const FileError& error) {
    log.write(warnings);
    report(fmt::format("error: {}", error.what()), log);
    return ExitCode::file;
  }
}

int start(int argc, const char* const* argv) {
  const CommandLine line = read_command_line(argc, argv);
  if (line.exit_code) return *line.exit_code;
  const Options& options = line.options;
  if (options.explains) {
    std::fputs(explain(options.explain_words).c_str(), stdout);
    return 0;
  }
  if (options.n_threads > 0) omp_set_num_threads(options.n_threads);
  const std::string base = std::filesystem::path(options.deck).stem().string();
  Log log(options.log.value_or(base + ".log"));
  log.write(fmt::format("contactsim {}\n", CONTACTSIM_VERSION));
  return static_cast<int>(run(options, log));
}

}  // namespace

}  // namespace contactsim

int main(int argc, char** argv) {
  using contactsim::ExitCode;
  try {
    return contactsim::start(argc, argv);
  } catch (const contactsim::FileError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(ExitCode::file);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "error: out of memory\n");
    return static_cast<int>(ExitCode::file);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "contactsim: a bug in the program: %s\n", error.what());
    return static_cast<int>(ExitCode::our_bug);
  }
}
