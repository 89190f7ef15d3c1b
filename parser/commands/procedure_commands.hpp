// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/procedure.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN {PRESTO | ADAGIO | SOLID MECHANICS} PROCEDURE, also PROCEDURE alone: rows that add to a list.
std::vector<Row<std::vector<Procedure>>> procedure_rows();

}  // namespace contactsim
