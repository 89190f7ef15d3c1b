// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/summary_file.hpp"

#include <omp.h>

#include <filesystem>
#include <fstream>

#include "app/cli/read_run_deck.hpp"
#include "core/base/errors.hpp"
#include "io/files/write_text.hpp"

namespace contactsim {

namespace {

const char* stage_name(Stage stage) {
  if (stage == Stage::run) return "run";
  if (stage == Stage::tables) return "tables";
  return stage == Stage::check ? "check" : "parse";
}

/// A regular file that holds something, and no JSON object: a mesh, say, that the deck names.
bool is_foreign(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::is_empty(path, ignored))
    return false;
  return std::ifstream(path, std::ios::binary).get() != '{';
}

}  // namespace

RunSummary begin_summary(const Options& options) {
  RunSummary summary;
  summary.stage = stage_name(options.stage);
  summary.deck = options.deck;
  summary.n_threads = omp_get_max_threads();
  try {
    summary.definitions = split_definitions(options.definitions);
  } catch (const DeckError&) {
    // The run says what is wrong with them.
  }
  return summary;
}

void write_summary_file(const Options& options, const RunSummary& summary) {
  if (options.summary) write_text(*options.summary, format_summary(summary));
}

void begin_summary_file(const Options& options, const RunSummary& summary) {
  if (options.summary && is_foreign(*options.summary))
    throw FileError(*options.summary, "the summary would overwrite a file that is no JSON");
  write_summary_file(options, summary);
}

}  // namespace contactsim
