// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "app/report/report_run.hpp"

namespace contactsim {

/// A run as JSON for a page, without "<", so that it may stand in HTML. Frames are as many as leave the whole
/// below a size. Throws FileError when results cannot be read.
///   max_bytes  of the text; more when two frames alone pass it
std::string format_report_json(const ReportRun& run, std::size_t max_bytes);

}  // namespace contactsim
