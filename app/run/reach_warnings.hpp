// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_force.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Warns of lines about reach that do nothing: of CAPTURE TOLERANCE where a law holds nothing
/// ("capture-without-effect"), of SEARCH DISTANCE within which nothing is ("search-distance-empty"); and of
/// INFINITESIMAL_SLIDING of sides that are not near each other, and so never meet ("no-start-partner"), or
/// whose SIDE B is the larger one ("small-sliding-sides").
void warn_of_reach(const ContactForce& force, const ContactModel& contact,
                   const ContactDefinition& definition, Diagnostics& warnings);

}  // namespace contactsim
