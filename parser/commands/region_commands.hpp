// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN {PRESTO | ADAGIO | SOLID MECHANICS} REGION.
const Table<Region>& region_table();

}  // namespace contactsim
