// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "parser/commands/block_rows.hpp"

namespace contactsim {

/// The lines inside implicit-only blocks, for `explain`; none of them is read.
const TableText& solver_text();
const TableText& adaptive_time_stepping_text();
const TableText& implicit_dynamics_text();
const TableText& equation_solver_text();

/// The implicit-only blocks of a region.
template <class Region>
std::vector<Row<Region>> implicit_region_rows() {
  return {
      ignored_block<Region>("solver", solver_text, "implicit only: how equilibrium is found"),
      ignored_block<Region>("adaptive time stepping", adaptive_time_stepping_text,
                            "implicit only: how the time step adapts"),
      ignored_block<Region>("implicit dynamics", implicit_dynamics_text, "implicit only: inertia terms"),
  };
}

/// The implicit-only blocks at Sierra scope.
template <class Simulation>
std::vector<Row<Simulation>> implicit_sierra_rows() {
  constexpr const char* help = "implicit only: linear equation solver";
  return {
      ignored_block<Simulation>("feti equation solver", equation_solver_text, help),
      ignored_block<Simulation>("gdsw equation solver", equation_solver_text, help),
      ignored_block<Simulation>("tpetra equation solver", equation_solver_text, help),
  };
}

}  // namespace contactsim
