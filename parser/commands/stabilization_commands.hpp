// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/interaction.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// What resists the motion of sides that do not touch yet, in load steps.
std::vector<Row<StabilizationSettings>> stabilization_rows();

}  // namespace contactsim
