// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/report_options.hpp"
#include "app/report/report_run.hpp"

namespace contactsim {

/// A run as its results file and the files beside it tell it. Throws FileError.
///   options  names files in place of those beside it
ReportRun read_report_run(const std::string& results, const ReportOptions& options);

/// Writes the page that the options ask for, and prints its name. Returns the exit code. Throws FileError.
int run_report(const ReportOptions& options);

}  // namespace contactsim
