// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/function.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN FUNCTION, also DEFINITION FOR FUNCTION.
const Table<FunctionDefinition>& function_table();

}  // namespace contactsim
