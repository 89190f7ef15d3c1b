// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/subcycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/names.hpp"
#include "core/base/pluralize.hpp"
#include "core/conditions/entity_elements.hpp"
#include "core/definition/region.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/scaled_block.hpp"

namespace contactsim {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool has_stress(const ModelBlock& block) { return block.element->has_material() && !block.is_rigid; }

ElementIndex element_of(const ModelBlock& block, std::size_t i) {
  return {block.first_element.value + static_cast<std::uint32_t>(i)};
}

}  // namespace

double Subcycles::saving() const {
  const auto large = static_cast<double>(n_others), small = static_cast<double>(n_elements);
  const auto parts = static_cast<double>(n_parts);
  return parts * (large + small) / (large + parts * small);
}

SubcycledSet::SubcycledSet(const Model& model, std::span<const double> steps, double large_step)
    : model_(model) {
  const double bound = (1.0 - round_off) * large_step;
  std::vector<std::uint8_t> is_near(model.mesh->n_nodes(), 0);  // node by node
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    if (!(steps[i] < bound)) continue;
    for (const NodeIndex node : model.mesh->element_nodes(ElementIndex{i})) is_near[node.value] = 1;
  }
  for (int layer = 1; layer < n_layers; ++layer) add_layer(is_near);
  for (const ModelBlock& block : model.blocks) {
    std::vector<std::uint8_t>& batches = batches_.emplace_back(block.n_batches(), 0);
    if (!has_stress(block)) continue;
    for (std::size_t i = 0; i < block.n_elements; ++i) {
      const auto nodes = model.mesh->element_nodes(element_of(block, i));
      if (std::ranges::any_of(nodes, [&](NodeIndex node) { return is_near[node.value] != 0; }))
        batches[i / n_lanes] = 1;
    }
  }
  sum(steps);
}

/// Takes in the nodes of the elements that have one already.
void SubcycledSet::add_layer(std::vector<std::uint8_t>& is_near) const {
  const std::vector<std::uint8_t> before = is_near;
  for (const ModelBlock& block : model_.blocks) {
    if (!has_stress(block)) continue;
    for (std::size_t i = 0; i < block.n_elements; ++i) {
      const auto nodes = model_.mesh->element_nodes(element_of(block, i));
      if (std::ranges::none_of(nodes, [&](NodeIndex node) { return before[node.value] != 0; })) continue;
      for (const NodeIndex node : nodes) is_near[node.value] = 1;
    }
  }
}

void SubcycledSet::sum(std::span<const double> steps) {
  double small = infinity, large = infinity;
  std::vector<std::uint8_t> is_subcycled(model_.mesh->n_nodes(), 0);
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    const ModelBlock& block = model_.blocks[b];
    if (!has_stress(block)) continue;
    for (std::size_t i = 0; i < block.n_elements; ++i) {
      const ElementIndex element = element_of(block, i);
      const double step = steps[element.value];
      if (batches_[b][i / n_lanes] == 0) {
        ++sums_.n_others;
        large = std::min(large, step);
        continue;
      }
      ++sums_.n_elements;
      small = std::min(small, step);
      for (const NodeIndex node : model_.mesh->element_nodes(element)) is_subcycled[node.value] = 1;
    }
  }
  for (std::uint32_t i = 0; i < is_subcycled.size(); ++i) {
    if (is_subcycled[i] != 0) sums_.nodes.push_back({i});
  }
  if (std::isfinite(large) && std::isfinite(small))
    sums_.n_parts = static_cast<std::size_t>(std::max(1.0, std::ceil((1.0 - round_off) * large / small)));
}

namespace {

/// What the line of the deck wants of a mesh.
class Choice {
 public:
  Choice(const ConditionScope& scope, Model& model)
      : scope_(scope), model_(model), line_(scope.region.subcycle_blocks.front()) {}

  void apply() {
    if (!find_named()) return;
    find_steps_of_batches();
    const std::optional<SubcycledSet> set = takes_all_ ? find_best() : find_of_named();
    if (!set) return;
    refuse_neighbours(set->sums());
    model_.subcycles = set->sums();
    for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
      if (std::ranges::any_of(set->batches()[b], [](std::uint8_t is) { return is != 0; }))
        split_chunks(scope_.mesh, set->batches()[b], model_.blocks[b]);
    }
  }

 private:
  const ConditionScope& scope_;
  Model& model_;
  const DeckName& line_;
  bool takes_all_ = false;
  std::vector<std::uint8_t> is_named_;  // [n_elements of the mesh]
  std::vector<double> steps_;           // [n_elements of the mesh] of the batch, or the element's own

  void warn(std::string_view id, std::string text, std::string hint = "") const {
    scope_.diagnostics.add_warning(id, line_.location, std::move(text), std::move(hint),
                                   static_cast<int>(line_.text.size()));
  }

  bool find_named() {
    const auto& names = scope_.region.subcycle_blocks;
    takes_all_ = std::ranges::any_of(names, [](const DeckName& name) { return fold(name.text) == "all"; });
    is_named_.assign(scope_.mesh.n_elements(), 0);
    if (takes_all_) return true;
    const std::size_t n_errors = scope_.diagnostics.error_count();
    EntitySet set;
    set.blocks = names;
    for (const ElementIndex i : find_elements(set, {"SUBCYCLE BLOCKS", line_.location}, scope_))
      is_named_[i.value] = 1;
    return scope_.diagnostics.error_count() == n_errors;
  }

  void find_steps_of_batches() {
    steps_.assign(scope_.mesh.n_elements(), infinity);
    for (ModelBlock& block : model_.blocks) {
      if (!has_stress(block)) continue;
      ScaledBlock scaled(scope_.mesh, block);
      for (std::size_t batch = 0; batch < block.n_batches(); ++batch) {
        const double step = scaled.stable_step_of_batch(batch);
        for (std::size_t i = batch * n_lanes; i < std::min(block.n_elements, (batch + 1) * n_lanes); ++i)
          steps_[element_of(block, i).value] = step;
      }
    }
  }

  /// Puts each element's own step where that of its batch is below a bound.
  void refine_steps(double bound) {
    for (ModelBlock& block : model_.blocks) {
      if (!has_stress(block)) continue;
      ScaledBlock scaled(scope_.mesh, block);
      for (std::size_t i = 0; i < block.n_elements; ++i) {
        double& step = steps_[element_of(block, i).value];
        if (step < bound) step = scaled.stable_step(i);
      }
    }
  }

  std::optional<SubcycledSet> find_of_named() {
    double large = infinity;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (is_named_[i] == 0) large = std::min(large, steps_[i]);
    }
    if (std::isinf(large)) {
      scope_.diagnostics.add_error(
          line_.location, "SUBCYCLE BLOCKS names every block that has a stable step",
          "the least step of the others is the one that named blocks are subcycled in; SUBCYCLE BLOCKS = ALL "
          "chooses it from the sizes of all elements");
      return std::nullopt;
    }
    refine_steps(large);
    SubcycledSet set(model_, steps_, large);
    if (!is_worth_it(set)) return std::nullopt;
    constexpr double least = 1.1;
    if (set.sums().saving() < least) {
      warn("subcycling-idle",
           fmt::format("subcycling wins little: {} of {} elements are advanced in {} parts of each step, "
                       "{:.2f} times less work in all",
                       set.sums().n_elements, set.sums().n_elements + set.sums().n_others, set.sums().n_parts,
                       set.sums().saving()),
           "it pays where few elements are much smaller than all others");
    }
    return set;
  }

  bool is_worth_it(const SubcycledSet& set) const {
    const Subcycles& sums = set.sums();
    if (sums.n_elements > 0 && sums.n_others > 0 && sums.n_parts > 1) return true;
    warn("subcycling-idle",
         sums.n_others == 0
             ? "nothing is subcycled: no element is farther than three layers from the small ones"
             : "nothing is subcycled: no element of these blocks has a smaller stable step than all others");
    return false;
  }

  /// Of large steps between the least and the greatest that elements allow, the one by which the fewest
  /// elements are advanced.
  std::optional<SubcycledSet> find_best() {
    double least = infinity, greatest = 0.0;
    for (const double step : steps_) {
      if (std::isinf(step)) continue;
      least = std::min(least, step);
      greatest = std::max(greatest, step);
    }
    refine_steps(greatest);
    std::optional<SubcycledSet> best;
    constexpr double ratio = 1.2, least_saving = 1.1;
    for (double large = ratio * least; large <= greatest * (1.0 + SubcycledSet::round_off); large *= ratio) {
      SubcycledSet set(model_, steps_, large);
      if (set.sums().n_elements == 0 || set.sums().n_others == 0) continue;
      if (!(set.sums().saving() > (best ? best->sums().saving() : least_saving))) continue;
      best.emplace(std::move(set));
    }
    if (!best) {
      warn("subcycling-idle",
           fmt::format("nothing is subcycled: the stable steps of elements, {:.4g} to {:.4g}, leave nothing "
                       "to win",
                       least, greatest),
           "it pays where few elements are much smaller than all others");
    }
    return best;
  }

  /// What would have to move in parts of a step with the subcycled nodes.
  void refuse_neighbours(const Subcycles& set) const {
    std::vector<std::uint8_t> is_subcycled(scope_.mesh.n_nodes(), 0);
    for (const NodeIndex node : set.nodes) is_subcycled[node.value] = 1;
    for (const NodeIndex node : set.nodes) {
      if (model_.rigid.nodes.is_free(node)) continue;
      refuse(fmt::format("node {} is of the rigid body '{}' and of subcycled elements",
                         scope_.mesh.node_id(node),
                         model_.rigid.nodes.names[*model_.rigid.nodes.body_of[node.value]]));
      break;
    }
    for (const ModelBlock& block : model_.blocks) {
      const StepRule rule = block.element->step_rule;
      if (block.is_rigid || (rule != StepRule::stiffness && rule != StepRule::damping)) continue;
      for (std::size_t i = 0; i < block.n_elements; ++i) {
        const auto nodes = scope_.mesh.element_nodes(element_of(block, i));
        const auto at = std::ranges::find_if(nodes, [&](NodeIndex n) { return is_subcycled[n.value] != 0; });
        if (at == nodes.end()) continue;
        refuse(fmt::format("element {} of {} holds node {} of subcycled elements",
                           scope_.mesh.element_id(element_of(block, i)),
                           scope_.mesh.name({EntityKind::block, block.mesh_block}),
                           scope_.mesh.node_id(*at)));
        break;
      }
    }
  }

  void refuse(std::string text) const {
    scope_.diagnostics.add_error(line_.location, std::move(text),
                                 "springs, dampers, cohesive elements and rigid bodies must be more than "
                                 "three layers of elements from the small ones",
                                 static_cast<int>(line_.text.size()));
  }
};

}  // namespace

void set_subcycles(const ConditionScope& scope, Model& model) {
  if (!scope.region.subcycle_blocks.empty()) Choice(scope, model).apply();
}

}  // namespace contactsim
