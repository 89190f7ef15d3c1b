// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The loads of a region: forces, moments, pressures, tractions and gravity.
std::vector<Row<Region>> load_rows();

}  // namespace contactsim
