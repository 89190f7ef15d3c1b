// SPDX-License-Identifier: BSD-3-Clause
#include "core/death/element_deaths.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/death/death_sets.hpp"
#include "core/definition/region.hpp"

namespace contactsim {

ElementDeaths::ElementDeaths(const ConditionScope& scope, std::span<const std::vector<ElementIndex>> sets,
                             const OutputVariables& variables, const FaceGroups& faces)
    : deaths_(scope.region.element_deaths),
      sets_(sets),
      model_(variables.model()),
      faces_(faces),
      alive_(scope.mesh.n_elements(), 1),
      marks_(scope.mesh.n_elements(), 0) {
  for (std::size_t i = 0; i < deaths_.size(); ++i) {
    criteria_.emplace_back(deaths_[i], sets_[i], variables, scope.diagnostics);
    if (!deaths_[i].cleans_contact_aggressively) continue;
    is_cleaned_.resize(scope.mesh.n_elements(), 0);
    for (const ElementIndex element : sets_[i]) is_cleaned_[element.value] = 1;
  }
}

void ElementDeaths::share_among(const RankShare& share) {
  share_ = &share;
  own_.resize(sets_.size());
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    std::ranges::copy_if(sets_[i], std::back_inserter(own_[i]),
                         [&](ElementIndex element) { return share.has_element(element); });
    criteria_[i].look_at(own_[i]);
  }
}

bool ElementDeaths::reads_all(const State& state) const {
  for (std::size_t i = 0; i < deaths_.size(); ++i) {
    if (criteria_[i].reads_all() && is_due(i, state, false)) return true;
  }
  return false;
}

void ElementDeaths::begin(State& state) {
  state.death.checked.resize(deaths_.size(), -std::numeric_limits<double>::infinity());
  for (const auto& set : sets_) {
    for (const ElementIndex element : set) {
      const std::size_t b = find_model_block(model_, element);
      const ModelBlock& block = model_.blocks[b];
      std::vector<Lanes>& life = state.blocks[b].life;
      if (!life.empty()) continue;
      life.resize(block.n_batches(), Lanes::Constant(1.0));
      const std::size_t n_used = block.n_elements - (block.n_batches() - 1) * n_lanes;
      life.back() = first_lanes(n_used).select(life.back(), 0.0);
    }
  }
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    const ModelBlock& block = model_.blocks[b];
    for (std::size_t e = 0; e < block.n_elements; ++e) {
      alive_[block.first_element.value + e] = state.blocks[b].life_of(e) == 0.0 ? 0 : 1;
    }
  }
  n_dead_ = static_cast<std::size_t>(std::ranges::count(alive_, 0));
}

double& ElementDeaths::life_of(ElementIndex element, State& state) const {
  const std::size_t b = find_model_block(model_, element);
  const std::size_t e = element.value - model_.blocks[b].first_element.value;
  return state.blocks[b].life[e / n_lanes](static_cast<Eigen::Index>(e % n_lanes));
}

void ElementDeaths::begin_to_die(ElementIndex element, std::int64_t n_steps, State& state) {
  double& life = life_of(element, state);
  if (life < 1.0) return;
  life = static_cast<double>(n_steps - 1) / static_cast<double>(n_steps);
  if (n_steps > 1) {
    state.death.dying.push_back({element, n_steps, n_steps - 1});
  } else {
    dead_.push_back(element);
  }
}

void ElementDeaths::degrade(State& state) {
  for (DyingElement& dying : state.death.dying) {
    double& life = life_of(dying.element, state);
    if (life == 0.0) {
      dying.n_left = 0;  // it has turned inside out
      continue;
    }
    --dying.n_left;
    life = static_cast<double>(dying.n_left) / static_cast<double>(dying.n_steps);
    if (dying.n_left == 0) dead_.push_back(dying.element);
  }
  std::erase_if(state.death.dying, [](const DyingElement& dying) { return dying.n_left == 0; });
}

bool ElementDeaths::is_due(std::size_t death, const State& state, bool repeats) const {
  if (repeats) return state.death.checked[death] == state.time;
  const ElementDeath& of = deaths_[death];
  constexpr double round_off = 1e-9;  // of an interval, far above what adding up steps loses
  if (of.start_time && state.time < *of.start_time) return false;
  if (state.step % of.check_step_interval != 0) return false;
  if (!of.check_time_interval) return true;
  return state.time - state.death.checked[death] >= (1.0 - round_off) * *of.check_time_interval;
}

bool ElementDeaths::asks_for_ill_defined(const State& state, DeathRound round) const {
  for (std::size_t i = 0; i < deaths_.size(); ++i) {
    if (deaths_[i].on_ill_defined_contact && is_due(i, state, round.repeats)) return true;
  }
  return false;
}

void ElementDeaths::check(std::size_t death, State& state, std::span<const ElementIndex> ill_defined) {
  state.death.checked[death] = state.time;
  criteria_[death].mark({model_, state}, marks_);
  if (share_ != nullptr) mark_those_of_all(death);
  end_check(death, state, ill_defined);
}

/// What any rank has marked of its own elements is marked on all.
void ElementDeaths::mark_those_of_all(std::size_t death) {
  std::vector<ElementIndex> marked;
  std::ranges::copy_if(own_[death], std::back_inserter(marked),
                       [this](ElementIndex element) { return marks_[element.value] != 0; });
  for (const ElementIndex element : share_->join(marked)) marks_[element.value] = 1;
}

/// As check() of all blocks that are due.
void ElementDeaths::check_for_worst(State& state, std::span<const ElementIndex> ill_defined, bool repeats) {
  std::vector<std::uint8_t> may_die = alive_;
  for (const DyingElement& dying : state.death.dying) may_die[dying.element.value] = 0;
  for (const ElementIndex dead : dead_) may_die[dead.value] = 0;
  WorstElement worst;
  std::int64_t n_steps = 1;
  for (std::size_t i = 0; i < deaths_.size(); ++i) {
    if (!is_due(i, state, repeats)) continue;
    state.death.checked[i] = state.time;
    const double before = worst.value;
    criteria_[i].mark_worst({model_, state}, may_die, marks_, worst);
    if (worst.value != before) n_steps = deaths_[i].death_steps;
    end_check(i, state, ill_defined);
  }
  if (worst.element) begin_to_die(*worst.element, n_steps, state);
}

/// Has the marked elements of a block begin to die, and those of ill defined contact.
void ElementDeaths::end_check(std::size_t death, State& state, std::span<const ElementIndex> ill_defined) {
  const std::int64_t n_steps = deaths_[death].death_steps;
  if (deaths_[death].on_ill_defined_contact) {
    for (const ElementIndex element : ill_defined) marks_[element.value] = 1;
  }
  for (const ElementIndex element : sets_[death]) {
    if (marks_[element.value] != 0) begin_to_die(element, n_steps, state);
    marks_[element.value] = 0;
  }
  for (const ElementIndex element : ill_defined) marks_[element.value] = 0;
}

/// The kernels let them die in the middle of a step.
void ElementDeaths::find_inverted(State& state) {
  std::vector<ElementIndex> inverted;
  bool may_be_any = false;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    const ModelBlock& block = model_.blocks[b];
    if (block.dies_inverted.empty()) continue;
    may_be_any = true;
    for (std::size_t batch = 0; batch < block.n_batches(); ++batch) {
      if (!(state.blocks[b].life[batch] == 0.0).any()) continue;
      const std::size_t end = std::min((batch + 1) * n_lanes, block.n_elements);
      for (std::size_t e = batch * n_lanes; e < end; ++e) {
        const ElementIndex element{block.first_element.value + static_cast<std::uint32_t>(e)};
        if (state.blocks[b].life_of(e) == 0.0 && alive_[element.value] != 0) inverted.push_back(element);
      }
    }
  }
  if (share_ != nullptr && may_be_any) inverted = share_->join(inverted);
  for (const ElementIndex element : inverted) {
    life_of(element, state) = 0.0;
    dead_.push_back(element);
  }
}

bool ElementDeaths::hangs_by_a_face(ElementIndex element) const {
  std::vector<ElementSide> own, group;
  faces_.find_faces(element, own);
  return std::ranges::any_of(own, [&](ElementSide face) {
    faces_.find_group(face, group);
    return std::ranges::any_of(group, [&](ElementSide other) {
      return other.element() != element && alive_[other.element().value] != 0;
    });
  });
}

/// Solids that shared a face with what has died and share none any more.
void ElementDeaths::clean_up(State& state) {
  std::vector<ElementSide> own, group;
  for (std::size_t i = 0; i < dead_.size(); ++i) {
    faces_.find_faces(dead_[i], own);
    for (const ElementSide face : own) {
      faces_.find_group(face, group);
      for (const ElementSide other : group) {
        const ElementIndex element = other.element();
        if (alive_[element.value] == 0 || is_cleaned_[element.value] == 0 || hangs_by_a_face(element))
          continue;
        life_of(element, state) = 0.0;
        alive_[element.value] = 0;
        dead_.push_back(element);
      }
    }
  }
}

std::span<const ElementIndex> ElementDeaths::step(State& state, std::span<const ElementIndex> ill_defined,
                                                  DeathRound round) {
  dead_.clear();
  degrade(state);
  find_inverted(state);
  if (round.takes_worst) check_for_worst(state, ill_defined, round.repeats);
  for (std::size_t i = 0; i < deaths_.size() && !round.takes_worst; ++i) {
    if (is_due(i, state, round.repeats)) check(i, state, ill_defined);
  }
  std::ranges::sort(dead_);
  dead_.erase(std::unique(dead_.begin(), dead_.end()), dead_.end());
  for (const ElementIndex element : dead_) alive_[element.value] = 0;
  if (!is_cleaned_.empty()) clean_up(state);
  std::ranges::sort(dead_);
  n_dead_ += dead_.size();
  return dead_;
}

}  // namespace contactsim
