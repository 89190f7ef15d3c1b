// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

struct FileId {
  dev_t device;
  ino_t number;
  pid_t process;  // a child knows what its parent has, and has it not

  bool operator==(const FileId&) const = default;
};

/// What this process has: flock() would refuse a second descriptor of it too.
std::vector<FileId>& files_held() {
  static std::vector<FileId> files;
  return files;
}

FileId id_of(const struct stat& file) { return {file.st_dev, file.st_ino, getpid()}; }

}  // namespace

FileLock::FileLock(const std::string& path, const std::string& way_out)
    : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  struct stat found {};
  if (!file_.is_open()) return;
  const bool is_file = fstat(file_.number(), &found) == 0 && S_ISREG(found.st_mode);
  if (!is_file || std::ranges::count(files_held(), id_of(found)) > 0) {
    file_.close();
    return;
  }
  if (flock(file_.number(), LOCK_EX | LOCK_NB) == 0) {
    files_held().push_back(id_of(found));
    return;
  }
  const bool is_taken = errno == EWOULDBLOCK;
  file_.close();
  if (is_taken)
    throw FileError(path, "another run is writing it: its folder is already in use (" + way_out + ")");
}

FileLock::~FileLock() {
  struct stat found {};
  if (file_.is_open() && fstat(file_.number(), &found) == 0) std::erase(files_held(), id_of(found));
}

}  // namespace contactsim
