// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// Where an output file is made. It is written under another name first and renamed when it is complete, so
/// that no reader ever sees a half; only what is no regular file, a terminal or a pipe, is written to as it
/// is.
class OutputPlace {
 public:
  /// Throws FileError when the path is a link out of its folder.
  explicit OutputPlace(const std::string& path);

  /// The path to write to until the file is complete.
  const std::string& unfinished() const { return unfinished_; }
  bool is_regular() const { return unfinished_ != target_; }

  /// Gives the complete file its name. Returns what went wrong, "" when nothing did.
  std::string commit() const;
  /// Removes what was written, if it has not its name yet.
  void discard() const;

 private:
  std::string target_;  ///< what a link points to, else the path itself
  std::string unfinished_;
};

}  // namespace contactsim
