// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"
#include "parser/binding/table.hpp"

namespace contactsim {

/// BEGIN SOLVER, BEGIN ADAPTIVE TIME STEPPING and BEGIN IMPLICIT DYNAMICS of a region.
/// Source: Sierra/SM 5.22, chapter 4.
std::vector<Row<Region>> implicit_region_rows();

/// The linear equation solvers at Sierra scope, which are read and have no effect.
std::vector<Row<SimulationDefinition>> implicit_sierra_rows();

}  // namespace contactsim
