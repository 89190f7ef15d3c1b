// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/death/death_criteria.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/dynamics/state.hpp"
#include "core/mesh/face_groups.hpp"

namespace contactsim {

/// How a state is looked at.
struct DeathRound {
  /// It is another one at the time of the state before: criteria are due that were due there.
  bool repeats = false;
  /// Of the elements that fail by their material the worst one alone begins to die: as that relieves others,
  /// these may live on. Source: Sierra/SM 5.26, 4.7, Control Failure.
  bool takes_worst = false;
};

/// The ELEMENT DEATH blocks of a region in a run: who begins to die, who is dead. A dead element has no
/// stress, sets no limit to the step and keeps its mass at its nodes; what it stored stays in the internal
/// energy. Once it has begun to die an element goes on. Source: Sierra/SM 5.20, element death.
class ElementDeaths {
 public:
  /// Errors: as DeathCriteria. All must outlive it.
  ///   sets  of find_death_sets
  ElementDeaths(const ConditionScope& scope, std::span<const std::vector<ElementIndex>> sets,
                const OutputVariables& variables, const FaceGroups& faces);

  /// Has ranks look at the elements that they advance, and tell each other who dies.
  ///   share  must outlive it
  void share_among(const RankShare& share);
  /// Whether step() reads more of a state than a rank knows of its own elements.
  bool reads_all(const State& state) const;

  /// Gives a state room for deaths. One that has it already, of a restart or an earlier one of the run, is
  /// taken as it is.
  void begin(State& state);

  /// Ends a step: what is degraded is degraded further, criteria are looked at when they are due. To be
  /// called once for the state of the start and that after every step.
  ///   ill_defined  elements whose contact faces have lost their shape
  /// Returns the elements that are dead from now on, ascending; good until the next call.
  std::span<const ElementIndex> step(State& state, std::span<const ElementIndex> ill_defined,
                                     DeathRound round = {});

  /// Whether step() would look at `ill_defined`.
  bool asks_for_ill_defined(const State& state, DeathRound round = {}) const;

  /// [n_elements] 0 of dead elements, else 1
  std::span<const std::uint8_t> alive() const { return alive_; }
  std::size_t n_dead() const { return n_dead_; }

 private:
  void degrade(State& state);
  bool is_due(std::size_t death, const State& state, bool repeats) const;
  void check(std::size_t death, State& state, std::span<const ElementIndex> ill_defined);
  void check_for_worst(State& state, std::span<const ElementIndex> ill_defined, bool repeats);
  void end_check(std::size_t death, State& state, std::span<const ElementIndex> ill_defined);
  void begin_to_die(ElementIndex element, std::int64_t n_steps, State& state);
  double& life_of(ElementIndex element, State& state) const;
  void find_inverted(State& state);
  void mark_those_of_all(std::size_t death);
  void clean_up(State& state);
  bool hangs_by_a_face(ElementIndex element) const;

  std::span<const ElementDeath> deaths_;
  std::span<const std::vector<ElementIndex>> sets_;
  const Model& model_;
  const FaceGroups& faces_;
  const RankShare* share_ = nullptr;            // of several ranks
  std::vector<std::vector<ElementIndex>> own_;  // [n_deaths] of the sets, those of this rank
  std::vector<DeathCriteria> criteria_;         // [n_deaths]
  std::vector<std::uint8_t> alive_;             // [n_elements]
  std::vector<std::uint8_t> is_cleaned_;  // [n_elements] of sets with AGGRESSIVE CONTACT CLEANUP, else empty
  std::vector<std::uint8_t> marks_;       // scratch, [n_elements]
  std::vector<ElementIndex> dead_;        // of this step
  std::size_t n_dead_ = 0;
};

}  // namespace contactsim
