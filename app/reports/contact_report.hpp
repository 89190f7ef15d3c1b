// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "contact/enforcement/contact_force.hpp"
#include "contact/overlap/untied_parts.hpp"

namespace contactsim {

/// What contact starts with: ties of each tied pair and their area, nodes that no tie reaches, what SEARCH
/// DISTANCE leaves, stiffness of the penalty behind the faces. "" when there is nothing to say.
std::string format_contact_start(const ContactForce& force, const ContactModel& contact,
                                 IndexedSpan<PairIndex, const UntiedPart> untied, const Mesh& mesh);

/// What the search of a run did, what is tied, and how much contact lowered the stable step, which load steps
/// have none of. Without times of the clock.
std::string format_contact(const ContactForce& contact, bool is_static);

}  // namespace contactsim
