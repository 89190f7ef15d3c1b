// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The state of a region at the start: INITIAL VELOCITY and INITIAL CONDITION.
std::vector<Row<Region>> initial_condition_rows();

}  // namespace contactsim
