// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_death.hpp"

#include <algorithm>
#include <utility>

#include "app/run/timed_force.hpp"
#include "contact/mesh/degenerate_faces.hpp"
#include "core/definition/region.hpp"

namespace contactsim {

namespace {

/// [n_elements] 1 of elements that NODAL EROSION = ON is for.
std::vector<std::uint8_t> find_eroding(const ConditionScope& scope,
                                       std::span<const std::vector<ElementIndex>> sets) {
  std::vector<std::uint8_t> erodes(scope.mesh.n_elements(), 0);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (!scope.region.element_deaths[i].erodes_nodes) continue;
    for (const ElementIndex element : sets[i]) erodes[element.value] = 1;
  }
  return erodes;
}

std::size_t count_members(const Mesh& mesh, std::span<const std::vector<ElementIndex>> sets) {
  std::vector<std::uint8_t> is_member(mesh.n_elements(), 0);
  for (const auto& set : sets) {
    for (const ElementIndex element : set) is_member[element.value] = 1;
  }
  return static_cast<std::size_t>(std::ranges::count(is_member, 1));
}

void add(const SurfaceChanges& changes, SurfaceChanges& sums) {
  sums.resize(changes.size());
  for (const SurfaceIndex i : indices(changes)) {
    sums[i].faces_gained += changes[i].faces_gained;
    sums[i].faces_lost += changes[i].faces_lost;
    sums[i].lofted_lost += changes[i].lofted_lost;
    sums[i].nodes_gained += changes[i].nodes_gained;
    sums[i].nodes_lost += changes[i].nodes_lost;
  }
}

}  // namespace

RunDeath::RunDeath(const ConditionScope& scope, std::span<const std::vector<ElementIndex>> sets,
                   const OutputVariables& variables, const DeathParts& parts)
    : definitions_(scope.region.element_deaths),
      parts_(parts),
      mesh_(scope.mesh),
      node_elements_(scope.mesh),
      faces_(scope.mesh, node_elements_),
      deaths_(scope, sets, variables, faces_),
      reported_at_(scope.start_time()),
      n_may_die_(count_members(scope.mesh, sets)) {
  for (const ElementDeath& death : definitions_) detail_ = std::max(detail_, death.log);
  const bool makes_new_edges = std::ranges::all_of(definitions_, &ElementDeath::makes_new_edges);
  if (parts_.contact != nullptr)
    parts_.contact->follow_deaths(faces_, find_eroding(scope, sets), makes_new_edges);
}

void RunDeath::begin(State& state) {
  deaths_.begin(state);
  std::vector<ElementIndex> dead;
  for (std::uint32_t i = 0; i < mesh_.n_elements(); ++i) {
    if (deaths_.alive()[i] == 0) dead.push_back({i});
  }
  if (!dead.empty()) update_for_deaths(state, dead);
}

void RunDeath::update_for_deaths(const State& state, std::span<const ElementIndex> dead) {
  parts_.external.take_off(deaths_.alive());
  if (parts_.contact == nullptr) return;
  add(parts_.contact->update_for_deaths(state, dead, deaths_.alive()), tally_.changes);
  tally_.n_free = parts_.contact->n_eroded_nodes();
}

/// Returns whether elements have died or faded; the dead are in dead_.
bool RunDeath::let_die(State& state, DeathRound round) {
  std::vector<ElementIndex> ill_defined;
  if (parts_.contact != nullptr && deaths_.asks_for_ill_defined(state, round))
    ill_defined = find_degenerate_faces(parts_.contact->force().contact_mesh(), state.coordinates);
  const auto dead = deaths_.step(state, ill_defined, round);
  dead_.assign(dead.begin(), dead.end());
  return !dead_.empty() || !state.death.dying.empty();
}

void RunDeath::share_among(const RankShare& share, std::function<void()> complete_state) {
  deaths_.share_among(share);
  complete_state_ = std::move(complete_state);
}

bool RunDeath::step(State& state) {
  const double begun = clock_seconds();
  if (deaths_.reads_all(state)) complete_state_();
  const bool has_any = let_die(state, {});
  follow(state);
  kept_.reset();
  seconds_ += clock_seconds() - begun;
  return has_any;
}

bool RunDeath::look(State& state, bool repeats) {
  return let_die(state, {.repeats = repeats, .takes_worst = true});
}

void RunDeath::keep(const State& state) {
  kept_.emplace(Kept{parts_.external, tally_, {}});
  if (parts_.contact != nullptr) kept_->contact.emplace(parts_.contact->checkpoint(state));
}

void RunDeath::follow(const State& state) {
  tally_.n_died += dead_.size();
  tally_.n_dead = deaths_.n_dead();
  tally_.n_dying = state.death.dying.size();
  if (!dead_.empty()) update_for_deaths(state, dead_);
}

void RunDeath::restore(State& state) {
  deaths_.begin(state);
  parts_.external = kept_->external;
  tally_ = kept_->tally;
  if (kept_->contact) parts_.contact->restore(state, *kept_->contact);
}

/// The shortest interval of all blocks counts; without any every step does.
bool RunDeath::is_report_due(const State& state) const {
  if (tally_.n_died == 0) return false;
  bool has_interval = false, is_due = false;
  for (const ElementDeath& death : definitions_) {
    has_interval |= death.summary_step_interval.has_value() || death.summary_time_interval.has_value();
    if (death.summary_step_interval) is_due |= state.step % *death.summary_step_interval == 0;
    if (death.summary_time_interval) is_due |= state.time - reported_at_ >= *death.summary_time_interval;
  }
  return is_due || !has_interval;
}

void RunDeath::begin_tally(const State& state) {
  reported_at_ = state.time;
  tally_.n_died = 0;
  std::ranges::fill(tally_.changes, SurfaceChange{});
}

}  // namespace contactsim
