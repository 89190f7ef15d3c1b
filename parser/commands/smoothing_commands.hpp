// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/contact.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The row of BEGIN SURFACE SMOOTHING.
std::vector<Row<ContactDefinition>> smoothing_rows();

/// The row SMOOTHING of pairs and their defaults.
Row<PairSettings> smoothing_row();

}  // namespace contactsim
