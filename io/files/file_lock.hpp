// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/files/file_descriptor.hpp"

namespace contactsim {

/// Keeps a file for this process as long as it lives: others that ask for the same are refused. It goes with
/// its owner, however that ends, and leaves nothing behind.
class FileLock {
 public:
  /// Files that are not there, that are no regular ones or that this process has already, and file systems
  /// without locks, are not kept. Throws FileError when another process has the file.
  ///   way_out  what the user can do then: "--log names another file"
  FileLock(const std::string& path, const std::string& way_out);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  FileDescriptor file_;
};

}  // namespace contactsim
