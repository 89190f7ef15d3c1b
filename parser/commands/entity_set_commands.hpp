// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/entity_set.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// A block that must pick mesh parts.
inline const Choice must_pick_parts{"picks no part of the mesh", ""};

/// The lines by which a block picks mesh parts; those that add some are the choice.
std::vector<Row<EntitySet>> entity_set_rows(const Choice& choice = {});

}  // namespace contactsim
