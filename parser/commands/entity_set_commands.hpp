// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/entity_set.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The lines by which a block picks mesh parts.
std::vector<Row<EntitySet>> entity_set_rows();

}  // namespace contactsim
