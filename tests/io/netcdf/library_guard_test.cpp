// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/library_guard.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using contactsim::test::read_bytes;
using contactsim::test::TemporaryDirectory;

namespace {

/// The exit code of a child in which a signal comes while a library reads a file; its standard error goes to
/// another file.
int exit_code_of(int signal_number, const std::string& errors) {
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen(errors.c_str(), "w", stderr) == nullptr) _exit(99);
    const std::string path = "plate.g";
    const LibraryGuard guard(path);
    std::raise(signal_number);
    _exit(98);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("a library that breaks down ends the program with the name of the file", "[io][netcdf]") {
  const TemporaryDirectory directory;
  const std::string errors = directory.file("errors.txt");
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE}) {
    CHECK(exit_code_of(number, errors) == 3);
    CHECK(read_bytes(errors) ==
          "error: plate.g: is damaged: the netCDF or HDF5 library broke down while it was read\n");
  }
}

TEST_CASE("handlers of before are back behind a guard", "[io][netcdf]") {
  struct sigaction before {
  }, after{};
  sigaction(SIGSEGV, nullptr, &before);
  const std::string path = "plate.g";
  { const LibraryGuard guard(path); }
  sigaction(SIGSEGV, nullptr, &after);
  CHECK(before.sa_handler == after.sa_handler);
  CHECK(before.sa_flags == after.sa_flags);
}
