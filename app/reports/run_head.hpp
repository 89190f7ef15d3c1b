// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "app/run/run_estimate.hpp"

/// What a log holds of the machine and the moment of a run, which no two runs share.
namespace contactsim {

/// Date, command line, values of -D, ranks, threads of each, host and its processor.
///   definitions  "name=value"
std::string format_run_head(const std::string& command_line, std::span<const std::string> definitions,
                            int n_ranks, int n_threads);

/// Steps and element-steps of a run that has been checked; the same on every machine.
std::string format_estimate(const RunEstimate& estimate);

/// How long it will take here, and the memory that the program holds now.
std::string format_estimated_time(const RunEstimate& estimate, int n_threads);

}  // namespace contactsim
