// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/support/campaign_progress.hpp"

#include <sys/mman.h>
#include <sys/resource.h>

#include <csignal>
#include <exception>
#include <new>
#include <typeinfo>

namespace contactsim::test {

namespace {

/// Where handlers of signals find it.
Progress* shown_progress = nullptr;

void stop_campaign(int) { shown_progress->is_stopped = true; }

}  // namespace

Progress* make_shared_progress() {
  void* shared = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::bad_alloc();
  shown_progress = new (shared) Progress;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, stop_campaign);
  return shown_progress;
}

std::uint64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // KiB on Linux
}

std::string describe_exception() {
  try {
    throw;
  } catch (const std::exception& error) {
    return std::string("threw ") + typeid(error).name() + ": " + error.what();
  } catch (...) {
    return "threw something";
  }
}

}  // namespace contactsim::test
