// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/time_control.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN TIME CONTROL.
const Table<TimeControl>& time_control_table();

}  // namespace contactsim
