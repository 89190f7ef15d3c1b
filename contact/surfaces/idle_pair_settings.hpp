// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/diagnostics.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

/// Warns of settings of pairs that have no effect in this kind of procedure:
/// "enforcement-of-other-procedures" and "stabilization-of-other-procedures".
void warn_of_idle_pair_settings(const ContactDefinition& contact, Diagnostics& diagnostics);

}  // namespace contactsim
