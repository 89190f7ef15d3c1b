// SPDX-License-Identifier: BSD-3-Clause
#include "app/log.hpp"

#include <unistd.h>

#include <cstdio>

#include "core/errors.hpp"

namespace contactsim {

namespace {

void write_to(std::FILE* stream, std::string_view text) { std::fwrite(text.data(), 1, text.size(), stream); }

}  // namespace

Log::Log(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  if (!file_) throw FileError(path, "the log file cannot be written");
}

void Log::write(std::string_view text) {
  write_to(stdout, text);
  file_ << text << std::flush;
}

void Log::write(const Diagnostics& diagnostics) {
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  std::fflush(stdout);
  for (const DiagnosticGroup& group : diagnostics.grouped()) {
    const std::string machine = format_machine(group);
    write_to(stderr, is_terminal ? format_with_caret(group, true) : machine);
    file_ << machine;
  }
  file_ << std::flush;
}

void Log::write_error(std::string_view line) {
  const std::string text = std::string(line) + "\n";
  std::fflush(stdout);
  write_to(stderr, text);
  file_ << text << std::flush;
}

void Log::close() {
  std::fflush(stdout);
  file_.close();
  if (std::ferror(stdout) != 0) throw FileError("standard output", "what the run prints cannot be written");
  if (!file_) throw FileError(path_, "the log file cannot be written");
}

}  // namespace contactsim
