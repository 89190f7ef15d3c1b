// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <csignal>
#include <string>

namespace contactsim {

/// Stands around calls of netCDF. Damaged HDF5 files make its libraries write where they must not, after
/// which nothing can go on: a signal that would end the process without a word then says which file it was,
/// on standard error, and the exit code is that of a file that cannot be read. Handlers and signal stack of
/// before are back at the end. One thread at a time.
class LibraryGuard {
 public:
  /// The path must outlive this.
  explicit LibraryGuard(const std::string& path);
  ~LibraryGuard();
  LibraryGuard(const LibraryGuard&) = delete;
  LibraryGuard& operator=(const LibraryGuard&) = delete;

 private:
  std::array<struct sigaction, 4> before_{};
  stack_t stack_before_{};
};

}  // namespace contactsim
