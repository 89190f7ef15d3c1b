// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/sweep/run_record.hpp"
#include "app/sweep/sweep_points.hpp"

namespace contactsim {

/// study.csv: a line per run: its number, folder, parameters, how it ended, what it came to. What is not
/// known is empty.
///   records  [n runs] absent of those that have not been run
std::string format_study_csv(const std::vector<SweepRun>& runs,
                             const std::vector<std::optional<RunRecord>>& records);

/// study.xml: every run as a test case of JUnit's format; one that did not end with code 0 is a failure, one
/// that has not been run is skipped.
std::string format_study_xml(const std::string& name, const std::vector<SweepRun>& runs,
                             const std::vector<std::optional<RunRecord>>& records);

}  // namespace contactsim
