// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "app/run/run_input.hpp"
#include "contact/overlap/overlap_removal.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Removes the overlap of contact surfaces, if the definition asks for it; nothing if not.
std::optional<OverlapRemoved> remove_initial_overlap(const RunInput& input);

/// The mesh with the nodes moved, which is free of stress; nothing when no node moves. Whoever goes on with
/// it calls refit_smoothings().
///   warnings  gains what overlap is left: "overlap-left"
/// Throws SolveError naming pair and element when elements would be turned inside out.
std::optional<Mesh> move_nodes(const RunInput& input, OverlapRemoved removed, Diagnostics& warnings);

/// The names of the surfaces of a pair.
std::string names_of(const ContactModel& model, PairIndex pair);

/// Warns of every pair that overlaps at the start, unless it is tied or overlap removal has been asked for:
/// "overlap-at-start", with the deck line that would remove it.
///   stored  that contact holds in it [energy]; empty when that is not known
void warn_of_overlaps(const RunInput& input, std::span<const StartOverlap> overlaps,
                      IndexedSpan<PairIndex, const double> stored, Diagnostics& warnings);

/// How deep the sides of each pair lie in each other at the start by the gaps that count, of pairs whose
/// CONTACT OFFSET or INITIAL CLEARANCE makes them do so; else 0 [length].
IndexedVector<PairIndex, double> find_offset_overlaps(const RunInput& input);

/// Warns of pairs that a CONTACT OFFSET has overlap: "offset-overlap".
///   depths  of find_offset_overlaps()
///   stored  that contact holds in them [energy]
void warn_of_offsets(const ContactModel& model, IndexedSpan<PairIndex, const double> depths,
                     IndexedSpan<PairIndex, const double> stored, Diagnostics& warnings);

}  // namespace contactsim
