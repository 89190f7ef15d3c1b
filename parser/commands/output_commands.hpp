// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The output blocks of a region: RESULTS, HISTORY and HEARTBEAT OUTPUT and RESTART DATA.
std::vector<Row<Region>> output_rows();

}  // namespace contactsim
