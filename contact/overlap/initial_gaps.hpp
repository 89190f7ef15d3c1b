// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// How near the two surfaces of a pair are before the first step.
struct InitialGap {
  double smallest_gap = std::numeric_limits<double>::quiet_NaN();  ///< < 0 overlaps; NaN: none known [length]
  std::uint64_t n_in_reach = 0;  ///< pairs of a node or face and a face that the search found
};

using InitialGaps = IndexedVector<PairIndex, InitialGap>;

/// How near the surfaces of each pair are on the mesh as it was read: one global search and the gap of every
/// candidate that projects inside the other side.
InitialGaps find_initial_gaps(const ContactModel& model, const Mesh& mesh, const DashOptions& dash);

}  // namespace contactsim
