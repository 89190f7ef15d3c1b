// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "app/cli/program.hpp"

namespace {

/// Starts the program anew with threads that sleep soon when they wait for each other. By default they spin
/// for a millisecond, which takes the processor from the very thread that they wait for as soon as other
/// programs run beside this one: steps then take twenty times as long. OpenMP's library reads the variable
/// before main() begins.
void sleep_while_waiting(char** argv) {
  constexpr const char* variable = "GOMP_SPINCOUNT";
  if (std::getenv(variable) != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  setenv(variable, "3000", 0);
  execv("/proc/self/exe", argv);  // when that is not possible, things go on as they are
}

}  // namespace

int main(int argc, char** argv) {
  sleep_while_waiting(argv);
  // A file that passes the limit of its size is then an error like a full disk, not the end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  return contactsim::run_program(argc, argv);
}
