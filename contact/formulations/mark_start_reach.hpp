// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// Sets the SEARCH DISTANCE of the pairs that have one, and marks which faces, surface nodes and edges are no
/// farther than it from the other side: by the shortest way between them, or behind a face by no more than
/// the thinner of both elements, for overlaps are to be found. What a surface has near itself counts where it
/// faces itself. Does nothing without such pairs.
///   start  the contact nodes before the first step
void mark_start_reach(const ContactModel& contact, const ContactKinematics& start, PairRules& rules);

}  // namespace contactsim
