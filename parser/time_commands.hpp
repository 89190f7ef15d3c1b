// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/time_control.hpp"
#include "core/diagnostics.hpp"
#include "parser/rows.hpp"

namespace contactsim {

/// BEGIN TIME CONTROL.
const Table<TimeControl>& time_control_table();

/// What is missing or out of order in a time control: start and termination times, blocks.
void check_time_control(const TimeControl& control, Diagnostics& diagnostics);

/// The blocks of a region that choose how its time step is found; none of them is bound.
template <class Region>
std::vector<Row<Region>> time_step_rows() {
  constexpr const char* by_element = "the time step is the smallest that any element asks for";
  return {
      ignored_block<Region>("node based time step parameters", by_element),
      ignored_block<Region>("lanczos parameters", by_element),
      ignored_block<Region>("power method parameters", by_element),
      refused_block<Region>("mass scaling", "raise the density of the material that limits the time step"),
  };
}

}  // namespace contactsim
