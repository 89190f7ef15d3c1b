// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/reports/log.hpp"
#include "app/run/simulation.hpp"
#include "contact/overlap/overlap_removal.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Removes the overlap of contact surfaces, if the deck asks for it, and writes to the log. Returns the mesh
/// with the nodes moved, which is free of stress; nothing when no node moves.
///   warnings  gains what overlap is left: "overlap-left"
/// Throws SolveError naming pair and element when elements would be turned inside out.
std::optional<Mesh> remove_initial_overlap(const RunInput& input, Log& log, Diagnostics& warnings);

/// Finds what overlaps as the run starts, and writes to the log.
std::vector<StartOverlap> find_overlaps(const RunInput& input, Log& log);

/// Warns of every pair that overlaps at the start, unless it is tied or overlap removal has been asked for:
/// "overlap-at-start", with the deck line that would remove it.
///   stored  [n_pairs] that contact holds in it [energy]; empty when that is not known
void warn_of_overlaps(const RunInput& input, std::span<const StartOverlap> overlaps,
                      std::span<const double> stored, Diagnostics& warnings);

/// The table of overlaps at the start: a row for every pair that overlaps; "" without any.
std::string format_start_overlaps(std::span<const StartOverlap> overlaps, const ContactModel& model,
                                  const Mesh& mesh);

/// The table of moves: a row for every pair that overlapped.
std::string format_overlap(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim
