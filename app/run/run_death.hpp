// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/run/run_contact.hpp"
#include "core/conditions/external_force.hpp"
#include "core/death/element_deaths.hpp"
#include "core/definition/death.hpp"
#include "core/statics/static_deaths.hpp"

namespace contactsim {

/// What element death takes things from.
struct DeathParts {
  ExternalForce& external;  ///< loses the faces of the dead
  RunContact* contact;      ///< follows the deaths; null without contact
};

/// What has died since the last report.
struct DeathTally {
  std::size_t n_died = 0;   ///< elements
  std::size_t n_dead = 0;   ///< elements since the start
  std::size_t n_dying = 0;  ///< elements whose stress fades
  std::size_t n_free = 0;   ///< nodes in contact whose elements are all dead
  SurfaceChanges changes;   ///< summed; empty without contact
};

/// All that a run has because its region has ELEMENT DEATH blocks.
class RunDeath final : public StaticDeaths {
 public:
  /// All must outlive this. Errors: as ElementDeaths.
  ///   sets  of find_death_sets
  RunDeath(const ConditionScope& scope, std::span<const std::vector<ElementIndex>> sets,
           const OutputVariables& variables, const DeathParts& parts);

  /// Gives the state room for deaths; takes over those that it has.
  void begin(State& state);
  /// Has ranks look at the elements that they advance.
  ///   share           must outlive it
  ///   complete_state  called before something reads more than a rank knows
  void share_among(const RankShare& share, std::function<void()> complete_state);
  /// To be called once for the state of the start and that after every step: who has died is taken out of
  /// loads and contact. Returns whether elements have died or faded.
  bool step(State& state);
  bool look(State& state, bool repeats) override;
  void keep(const State& state) override;
  void follow(const State& state) override;
  void restore(State& state) override;

  /// Whether elements have died that a report is due of; begin_tally() is to follow the report.
  bool is_report_due(const State& state) const;
  void begin_tally(const State& state);
  const DeathTally& tally() const { return tally_; }
  /// How much the deck wants to know.
  DeathLog detail() const { return detail_; }
  std::size_t n_may_die() const { return n_may_die_; }
  /// Time that all this has taken, of the clock.
  double seconds() const { return seconds_; }

 private:
  /// What follow() changes.
  struct Kept {
    ExternalForce external;
    DeathTally tally;
    std::optional<RunContactCheckpoint> contact;
  };
  bool let_die(State& state, DeathRound round);
  void update_for_deaths(const State& state, std::span<const ElementIndex> dead);

  std::span<const ElementDeath> definitions_;
  DeathParts parts_;
  const Mesh& mesh_;
  NodeElements node_elements_;
  FaceGroups faces_;
  ElementDeaths deaths_;
  DeathLog detail_ = DeathLog::minimal;
  std::vector<ElementIndex> dead_;  // that loads and contact do not know of yet
  DeathTally tally_;
  std::optional<Kept> kept_;  // of a load step in which elements die
  double reported_at_;        // when the log reported deaths last [time]
  std::size_t n_may_die_ = 0;
  std::function<void()> complete_state_ = [] {};
  double seconds_ = 0.0;
};

}  // namespace contactsim
