// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/report/page_libraries.hpp"
#include "app/report/report_run.hpp"

namespace contactsim {

/// Throws FileError when a report at the path would overwrite a file that is no HTML.
void check_report_place(const std::string& path);

/// Writes a page that shows runs, the first beside the others, in a file that needs no other: at most five
/// million bytes for each run as long as two frames of it fit. Throws FileError, also rather than overwrite a
/// file that is no HTML.
void write_report(const std::string& path, const std::vector<ReportRun>& runs,
                  const PageLibraries& libraries);

}  // namespace contactsim
