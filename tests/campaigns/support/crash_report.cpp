// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/support/crash_report.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <string_view>

namespace contactsim::test {

namespace {

constexpr int max_frames = 64;

// dladdr is not among the functions that handlers may call; a process that is about to end may try.
void write_frames(int signal_number) {
  std::array<void*, max_frames> frames{};
  std::array<char, 512> line{};
  const int n = backtrace(frames.data(), max_frames);
  for (int i = 1; i < n; ++i) {  // the first is this handler
    Dl_info info{};
    const bool is_known = dladdr(frames[static_cast<std::size_t>(i)], &info) != 0;
    const int length = std::snprintf(line.data(), line.size(), "    #%d %p in %s (%s)\n", i,
                                     frames[static_cast<std::size_t>(i)],
                                     is_known && info.dli_sname != nullptr ? info.dli_sname : "?",
                                     is_known && info.dli_fname != nullptr ? info.dli_fname : "?");
    if (length > 0 && write(STDERR_FILENO, line.data(), static_cast<std::size_t>(length)) < 0) break;
  }
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

bool is_of_runtime(std::string_view frame) {
  constexpr std::array<std::string_view, 12> signs{
      "/libc.so",   "/ld-linux",         "/libstdc++",      "/libgcc_s", "/libasan", "/libubsan",
      " in __asan", " in __interceptor", " in __sanitizer", " in mem",   " in str",  "write_frames"};
  constexpr std::array<std::string_view, 6> allocators{" in malloc", " in calloc",       " in realloc",
                                                       " in free",   " in operator new", "?? ("};
  for (const std::string_view sign : signs) {
    if (frame.find(sign) != frame.npos) return true;
  }
  for (const std::string_view sign : allocators) {
    if (frame.find(sign) != frame.npos) return true;
  }
  return false;
}

}  // namespace

bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__)
  return true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
  return true;
#else
  return false;
#endif
#else
  return false;
#endif
}

void install_crash_report() {
  if (is_sanitized()) return;
  std::array<void*, 1> loaded{};
  backtrace(loaded.data(), 1);  // its library is loaded on first use, which a handler must not do
  // A stack that has run over leaves no room for the handler on it.
  static std::array<char, 1 << 16> stack_of_handler;
  stack_t place{};
  place.ss_sp = stack_of_handler.data();
  place.ss_size = stack_of_handler.size();
  sigaltstack(&place, nullptr);
  struct sigaction action {};
  action.sa_handler = write_frames;
  action.sa_flags = SA_ONSTACK;
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) sigaction(number, &action, nullptr);
}

std::string headline_of(const std::string& report) {
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    for (const char* sign :
         {"ERROR: ", "runtime error: ", "terminate called", "what():", "Assertion", "is damaged"}) {
      if (const std::size_t at = line.find(sign); at != line.npos)
        return line.substr(line[at] == 'E' ? at : 0);
    }
  }
  return "";
}

bool is_of_file_library(const std::string& report) {
  if (report.find("library broke down while it was read") != report.npos) return true;
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("    #") != 0 || is_of_runtime(line)) continue;
    return line.find("libnetcdf") != line.npos || line.find("libhdf5") != line.npos;
  }
  return false;
}

}  // namespace contactsim::test

// What sanitizers ask a program for; without them nothing calls these.

// An allocation of more than that is an error, a failed malloc of a library gives it null.
extern "C" __attribute__((used)) const char* __asan_default_options() {
  return "allocator_may_return_null=1:max_allocation_size_mb=2048:hard_rss_limit_mb=4096:detect_stack_use_"
         "after_return=0:handle_"
         "abort=1";
}

extern "C" __attribute__((used)) const char* __ubsan_default_options() { return "print_stacktrace=1"; }

// What the libraries of the files lose when they give a damaged one up, and what OpenMP keeps for its
// threads.
extern "C" __attribute__((used)) const char* __lsan_default_suppressions() {
  return "leak:libhdf5\nleak:libnetcdf\nleak:libomp\nleak:libgomp\n";
}
