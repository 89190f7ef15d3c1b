// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "app/run/run_input.hpp"
#include "core/conditions/external_force.hpp"
#include "core/dynamics/initial_state.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state_transfer.hpp"
#include "core/dynamics/time_step.hpp"
#include "core/statics/load_schedule.hpp"

namespace contactsim {

/// A region, ready to be moved.
struct Setup {
  Model model;
  ExternalForce external;
  InitialState initial;
  TimeStepControl control;
  std::optional<LoadSchedule> load_schedule;          ///< of implicit procedures
  std::vector<std::vector<ElementIndex>> death_sets;  ///< as Region::element_deaths
  std::optional<StateTransfer> transfer;              ///< from the procedure before
};

/// Makes elements, conditions, loads and periods of a region. Wrong ones are errors.
Setup set_up(const RunInput& input, Diagnostics& diagnostics);

}  // namespace contactsim
