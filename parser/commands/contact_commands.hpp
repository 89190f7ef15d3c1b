// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/contact.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN CONTACT DEFINITION.
const Table<ContactDefinition>& contact_definition_table();

}  // namespace contactsim
