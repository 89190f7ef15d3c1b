// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/region.hpp"
#include "parser/commands/region_name_uses.hpp"

namespace contactsim {

/// Checks the conditions of a region: the names in them, that each picks mesh parts, a direction and a value,
/// and only one of each kind.
void resolve_condition_names(const Region& region, const NameUses& uses);

}  // namespace contactsim
