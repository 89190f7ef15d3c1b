// SPDX-License-Identifier: BSD-3-Clause
#include "parser/contact_commands.hpp"

#include "parser/contact_surface_commands.hpp"

namespace contactsim {

const Table<ContactDefinition>& contact_definition_table() {
  static const Table<ContactDefinition> table(contact_surface_rows());
  return table;
}

}  // namespace contactsim
