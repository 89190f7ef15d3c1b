// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/simulation.hpp"

#include <algorithm>

namespace contactsim {

namespace {

bool holds_any(const std::vector<DeckName>& list, std::span<const std::string> names) {
  return std::any_of(list.begin(), list.end(), [&](const DeckName& listed) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return fold(listed.text) == fold(name); });
  });
}

}  // namespace

std::vector<const Region*> regions_with_contact(const SimulationDefinition& simulation) {
  std::vector<const Region*> found;
  for (const Procedure& procedure : simulation.procedures) {
    for (const Region& region : procedure.regions) {
      if (region.contact) found.push_back(&region);
    }
  }
  return found;
}

const FiniteElementModel* find_finite_element_model(const SimulationDefinition& simulation,
                                                    const Region& region) {
  const auto& models = simulation.finite_element_models;
  if (region.finite_element_model) return find_by_name(models, region.finite_element_model->text);
  return models.size() == 1 ? &models.front() : nullptr;
}

const BlockParameters* find_block_parameters(const FiniteElementModel& model,
                                             std::span<const std::string> names) {
  const BlockParameters* general_parameters = nullptr;
  for (const BlockParameters& parameters : model.block_parameters) {
    if (holds_any(parameters.removed_blocks, names)) continue;
    if (holds_any(parameters.names, names)) return &parameters;
    if (parameters.includes_all_blocks && general_parameters == nullptr) general_parameters = &parameters;
  }
  return general_parameters;
}

const BlockParameters* find_block_parameters(const FiniteElementModel& model, const std::string& name) {
  return find_block_parameters(model, std::span(&name, 1));
}

const SectionDefinition* find_section(const SimulationDefinition& simulation,
                                      const BlockParameters& parameters) {
  return parameters.section ? find_by_name(simulation.sections, parameters.section->text) : nullptr;
}

std::string expand_file_name(const SimulationDefinition& simulation, std::string_view name) {
  std::string expanded(name);
  for (std::size_t at = 0; (at = expanded.find("%B", at)) != std::string::npos;) {
    expanded.replace(at, 2, simulation.deck_base);
    at += simulation.deck_base.size();
  }
  return expanded;
}

std::string mesh_path(const SimulationDefinition& simulation, const Region& region) {
  const FiniteElementModel* model = find_finite_element_model(simulation, region);
  const bool is_named = model != nullptr && model->database;
  return expand_file_name(simulation, is_named ? model->database->text : "%B.g");
}

}  // namespace contactsim
