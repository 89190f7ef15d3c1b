// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/automatic_lengths.hpp"

namespace contactsim {

/// "both", "top" or "bottom".
std::string_view name_of(ShellSides sides);

/// The resolved settings of every interaction that has a pair, and those that reach, gaps and sides of some
/// have.
///   lengths    [n_pairs] that stand beside "auto", or empty
std::string format_interactions(const ContactModel& model,
                                IndexedSpan<PairIndex, const AutomaticLengths> lengths);

}  // namespace contactsim
