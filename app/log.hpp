// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>
#include <string_view>

#include "core/diagnostics.hpp"

namespace contactsim {

/// What the user reads: every text goes to standard output and to the log file, problems to standard error
/// and to the log file.
class Log {
 public:
  /// Throws FileError when the file cannot be written.
  explicit Log(const std::string& path);

  void write(std::string_view text);
  /// Problems, sorted and grouped; as pictures when standard error is a terminal.
  void write(const Diagnostics& diagnostics);
  /// One line, without its end, that says why the run stops.
  void write_error(std::string_view line);
  /// Throws FileError when anything that was written did not arrive, as on a full disk.
  void close();

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace contactsim
