// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/contact.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The blocks of a contact definition that define friction models.
std::vector<Row<ContactDefinition>> friction_rows();

}  // namespace contactsim
