// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/contact.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The blocks of a contact definition that say which surfaces meet, and how.
std::vector<Row<ContactDefinition>> interaction_rows();

}  // namespace contactsim
