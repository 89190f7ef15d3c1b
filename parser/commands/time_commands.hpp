// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/time_control.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN TIME CONTROL.
const Table<TimeControl>& time_control_table();

/// What is missing or out of order in a time control: start and termination times, blocks.
void check_time_control(const TimeControl& control, Diagnostics& diagnostics);

}  // namespace contactsim
