// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/parallel/ranks.hpp"

namespace contactsim {

/// Thrown where a run ends before its first step because a signal came.
struct StoppedBySignal {
  std::string signal;  ///< its name
};

/// What the system may ask of a run while it lasts: to end after the step (SIGTERM, SIGINT, and SIGHUP where
/// it is not ignored) or to write a restart file (SIGUSR1). Who asks a second time to end ends the process.
/// There is one of these at a time. A signal that reaches one rank ends the run on all. What comes after it
/// is noted in vain: the process is about to end with the exit code of the run.
class StopSignals {
 public:
  /// From now on signals are noted.
  ///   ranks  which call the functions below alike; they must outlive it
  explicit StopSignals(Ranks& ranks = one_rank());
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The name of the signal that ends the run, if one came.
  std::optional<std::string> find_stop() const;
  /// Throws StoppedBySignal if one came: to be called between the parts of what comes before a run.
  void end_if_stopped() const;
  /// Whether a restart file was asked for since the last call.
  bool take_restart_wish();

 private:
  Ranks& ranks_;
};

}  // namespace contactsim
