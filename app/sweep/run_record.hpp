// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/sweep/sweep_points.hpp"

namespace contactsim {

/// What is left of a run in its folder, as its summary says it. Absent: not known.
struct RunRecord {
  std::string state;  ///< done, failed, stopped; "not ended" of a run that lasts or was killed
  std::optional<std::int64_t> exit_code;
  std::string deck_digest, mesh_digest;  ///< "" when not known
  std::optional<double> wall_time;       ///< [s]
  std::optional<std::int64_t> n_steps;
  std::optional<double> time, kinetic, internal, external, contact, friction, energy_error,
      energy_error_share;
  std::optional<double> peak_force, deepest, deepest_share;  ///< the largest of all pairs
  std::int64_t n_warnings = 0, n_errors = 0;
  std::string first_error;  ///< "" without errors
  std::string unused;       ///< what it says of names of -D that the deck does not use; "" without any
};

/// The record of a run; nothing when its folder has no whole summary, or one of another point.
///   folder  of the run
std::optional<RunRecord> read_record(const std::string& folder, const SweepPoint& point);

/// The name of a run's summary in its folder.
inline constexpr const char* summary_name = "summary.json";

}  // namespace contactsim
