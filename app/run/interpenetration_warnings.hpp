// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_force.hpp"
#include "contact/overlap/interpenetration_watch.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Warns of pairs whose bodies have come to lie in each other by more than a fifth of a thickness
/// ("interpenetration") where contact's own penetration does not say so, and of those of which a node has
/// gone through a shell ("passed-through").
///   found  of each pair
void warn_of_interpenetration(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                              IndexedSpan<PairIndex, const Interpenetration> found, Diagnostics& warnings);

}  // namespace contactsim
