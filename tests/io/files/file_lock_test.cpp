// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/file_lock.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Whether another process is refused a file.
bool is_refused(const std::string& path) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      const FileLock lock(path, "");
      _exit(0);
    } catch (const FileError&) {
      _exit(1);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WEXITSTATUS(status) == 1;
}

}  // namespace

TEST_CASE("a locked file is refused to other processes until its lock goes", "[io][files]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.e");
  write_bytes(path, "results");
  {
    const FileLock lock(path, "");
    CHECK(is_refused(path));
    CHECK_NOTHROW(FileLock(path, ""));  // of this process
    CHECK(is_refused(path));
  }
  CHECK_FALSE(is_refused(path));
}

TEST_CASE("what is not there and what is no file is not locked", "[io][files]") {
  const TemporaryDirectory directory;
  CHECK_NOTHROW(FileLock(directory.file("none"), ""));
  const FileLock lock("/dev/null", "");
  CHECK_FALSE(is_refused("/dev/null"));
}
