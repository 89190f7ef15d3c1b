// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/simulation.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN SIERRA.
const Table<SimulationDefinition>& sierra_table();

/// The definitions at Sierra scope that contact may need: geometry, functions, materials, sections, rigid
/// bodies, finite element models, output schedulers. A deck of contact alone takes them too.
std::vector<Row<SimulationDefinition>> definition_rows();

}  // namespace contactsim
