// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/options.hpp"
#include "app/reports/run_summary.hpp"

namespace contactsim {

/// What is known before the deck is read.
RunSummary begin_summary(const Options& options);

/// Writes a summary where the options ask for it; else nothing. Throws FileError.
void write_summary_file(const Options& options, const RunSummary& summary);

/// The same for the first time, before the run: shows that the file can be written, and leaves word of a run
/// that is killed. Throws FileError, also rather than overwrite a file that is no JSON.
void begin_summary_file(const Options& options, const RunSummary& summary);

}  // namespace contactsim
