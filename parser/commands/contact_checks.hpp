// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/contact.hpp"
#include "parser/binding/deck_names.hpp"

namespace contactsim {

/// What is wrong between the commands of a contact definition: interactions of node sets without faces, used
/// friction models that select themselves.
///   names  resolved
void check_contact(const ContactDefinition& contact, const DeckNames& names, Diagnostics& diagnostics);

}  // namespace contactsim
