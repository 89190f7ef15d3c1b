// SPDX-License-Identifier: BSD-3-Clause
// Steps in which elements die, and those after deaths.
#include <algorithm>

#include "core/statics/load_steps.hpp"

namespace contactsim {

namespace {

/// [n_elements] 0 of dead elements; empty where none is dead.
std::vector<std::uint8_t> find_living(const Model& model, const State& state) {
  std::vector<std::uint8_t> alive(model.mesh->n_elements(), 1);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const ModelBlock& block = model.blocks[b];
    for (std::size_t e = 0; e < block.n_elements; ++e) {
      if (state.blocks[b].life_of(e) == 0.0) alive[block.first_element.value + e] = 0;
    }
  }
  if (std::ranges::find(alive, 0) == alive.end()) alive.clear();
  return alive;
}

/// Nodes that have dead elements and no living one, ascending.
std::vector<NodeIndex> nodes_of_dead_alone(const Mesh& mesh, std::span<const std::uint8_t> alive) {
  constexpr std::uint8_t dead = 1, living = 2;
  std::vector<std::uint8_t> kinds(mesh.n_nodes(), 0);
  for (std::uint32_t element = 0; element < alive.size(); ++element) {
    for (const NodeIndex node : mesh.element_nodes(ElementIndex{element}))
      kinds[node.value] |= alive[element] != 0 ? living : dead;
  }
  std::vector<NodeIndex> nodes;
  for (std::uint32_t node = 0; node < kinds.size(); ++node) {
    if (kinds[node] == dead) nodes.push_back({node});
  }
  return nodes;
}

/// Who lives, fades and is dead in a state.
class Lives {
 public:
  explicit Lives(const State& state) : death_(state.death) {
    for (const ModelBlockState& block : state.blocks) life_.push_back(block.life);
  }
  void bring_back(State& state) const {
    state.death = death_;
    for (std::size_t b = 0; b < life_.size(); ++b) state.blocks[b].life = life_[b];
  }

 private:
  DeathState death_;
  std::vector<std::vector<Lanes>> life_;  // [n_blocks]
};

}  // namespace

/// Finds what deaths have left to join nodes. Returns the nodes without any of it.
std::vector<NodeIndex> LoadSteps::find_lifeless() {
  const std::vector<std::uint8_t> alive = find_living(model_, state_);
  living_graph_.reset();
  if (alive.empty()) return {};
  living_graph_.emplace(model_.mesh->n_nodes(), *model_.mesh, model_.blocks, problem_.bodies().size(), alive);
  return nodes_of_dead_alone(*model_.mesh, alive);
}

void LoadSteps::note_deaths() { problem_.note_deaths(find_lifeless()); }

/// Has elements die in the equilibrium that was found. Returns whether the step is to be made anew: its start
/// is there again then, without the dead. Source: Sierra/SM 5.26, 4.7, Control Failure.
///   n_rounds  that the step was made anew before
bool LoadSteps::has_deaths(std::int64_t n_rounds) {
  if (deaths_ == nullptr || !settings_.control_failure) return false;
  const std::int64_t most =
      settings_during(*settings_.control_failure, schedule_.period_name(step_begun_)).max_iterations;
  report_.has_deaths_left = most > 0 && n_rounds >= most;
  if (n_rounds >= most) return false;
  const Lives lives(state_);
  ++state_.step;  // criteria count steps that have been made
  const bool has_any = deaths_->look(state_, n_rounds > 0);
  --state_.step;
  if (!has_any) return false;
  problem_.restore();
  if (!before_deaths_) {
    before_deaths_ = {state_, problem_.has_deaths()};
    lives.bring_back(before_deaths_->state);
    deaths_->keep(before_deaths_->state);
  }
  deaths_->follow(state_);
  note_deaths();
  ++report_.n_again;
  return true;
}

/// Brings back the start of the step as it was before elements died in it.
void LoadSteps::undo_deaths() {
  if (!before_deaths_) return;
  state_ = before_deaths_->state;
  deaths_->restore(state_);
  problem_.undo_deaths(find_lifeless(), before_deaths_->has_deaths);
  before_deaths_.reset();
  report_.n_again = 0;
}

}  // namespace contactsim
