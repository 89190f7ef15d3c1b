// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/output/variable_selection.hpp"

namespace contactsim {

/// fill() on several ranks, of which each knows its own nodes and elements: all get the values of all. All
/// ranks call it alike.
///   context  of several ranks
void fill_from_ranks(const VariableSelection& selection, const OutputContext& context,
                     const EntityRange& range, std::span<double> values);

}  // namespace contactsim
