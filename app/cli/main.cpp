// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "app/cli/exit_guard.hpp"
#include "app/cli/program.hpp"

namespace {

/// Has threads that wait for each other sleep soon. By default they spin for milliseconds, which takes the
/// processor from the very thread that they wait for as soon as other programs run beside this one: steps
/// then take twenty times as long. OpenMP's library reads the variable when it is initialised: as it is
/// linked statically, after constructors of this priority.
[[gnu::constructor(101)]] void sleep_while_waiting() {
  if (std::getenv("OMP_WAIT_POLICY") == nullptr) setenv("GOMP_SPINCOUNT", "3000", 0);
}

/// Files of the run would get the numbers of standard streams that are closed, and hold what is printed.
void open_standard_streams() {
  int lowest = 0;
  do {
    lowest = open("/dev/null", O_RDWR);
  } while (lowest >= STDIN_FILENO && lowest <= STDERR_FILENO);
  if (lowest > STDERR_FILENO) close(lowest);
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  // A file that passes the limit of its size is then an error like a full disk, not the end of the process.
  // So is a pipe whose reader has gone: the run goes on and writes its files.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  contactsim::end_without_memory();
  return contactsim::run_program(argc, argv);
}
