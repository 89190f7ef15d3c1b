// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <utility>

namespace contactsim {

/// A file that the system has open for this process; it is closed with its owner.
class FileDescriptor {
 public:
  /// None is open.
  FileDescriptor() = default;
  /// Takes over what open() has returned.
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  /// What calls of the system know it by; < 0 where none is open.
  int number() const { return number_; }
  void close() {
    if (is_open()) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

}  // namespace contactsim
