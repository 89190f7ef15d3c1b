// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/temporary_directory.hpp"

namespace contactsim::test {

/// What a run of the program printed, and how it ended.
struct ProgramOutput {
  int exit_code = 0;  ///< 128 and the signal's number when a signal ended it
  std::string out;    ///< standard output
  std::string err;    ///< standard error
};

/// A fresh directory in which the built contactsim runs, as a process of its own.
class ProgramDirectory {
 public:
  /// Makes a file, and the directories on the way to it.
  void write(const std::string& name, std::string_view text) const;
  /// Replaces the first place of a part of a file, which must be there.
  void edit(const std::string& name, const std::string& part, const std::string& other) const;
  /// Copies files of the source tree's decks/ into the directory, under their own names.
  void copy_decks(const std::vector<std::string>& names) const;

  std::string read(const std::string& name) const { return read_bytes(directory_.file(name)); }
  bool has(const std::string& name) const;
  /// All that there is, sorted, directories too.
  std::vector<std::string> list() const;
  std::string path(const std::string& name) const { return directory_.file(name); }

  /// Runs the program with standard output and error going to files, as they do in scripts.
  ProgramOutput run(const std::vector<std::string>& arguments) const;
  /// The same; once there is a file of a name the program gets a signal.
  ProgramOutput run_and_signal(const std::vector<std::string>& arguments, const std::string& file,
                               int signal) const;
  /// The same with standard error on a terminal.
  ProgramOutput run_on_terminal(const std::vector<std::string>& arguments) const;
  /// The same with standard output going to a device that is full.
  ProgramOutput run_into_full_device(const std::vector<std::string>& arguments) const;

 private:
  TemporaryDirectory directory_, captured_;
};

/// A directory with the deck two_blocks.i and its mesh.
struct TwoBlocks : ProgramDirectory {
  TwoBlocks() { copy_decks({"two_blocks.i", "two_blocks.g"}); }
};

}  // namespace contactsim::test
