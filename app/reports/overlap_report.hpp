// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/overlap_removal.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The table of overlaps at the start: a row for every pair that overlaps; "" without any.
std::string format_start_overlaps(std::span<const StartOverlap> overlaps, const ContactModel& model,
                                  const Mesh& mesh);

/// The table of moves: a row for every pair that overlapped.
std::string format_overlap(const OverlapRemoved& removed, const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim
