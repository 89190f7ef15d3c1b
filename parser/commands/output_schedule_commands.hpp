// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/output_schedule.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The timing lines that outputs and BEGIN OUTPUT SCHEDULER take.
std::vector<Row<OutputSchedule>> output_schedule_rows();

}  // namespace contactsim
