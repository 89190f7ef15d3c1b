// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/pair_history.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Warns of what the pairs of a run have come to: contact that ended though it was deep ("contact-lost"), and
/// sides that have penetrated each other by more than a tenth of the thickness ("contact-penetration").
void warn_of_depths(IndexedSpan<PairIndex, const PairHistory> histories, const ContactModel& contact,
                    const Mesh& mesh, Diagnostics& warnings);

/// Warns of pairs of infinitesimal sliding that have slid off their faces of the start ("slid-off-partner"),
/// or lost them to deaths ("start-face-lost").
void warn_of_small_sliding(IndexedSpan<PairIndex, const PairHistory> histories, const ContactModel& contact,
                           const Mesh& mesh, Diagnostics& warnings);

}  // namespace contactsim
