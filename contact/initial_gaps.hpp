// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/contact_model.hpp"
#include "contact/pair_history.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// How near the surfaces of each pair are on the mesh as it was read: one global search and the gap of every
/// candidate that projects inside the other side.
/// Returns [n_pairs] of the model.
std::vector<InitialGap> find_initial_gaps(const ContactModel& model, const Mesh& mesh,
                                          const DashOptions& dash);

}  // namespace contactsim
