// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "io/files/file_lock.hpp"

namespace contactsim {

/// What the user reads: every text goes to standard output and to the log file, problems to standard error
/// and to the log file. Lines are wrapped to line_width, but for problems on standard error, which editors
/// read.
class Log {
 public:
  /// Touches nothing that the file holds. Throws FileError when it cannot be written, or another run writes
  /// it.
  ///   is_quiet  problems alone are printed
  explicit Log(const std::string& path, bool is_quiet = false);
  /// Prints and writes nothing: of ranks whose first one has a log.
  Log() : is_quiet_(true), is_silent_(true), has_file_(false) {}

  /// Until then what goes to the file is held. A file that is there is written over, or kept for a
  /// run that resumes: then what is new follows it. Throws FileError.
  void begin(bool keeps_earlier);
  /// Leaves the file as it is: what follows is printed alone. Precondition: begin() has not been called.
  void leave_file();
  void write(std::string_view text);
  /// Goes to the log file alone: what differs from run to run, such as the time of day.
  void write_to_file(std::string_view text);
  bool is_quiet() const { return is_quiet_; }
  /// Problems, sorted and grouped; as pictures when standard error is a terminal.
  void write(const Diagnostics& diagnostics);
  /// One line, without its end, that says why the run stops.
  void write_error(std::string_view line);
  /// The lines of write_error that begin with "error:" or tell of a bug.
  const std::vector<std::string>& errors() const { return errors_; }
  /// Writes what is still held after what there is. Throws FileError when anything that was written did not
  /// arrive, as on a full disk.
  void close();

 private:
  std::string path_;
  std::ofstream file_;
  std::optional<FileLock> lock_;
  std::string held_;
  std::vector<std::string> errors_;
  bool is_quiet_, is_silent_ = false;
  bool has_begun_ = false, has_file_ = true;
};

}  // namespace contactsim
