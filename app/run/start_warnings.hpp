// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "contact/enforcement/contact_force.hpp"
#include "contact/overlap/untied_parts.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// The names of a pair's surfaces: "a to b".
std::string names_of(const SurfacePair& pair, const ContactModel& contact);

/// Ties of a pair of surfaces.
struct TiedArea {
  std::size_t n_ties = 0;
  double area = 0.0;  ///< [length^2]
};

/// The ties of each pair [n_pairs].
IndexedVector<PairIndex, TiedArea> tied_areas(const ContactForce& force, const ContactModel& contact);

/// Warns of tied pairs that tie nothing.
void warn_of_empty_ties(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings);

/// What ties were made from.
struct TiedContact {
  const ContactModel& contact;
  const ContactDefinition& definition;
  const Mesh& mesh;
  IndexedSpan<PairIndex, const UntiedPart> untied;
};

/// Adds the warning "tie-partial" for every pair that holds less than what of the smaller surface lies before
/// the other one, and for every pair that should hold surfaces of side sets or node sets together and leaves
/// a part of each of them free.
void warn_of_partial_ties(const ContactForce& force, const TiedContact& tied, Diagnostics& warnings);

/// Warns of lines of the elastic penalty on pairs that are enforced by momentum balance, or by a pressure of
/// their own.
void warn_of_idle_settings(const ContactModel& contact, Diagnostics& warnings);

/// Warns of lines about gaps that do nothing, because the pair only ties ("gap-without-effect") or nothing
/// was near at the start ("clearance-empty"), and of a clearance that counts for sides farther apart than a
/// face is wide ("clearance-far").
void warn_of_gaps(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings);

/// Warns of SEPARATION = OFF on ties ("separation-without-effect") and of SIDES where there are no shells
/// ("sides-without-shells").
void warn_of_sides(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                   Diagnostics& warnings);

/// Warns of pairs whose beams or trusses meet while their law ties, pulls or changes: contact of edges does
/// not know it.
void warn_of_edges(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings);

}  // namespace contactsim
