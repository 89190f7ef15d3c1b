// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/sweep/run_record.hpp"
#include "app/sweep/sweep_points.hpp"

namespace contactsim {

/// What a run is to be made of.
struct RunRequest {
  std::vector<std::string> words;        ///< the program's path and its arguments, but for --summary
  std::string deck_digest, mesh_digest;  ///< of what it would read now; "" when that cannot be read
};

/// What a sweep needs from outside.
struct SweepSettings {
  std::string folder;      ///< of the study
  std::string name;        ///< of the study, in study.xml
  std::size_t n_jobs = 1;  ///< runs beside each other
  /// Makes the request of a point.
  std::function<RunRequest(const SweepPoint&)> make_request;
  std::function<bool()> wants_stop;  ///< whether the sweep is to end, asked some times a second
  std::function<void(std::string_view)> write_line;  ///< takes a line of progress
};

/// How a sweep went.
struct SweepOutcome {
  std::size_t n_done = 0, n_failed = 0, n_stopped = 0;
  std::size_t n_kept = 0;  ///< done before, and not run again
  std::size_t n_left = 0;  ///< not begun
  int first_failure = 0;   ///< exit code of the first run, by number, that failed; 0 without one
  bool is_stopped = false;
  std::map<std::string, std::size_t>
      unused;  ///< what runs said of names that their deck does not use, how often
};

/// Runs all that has not been done with the same parameters, deck and mesh, and writes study.csv and
/// study.xml. A run that fails does not keep others from being run. When a stop is wanted, the runs are asked
/// to end with their step, and waited for. Throws FileError when the study's folder cannot be written to.
SweepOutcome run_sweep_of(const std::vector<SweepRun>& runs, const SweepSettings& settings);

/// Runs one of them, unless it is done, and writes no files of the study. Returns its exit code. Throws
/// FileError.
int run_one_of(const SweepRun& run, const SweepSettings& settings);

/// Writes study.csv and study.xml from what there is. Throws FileError.
///   Returns the records [n runs] absent of runs that left none.
std::vector<std::optional<RunRecord>> collect_study(const std::vector<SweepRun>& runs,
                                                    const SweepSettings& settings);

}  // namespace contactsim
