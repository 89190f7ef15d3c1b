// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/function.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN FUNCTION, also DEFINITION FOR FUNCTION.
const Table<FunctionDefinition>& function_table();

/// What is wrong with a function that something uses: type and values missing or not fitting each other, an
/// abscissa that decreases, a type that contactsim cannot evaluate.
void check_used_function(const FunctionDefinition& function, Diagnostics& diagnostics);

}  // namespace contactsim
