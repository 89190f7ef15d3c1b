// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/simulation.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// DEFINE POINT, DIRECTION, AXIS and COORDINATE SYSTEM.
std::vector<Row<SimulationDefinition>> geometry_rows();

}  // namespace contactsim
