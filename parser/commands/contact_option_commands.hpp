// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/contact.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The lines and blocks of a contact definition that steer search, enforcement, lofting, overlap removal and
/// output.
std::vector<Row<ContactDefinition>> contact_option_rows();

}  // namespace contactsim
