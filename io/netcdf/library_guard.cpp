// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/library_guard.hpp"

#include "core/base/end_at_once.hpp"

namespace contactsim {

namespace {

constexpr std::array<int, 4> fatal_signals{SIGSEGV, SIGBUS, SIGABRT, SIGFPE};

const char* guarded_path = nullptr;

void tell_and_exit(int) {
  end_at_once(ExitCode::file, {"error: ", guarded_path,
                               ": is damaged: the netCDF or HDF5 library broke down while it was read"});
}

}  // namespace

LibraryGuard::LibraryGuard(const std::string& path) {
  guarded_path = path.c_str();
  // A stack that has run over leaves no room for a handler on it.
  static std::array<char, 1 << 16> stack_of_handler;
  stack_t stack{};
  stack.ss_sp = stack_of_handler.data();
  stack.ss_size = stack_of_handler.size();
  sigaltstack(&stack, &stack_before_);
  struct sigaction action {};
  action.sa_handler = tell_and_exit;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < fatal_signals.size(); ++i) sigaction(fatal_signals[i], &action, &before_[i]);
}

LibraryGuard::~LibraryGuard() {
  for (std::size_t i = 0; i < fatal_signals.size(); ++i) sigaction(fatal_signals[i], &before_[i], nullptr);
  sigaltstack(&stack_before_, nullptr);
}

}  // namespace contactsim
