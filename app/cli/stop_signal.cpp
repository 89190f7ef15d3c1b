// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/stop_signal.hpp"

#include <algorithm>
#include <csignal>
#include <utility>

namespace contactsim {

namespace {

// All that a handler of signals may write to, and the only numbers of the program that are nobody's.
volatile std::sig_atomic_t signal_to_end = 0, wants_restart = 0;

extern "C" void contactsim_note_end(int signal) { signal_to_end = signal; }
extern "C" void contactsim_note_restart(int) { wants_restart = 1; }

/// nohup and the like have a process ignore it.
bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

void set_handler(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

StopSignals::StopSignals(Ranks& ranks) : ranks_(ranks) {
  signal_to_end = 0;
  wants_restart = 0;
  // Writes to files go on after a signal, and a second one has its usual way.
  constexpr int once = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  set_handler(SIGTERM, contactsim_note_end, once);
  set_handler(SIGINT, contactsim_note_end, once);
  if (!is_ignored(SIGHUP)) set_handler(SIGHUP, contactsim_note_end, once);
  set_handler(SIGUSR1, contactsim_note_restart, SA_RESTART);
}

std::optional<std::string> StopSignals::find_stop() const {
  const int signal = std::ranges::max(ranks_.of_all(int{signal_to_end}));
  if (signal == 0) return std::nullopt;
  if (signal == SIGHUP) return "SIGHUP";
  return signal == SIGINT ? "SIGINT" : "SIGTERM";
}

void StopSignals::end_if_stopped() const {
  if (auto signal = find_stop()) throw StoppedBySignal{std::move(*signal)};
}

bool StopSignals::take_restart_wish() {
  const int own = wants_restart;
  if (own != 0) wants_restart = 0;
  return std::ranges::max(ranks_.of_all(own)) != 0;
}

}  // namespace contactsim
