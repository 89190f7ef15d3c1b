// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "contact/enforcement/contact_force.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// What contact starts with: ties of each tied pair and their area, stiffness of the penalty behind the
/// faces. "" when there is nothing to say.
std::string format_contact_start(const ContactForce& force, const ContactModel& contact);

/// Warns of tied pairs that tie nothing.
void warn_of_empty_ties(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings);

/// Adds the warning "tie-partial" for every pair that should hold surfaces of side sets or node sets together
/// and leaves a part of each of them free.
void warn_of_partial_ties(const ContactForce& force, const ContactModel& contact,
                          const ContactDefinition& definition, const Mesh& mesh, Diagnostics& warnings);

/// Warns of lines of the elastic penalty on pairs that are enforced by momentum balance.
void warn_of_idle_settings(const ContactModel& contact, Diagnostics& warnings);

/// Warns of pairs whose beams or trusses meet while their law ties, pulls or changes: contact of edges does
/// not know it.
void warn_of_edges(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings);

/// What the search of a run did, what is tied, and how much contact lowered the stable step. Without times of
/// the clock.
std::string format_contact(const ContactForce& contact);

}  // namespace contactsim
