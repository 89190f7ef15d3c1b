// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The blocks of a region that make variables: USER OUTPUT and USER VARIABLE.
std::vector<Row<Region>> user_output_rows();

}  // namespace contactsim
