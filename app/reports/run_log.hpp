// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "app/reports/log.hpp"
#include "app/reports/progress.hpp"
#include "app/run/simulation.hpp"

namespace contactsim {

/// The observer that writes to the log what a run does, and shows on a terminal how far it is.
class RunLog {
 public:
  /// The log must outlive this.
  explicit RunLog(Log& log) : log_(log) {}

  void look(RunEvent event, const Simulation& run);

 private:
  void write_start(const Simulation& run, bool is_resumed);
  void write_deaths(const Simulation& run);
  void write_step(const Simulation& run, bool is_last);
  void write_end(const Simulation& run);

  Log& log_;
  std::optional<Progress> progress_;
  std::optional<std::int64_t> last_line_;  // its step
};

}  // namespace contactsim
