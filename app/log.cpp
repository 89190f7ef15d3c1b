// SPDX-License-Identifier: BSD-3-Clause
#include "app/log.hpp"

#include <unistd.h>

#include <cstdio>

#include "core/errors.hpp"

namespace contactsim {

Log::Log(const std::string& path) : file_(path, std::ios::binary) {
  if (!file_) throw FileError(path, "the log file cannot be written");
}

void Log::write(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  write_to_file(text);
}

void Log::write_to_file(std::string_view text) { file_ << text << std::flush; }

void Log::write(const Diagnostics& diagnostics) {
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  std::fflush(stdout);
  for (const DiagnosticGroup& group : diagnostics.grouped()) {
    const std::string machine = format_machine(group);
    const std::string shown = is_terminal ? format_with_caret(group, true) : machine;
    std::fwrite(shown.data(), 1, shown.size(), stderr);
    file_ << machine;
  }
  file_ << std::flush;
}

}  // namespace contactsim
