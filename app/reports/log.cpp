// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/log.hpp"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/reports/progress.hpp"
#include "app/reports/wrap_text.hpp"
#include "core/base/errors.hpp"
#include "core/base/file_paths.hpp"

namespace contactsim {

namespace {

void write_to(std::FILE* stream, std::string_view text) { std::fwrite(text.data(), 1, text.size(), stream); }

/// The path, where refuse_link_out_of_folder() lets it pass.
const std::string& own_file(const std::string& path) {
  refuse_link_out_of_folder(path);
  return path;
}

}  // namespace

Log::Log(const std::string& path, bool is_quiet)
    : path_(own_file(path)),
      file_(path, std::ios::binary | std::ios::app),
      lock_(std::in_place, path, "--log names another file"),
      is_quiet_(is_quiet) {
  if (!file_) throw FileError(path, "the log file cannot be written");
}

void Log::begin(bool keeps_earlier) {
  if (!has_file_) return;
  if (!keeps_earlier) {
    file_.close();
    file_.open(path_, std::ios::binary | std::ios::trunc);
    if (!file_) throw FileError(path_, "the log file cannot be written");
  } else if (std::error_code none; std::filesystem::file_size(path_, none) > 0 && !none) {
    held_.insert(0, "\n");
  }
  has_begun_ = true;
  file_ << held_ << std::flush;
  held_.clear();
}

void Log::leave_file() {
  has_file_ = false;
  held_.clear();
  file_.close();
}

void Log::write_to_file(std::string_view text) {
  if (!has_file_) return;
  const std::string wrapped = wrap_text(text);
  if (has_begun_) {
    file_ << wrapped << std::flush;
  } else {
    held_ += wrapped;
  }
}

void Log::write(std::string_view text) {
  if (!is_quiet_) write_to(stdout, wrap_text(text));
  write_to_file(text);
}

void Log::write(const Diagnostics& diagnostics) {
  if (is_silent_) return;
  const bool shows_pictures = is_terminal(STDERR_FILENO);
  std::fflush(stdout);
  for (const DiagnosticGroup& group : diagnostics.grouped()) {
    const std::string machine = format_machine(group);
    write_to(stderr, shows_pictures ? format_with_caret(group, true) : machine);
    write_to_file(machine);
  }
}

void Log::write_error(std::string_view line) {
  if (line.starts_with("error: ") || line.starts_with("contactsim: a bug")) errors_.emplace_back(line);
  if (is_silent_) return;
  const std::string text = std::string(line) + "\n";
  std::fflush(stdout);
  write_to(stderr, text);
  write_to_file(text);
}

void Log::close() {
  if (has_file_ && !has_begun_) begin(true);
  std::fflush(stdout);
  if (has_file_) file_.close();
  if (std::ferror(stdout) != 0) throw FileError("standard output", "what the run prints cannot be written");
  if (has_file_ && !file_) throw FileError(path_, "the log file cannot be written");
}

}  // namespace contactsim
