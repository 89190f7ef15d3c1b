// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/output.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN RESTART DATA.
const Table<RestartData>& restart_table();

}  // namespace contactsim
