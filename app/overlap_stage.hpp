// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "app/log.hpp"
#include "app/transient.hpp"
#include "contact/overlap_removal.hpp"
#include "core/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Removes the overlap of contact surfaces, if the deck asks for it, and tells the log. Returns the mesh with
/// the nodes moved, which is free of stress; nothing when no node moves.
///   warnings  gains what overlap is left: "overlap-left"
std::optional<Mesh> remove_initial_overlap(const RunInput& input, Log& log, Diagnostics& warnings);

/// The table of moves: a row for every pair that overlapped.
std::string format_overlap(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim
