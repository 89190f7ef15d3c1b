// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace contactsim {

/// A program that is to run in a folder of its own.
struct ChildCommand {
  std::vector<std::string> words;  ///< the program's path, then its arguments
  std::string folder;              ///< that it runs in, which must be there
  std::string errors;              ///< file for its standard error; its standard output is lost
};

/// A child that has ended.
struct EndedChild {
  std::size_t number = 0;  ///< as it was started with
  int exit_code = 0;       ///< 128 and the signal's number when a signal ended it
};

/// Programs that run beside each other. Each leads a process group, so that a terminal's stop signal reaches
/// it through here alone; they are asked to end when this process is killed.
class ChildProcesses {
 public:
  /// Starts one. Throws FileError when there can be no more processes.
  ///   number  that it is known by
  void start(std::size_t number, const ChildCommand& command);
  std::size_t n_running() const { return running_.size(); }
  /// One that has ended, if any has; never waits.
  std::optional<EndedChild> take_ended();
  /// Sends all that run a signal.
  void send(int signal) const;

 private:
  std::map<pid_t, std::size_t> running_;
};

}  // namespace contactsim
