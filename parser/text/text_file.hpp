// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace contactsim {

/// What came of reading a file of deck text.
struct TextFile {
  enum class Failure { none, missing, unreadable, not_text };

  std::string text;
  std::string problem = {};  ///< why it could not be read, "there is no such file"; "" when it was
  Failure failure = Failure::none;
};

/// Reads the file at a path, which is relative to the run directory.
using FileReader = std::function<TextFile(const std::string& path)>;

/// Reads a file from disk. Refuses directories, devices, binary files, UTF-16 and files over 64 MiB.
TextFile read_text_file(const std::string& path);

/// Refuses to read any file.
TextFile read_no_file(const std::string& path);

}  // namespace contactsim
