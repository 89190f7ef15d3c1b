// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The kinematic conditions of a region: FIXED and PRESCRIBED blocks.
std::vector<Row<Region>> kinematic_condition_rows();

/// Conditions that are known and not supported.
std::vector<Row<Region>> other_condition_rows();

}  // namespace contactsim
