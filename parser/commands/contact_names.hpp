// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/contact.hpp"
#include "parser/commands/region_name_uses.hpp"

namespace contactsim {

/// Checks the names of a contact definition: that surfaces, friction models and interactions have names of
/// their own, that what is named is defined, and that friction models that are used are whole. Friction
/// models that nothing uses are not looked into.
void resolve_contact_names(const ContactDefinition& contact, const NameUses& uses);

}  // namespace contactsim
