// SPDX-License-Identifier: BSD-3-Clause
#include "core/death/death_sets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/conditions/entity_elements.hpp"
#include "core/definition/death.hpp"
#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/block_names.hpp"

namespace contactsim {

namespace {

ConditionLabel label_of(const ElementDeath& death) { return {"the element death", death.name.location}; }

/// Whether the parameters that hold for a block name the material.
bool is_of_material(const FiniteElementModel& elements, std::span<const std::string> block_names,
                    const DeckName& material) {
  const BlockParameters* parameters = find_block_parameters(elements, block_names);
  return parameters != nullptr && parameters->material && *parameters->material == material;
}

/// The blocks of the materials join the set.
EntitySet with_materials(const ElementDeath& death, const ConditionScope& scope) {
  EntitySet set = death.set;
  const FiniteElementModel* elements = find_finite_element_model(scope.definition, scope.region);
  if (elements == nullptr) return set;
  const auto names = find_block_names(scope.mesh, elements->aliases);
  for (const DeckName& material : death.materials) {
    bool is_used = false;
    for (std::uint32_t b = 0; b < names.size(); ++b) {
      if (!is_of_material(*elements, names[b], material)) continue;
      set.blocks.push_back({scope.mesh.name({EntityKind::block, b}), material.location});
      is_used = true;
    }
    if (is_used) continue;
    scope.diagnostics.add_error(material.location,
                                fmt::format("no block has the material '{}'", material.text), "",
                                static_cast<int>(material.text.size()));
  }
  return set;
}

void check_criteria(const ElementDeath& death, Diagnostics& diagnostics) {
  if (!death.criteria.empty() || death.on_inversion || death.on_ill_defined_contact) return;
  diagnostics.add_error(death.name.location, "the element death has no criterion: nothing would die",
                        "CRITERION IS ..., or DEATH ON INVERSION = ON");
}

/// Of blocks that could not be made, which is reported already.
void leave_out_unmade(const Model& model, std::vector<ElementIndex>& elements) {
  std::erase_if(elements, [&](ElementIndex element) {
    return std::ranges::none_of(model.blocks, [&](const ModelBlock& block) {
      return element >= block.first_element && element.value - block.first_element.value < block.n_elements;
    });
  });
}

void leave_out_rigid(const ElementDeath& death, const ConditionScope& scope, const Model& model,
                     std::vector<ElementIndex>& elements) {
  const std::size_t n = std::erase_if(elements, [&](ElementIndex element) {
    return model.blocks[find_model_block(model, element)].is_rigid;
  });
  if (n == 0) return;
  scope.diagnostics.add_warning("death-of-rigid", death.name.location,
                                fmt::format("{} elements of rigid bodies are left out: they cannot die", n));
}

void mark_inverting(std::span<const ElementIndex> elements, Model& model) {
  for (const ElementIndex element : elements) {
    ModelBlock& block = model.blocks[find_model_block(model, element)];
    block.dies_inverted.resize(block.n_batches(), 0);
    const std::size_t i = element.value - block.first_element.value;
    block.dies_inverted[i / n_lanes] |= static_cast<std::uint8_t>(1u << i % n_lanes);
  }
}

}  // namespace

std::size_t find_model_block(const Model& model, ElementIndex element) {
  const auto after = std::ranges::upper_bound(model.blocks, element, {}, &ModelBlock::first_element);
  return static_cast<std::size_t>(after - model.blocks.begin()) - 1;
}

std::vector<std::vector<ElementIndex>> find_death_sets(const ConditionScope& scope, Model& model) {
  std::vector<std::vector<ElementIndex>> sets;
  for (const ElementDeath& death : scope.region.element_deaths) {
    check_criteria(death, scope.diagnostics);
    const std::size_t n_errors = scope.diagnostics.error_count();
    sets.push_back(find_elements(with_materials(death, scope), label_of(death), scope, n_errors));
    leave_out_unmade(model, sets.back());
    leave_out_rigid(death, scope, model, sets.back());
    if (death.on_inversion) mark_inverting(sets.back(), model);
  }
  return sets;
}

}  // namespace contactsim
