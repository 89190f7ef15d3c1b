// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/run/timed_force.hpp"
#include "core/parallel/load_ranks.hpp"

namespace contactsim {

namespace {

constexpr double seconds_between = 0.2;

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::min(seconds, 1e8));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

bool is_terminal(int stream) { return n_started_processes() == 1 && isatty(stream) != 0; }

std::string progress_line(double share, double elapsed) {
  constexpr int width = 30;
  const double done = std::clamp(share, 0.0, 1.0);
  const int filled = static_cast<int>(done * width);
  const std::string left = done > 0.0 ? duration(elapsed * (1.0 / done - 1.0)) + " left" : "";
  return fmt::format("{:4.0f} % [{:#<{}}{:.<{}}] {}", 100.0 * done, "", filled, "", width - filled, left);
}

Progress::Progress(double start, double end)
    : start_(start), end_(end), begun_(clock_seconds()), is_terminal_(is_terminal(STDOUT_FILENO)) {}

Progress::~Progress() { wipe(); }

void Progress::show(double time) {
  if (!is_terminal_) return;
  const double now = clock_seconds();
  if (now - shown_ < seconds_between) return;
  shown_ = now;
  is_drawn_ = true;
  std::fputs(("\r" + progress_line((time - start_) / (end_ - start_), now - begun_) + "\033[K").c_str(),
             stdout);
  std::fflush(stdout);
}

void Progress::wipe() {
  if (!is_drawn_) return;
  std::fputs("\r\033[K", stdout);
  std::fflush(stdout);
  is_drawn_ = false;
}

}  // namespace contactsim
