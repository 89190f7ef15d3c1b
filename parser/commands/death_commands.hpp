// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/death.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN ELEMENT DEATH.
const Table<ElementDeath>& element_death_table();

}  // namespace contactsim
