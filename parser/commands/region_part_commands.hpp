// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The blocks of a region that are neither contact nor conditions nor output: mass properties, spot welds,
/// mass scaling, element death, termination.
std::vector<Row<Region>> region_part_rows();

}  // namespace contactsim
