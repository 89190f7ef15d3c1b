// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "core/definition/death.hpp"
#include "core/definition/entity_set.hpp"

namespace contactsim {

/// BEGIN MASS PROPERTIES: mass, centre and inertia of the set are reported. The set may name nothing: the
/// whole model.
struct MassProperties {
  DeckName name;
  EntitySet set;
  std::string structure_name;  ///< what the report calls it; "": the block's name
};

/// BEGIN SPOT WELD <name>: springs between nodes and the faces nearest to them; fails as a SPRING WELD MODEL
/// does.
struct SpotWeld {
  DeckName name;
  std::vector<DeckName> node_sets, side_sets;
  ScaledFunction normal, tangential;  ///< displacement [length] to force [force]
  double envelope_exponent = 2.0;     ///< > 0 [1]
  std::int64_t decay_cycles = 1;      ///< steps over which the force at failure fades, >= 1
  std::optional<DeckName> failure_function;
  bool ignores_initial_offsets = false;  ///< the gap at the start counts as zero displacement
};

/// BEGIN MASS SCALING: mass is added to the set's nodes until the critical step reaches the target.
struct MassScaling {
  DeckName name;
  EntitySet set;
  std::optional<double> target_time_step;         ///< > 0 [time]
  std::optional<double> allowable_mass_increase;  ///< most times that an element may become as heavy, > 0 [1]
};

/// TERMINATE {GLOBAL|NODAL|ELEMENT} [{AVG|MAX|MIN}] <variable> <op> <value>: the run stops when it holds.
struct TerminationCriterion {
  VariableLocation location = VariableLocation::global;
  std::optional<NodalCriterion::Reduction> reduction;  ///< over the entities; absent: any one of them
  VariableTest test;
};

/// SKIP TIMES = <from> TO <to>: the criteria are not looked at in between.
struct TimeRange {
  double from = 0.0, to = 0.0;  ///< from <= to [time]
};

/// BEGIN SOLUTION TERMINATION.
struct SolutionTermination {
  enum class Scope : std::uint8_t { entire_run, procedure };

  DeckName name;
  std::vector<TerminationCriterion> criteria;  ///< any one ends the run
  std::vector<TimeRange> skipped_times;
  Scope scope = Scope::entire_run;
};

}  // namespace contactsim
