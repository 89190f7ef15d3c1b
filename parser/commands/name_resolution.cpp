// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/name_resolution.hpp"

#include <fmt/format.h>

#include <map>

#include "core/functions/function.hpp"
#include "core/materials/traction_law_table.hpp"
#include "parser/commands/contact_checks.hpp"
#include "parser/commands/material_commands.hpp"

namespace contactsim {

namespace {

int length_of(const DeckName& name) { return static_cast<int>(name.text.size()); }

class DefinitionChecks {
 public:
  DefinitionChecks(const SimulationDefinition& simulation, DeckNames& names, Diagnostics& diagnostics)
      : simulation_(simulation), names_(names), diagnostics_(diagnostics) {}

  void check() {
    for (const Procedure& procedure : simulation_.procedures) {
      for (const Region& region : procedure.regions) check(region);
    }
    if (simulation_.form != DeckForm::full) names_.use_all(NameKind::finite_element_model, diagnostics_);
    for_each_used(simulation_.finite_element_models, NameKind::finite_element_model);
    for_each_used(simulation_.materials, NameKind::material);
    for_each_used(simulation_.functions, NameKind::function);
  }

 private:
  template <class T>
  void for_each_used(const std::vector<T>& definitions, NameKind kind) {
    for (const T& definition : definitions) {
      if (names_.is_used(kind, definition.name)) check(definition);
    }
  }

  void check(const Region& region) {
    if (region.contact) check_contact(*region.contact, names_, diagnostics_);
    if (region.finite_element_model || simulation_.form != DeckForm::full) return;
    const auto& models = simulation_.finite_element_models;
    const std::string text = fmt::format("the region '{}' has no USE FINITE ELEMENT MODEL", region.name.text);
    if (models.size() > 1) {
      diagnostics_.add_error(region.name.location, text, "name one of the models", length_of(region.name));
      return;
    }
    diagnostics_.add_warning("deck-model", region.name.location, text,
                             models.empty() ? "the mesh is that of the command line, or <deck base>.g"
                                            : fmt::format("'{}' is taken", models.front().name.text),
                             length_of(region.name));
    if (!models.empty()) names_.use(NameKind::finite_element_model, models.front().name, diagnostics_);
  }

  void check(const FiniteElementModel& model) {
    std::map<std::string, DeckLocation> blocks;
    for (const BlockParameters& parameters : model.block_parameters) {
      for (const DeckName& name : parameters.names) {
        const auto [entry, is_new] = blocks.try_emplace(fold(name.text), name.location);
        if (is_new) continue;
        diagnostics_.add_error(name.location,
                               fmt::format("the block '{}' is given parameters a second time", name.text),
                               "the first stand at " + to_string(entry->second), length_of(name));
      }
    }
  }

  void check(const MaterialDefinition& material) {
    const bool is_read = !names_.has_wrong_lines(NameKind::material, material.name);
    if (is_read && !is_of_tractions(material)) check_used_material(material, diagnostics_);
    for (const MaterialModel& model : material.models) {
      if (names_.has_wrong_lines(NameKind::model, model.name)) continue;
      if (names_.is_used(NameKind::model, model.name)) check_used_model(material, model, diagnostics_);
    }
  }

  /// Whether cohesive elements alone use the material: they need no density.
  bool is_of_tractions(const MaterialDefinition& material) const {
    bool has_traction = false, has_other = false;
    for (const MaterialModel& model : material.models) {
      if (!names_.is_used(NameKind::model, model.name)) continue;
      (find_traction_law_row(model.name.text) != nullptr ? has_traction : has_other) = true;
    }
    return has_traction && !has_other;
  }

  /// One without a type is told of elsewhere.
  void check(const FunctionDefinition& function) {
    if (function.type) make_function(function, diagnostics_);
  }

  const SimulationDefinition& simulation_;
  DeckNames& names_;
  Diagnostics& diagnostics_;
};

}  // namespace

void resolve_names(const SimulationDefinition& simulation, DeckNames& names, Diagnostics& diagnostics) {
  if (simulation.form != DeckForm::full) names.allow_unknown();
  names.resolve(diagnostics);
  DefinitionChecks(simulation, names, diagnostics).check();
  names.report_problems_of_lines(diagnostics);
}

}  // namespace contactsim
