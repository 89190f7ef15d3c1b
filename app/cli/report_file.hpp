// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "app/cli/options.hpp"
#include "app/report/page_libraries.hpp"
#include "app/report/report_draft.hpp"
#include "app/reports/run_summary.hpp"

namespace contactsim {

/// The libraries of a report, if the options ask for one. What would keep the report from being written shows
/// here, before the run. Throws FileError.
std::optional<PageLibraries> find_report_libraries(const Options& options);

/// Writes the report of a run from what it has written, however it ended. Throws FileError.
void write_report_file(const Options& options, const ReportDraft& draft, const RunSummary& summary,
                       const PageLibraries& libraries);

}  // namespace contactsim
