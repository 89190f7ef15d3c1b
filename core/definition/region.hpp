// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/definition/condition.hpp"
#include "core/definition/condition_initial.hpp"
#include "core/definition/condition_loads.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/death.hpp"
#include "core/definition/output.hpp"
#include "core/definition/output_user.hpp"
#include "core/definition/region_parts.hpp"
#include "core/definition/solver.hpp"

namespace contactsim {

/// BEGIN {PRESTO | ADAGIO | SOLID MECHANICS} REGION <name> ... END: one model, what acts on it, what is
/// written. Lists are in deck order.
struct Region {
  DeckName name;
  std::optional<DeckName> finite_element_model;  ///< USE FINITE ELEMENT MODEL

  std::vector<FixedCondition> fixed_conditions;
  std::vector<PrescribedCondition> prescribed_conditions;
  std::vector<NodalLoad> nodal_loads;
  std::vector<Pressure> pressures;
  std::vector<Traction> tractions;
  std::vector<Gravity> gravities;
  std::vector<ViscousDamping> viscous_dampings;
  std::vector<InitialVelocity> initial_velocities;
  std::vector<InitialCondition> initial_conditions;

  std::vector<AnalyticPlane> analytic_planes;
  std::optional<ContactDefinition> contact;

  std::vector<ElementDeath> element_deaths;
  std::vector<SolutionTermination> terminations;
  std::vector<MassProperties> mass_properties;
  std::vector<SpotWeld> spot_welds;
  std::vector<MassScaling> mass_scalings;
  std::vector<DeckName> subcycle_blocks;  ///< SUBCYCLE BLOCKS: of small elements, or ALL; empty: nothing is

  std::optional<SolverSettings> solver;                        ///< of implicit procedures
  std::optional<AdaptiveTimeStepping> adaptive_time_stepping;  ///< of implicit procedures

  std::vector<ResultsOutput> results_outputs;
  std::vector<HistoryOutput> history_outputs;
  std::vector<HeartbeatOutput> heartbeat_outputs;
  std::vector<RestartData> restart_data;
  std::vector<UserOutput> user_outputs;
  std::vector<UserVariable> user_variables;
};

}  // namespace contactsim
