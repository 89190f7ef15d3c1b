// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/reports/death_report.hpp"
#include "app/run/run_contact.hpp"
#include "core/conditions/external_force.hpp"
#include "core/death/element_deaths.hpp"

namespace contactsim {

/// What element death takes things from.
struct DeathParts {
  ExternalForce& external;  ///< loses the faces of the dead
  RunContact* contact;      ///< follows the deaths; null without contact
  Log& log;
};

/// All that a run has because its region has ELEMENT DEATH blocks.
class RunDeath {
 public:
  /// All must outlive this. Errors: as ElementDeaths.
  ///   sets  of find_death_sets
  RunDeath(const ConditionScope& scope, std::span<const std::vector<ElementIndex>> sets,
           const OutputVariables& variables, const DeathParts& parts);

  /// Gives the state room for deaths; takes over those that it has.
  void begin(State& state);
  /// To be called once for the state of the start and that after every step: who has died is taken out of
  /// loads and contact, and the log reports them when it is due.
  void step(State& state);
  /// What is left to report at the end, and how many died.
  std::string report(const State& state);
  /// Time that all this has taken, of the clock.
  double seconds() const { return seconds_; }

 private:
  void update_for_deaths(const State& state, std::span<const ElementIndex> dead);
  bool is_report_due(const State& state) const;
  std::string take_report(const State& state);

  std::span<const ElementDeath> definitions_;
  DeathParts parts_;
  const Mesh& mesh_;
  NodeElements node_elements_;
  FaceGroups faces_;
  ElementDeaths deaths_;
  DeathLog detail_ = DeathLog::minimal;
  DeathTally tally_;
  double reported_at_;  // when the log reported deaths last [time]
  std::size_t n_may_die_ = 0;
  double seconds_ = 0.0;
};

}  // namespace contactsim
