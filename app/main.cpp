// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>

#include "app/program.hpp"

int main(int argc, char** argv) {
  // A file that passes the limit of its size is then an error like a full disk, not the end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  return contactsim::run_program(argc, argv);
}
