// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/stop_signal.hpp"

#include <array>
#include <csignal>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Puts the handlers of signals back as they were at its end.
class KeptHandlers {
 public:
  KeptHandlers() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], nullptr, &earlier_[i]);
  }
  ~KeptHandlers() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &earlier_[i], nullptr);
  }
  KeptHandlers(const KeptHandlers&) = delete;
  KeptHandlers& operator=(const KeptHandlers&) = delete;

  static constexpr std::array signals{SIGTERM, SIGINT, SIGHUP, SIGUSR1};

 private:
  std::array<struct sigaction, 4> earlier_{};
};

bool is_default(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_DFL;
}

}  // namespace

TEST_CASE("a signal to end is noted by its name, and ends what comes before a run", "[app][signals]") {
  const KeptHandlers kept;
  std::signal(SIGHUP, SIG_DFL);
  const auto [signal, name] =
      GENERATE(table<int, std::string>({{SIGTERM, "SIGTERM"}, {SIGINT, "SIGINT"}, {SIGHUP, "SIGHUP"}}));
  StopSignals signals;
  CHECK_FALSE(signals.find_stop());
  CHECK_NOTHROW(signals.end_if_stopped());
  std::raise(signal);
  CHECK(signals.find_stop() == name);
  CHECK(signals.find_stop() == name);  // it stays
  try {
    signals.end_if_stopped();
    FAIL("goes on");
  } catch (const StoppedBySignal& stopped) {
    CHECK(stopped.signal == name);
  }
  // Who asks a second time ends the process.
  CHECK(is_default(signal));
}

TEST_CASE("a wish for a restart file is taken once, and ends nothing", "[app][signals]") {
  const KeptHandlers kept;
  StopSignals signals;
  CHECK_FALSE(signals.take_restart_wish());
  std::raise(SIGUSR1);
  std::raise(SIGUSR1);
  CHECK(signals.take_restart_wish());
  CHECK_FALSE(signals.take_restart_wish());
  CHECK_FALSE(signals.find_stop());
  std::raise(SIGUSR1);
  CHECK(signals.take_restart_wish());
}

TEST_CASE("a hangup that is ignored stays so, and later objects begin without signals", "[app][signals]") {
  const KeptHandlers kept;
  std::signal(SIGHUP, SIG_IGN);
  {
    const StopSignals signals;
    std::raise(SIGHUP);
    CHECK_FALSE(signals.find_stop());
    std::raise(SIGTERM);
    CHECK(signals.find_stop() == "SIGTERM");
  }
  StopSignals later;
  CHECK_FALSE(later.find_stop());
}
