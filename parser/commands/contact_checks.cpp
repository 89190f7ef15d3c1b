// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

void add_error(Diagnostics& diagnostics, const DeckName& at, std::string text, std::string hint = "") {
  diagnostics.add_error(at.location, std::move(text), std::move(hint), static_cast<int>(at.text.size()));
}

using FoldedNames = std::unordered_set<std::string>;

FoldedNames node_sets_of(const ContactDefinition& contact) {
  FoldedNames node_sets;
  for (const SurfaceCommand& command : contact.surface_commands) {
    if (const auto* line = std::get_if<ContactNodeSetLine>(&command)) node_sets.insert(fold(line->name.text));
  }
  return node_sets;
}

/// A node set meets faces only.
void check_node_sets(const Interaction& interaction, const FoldedNames& node_sets, Diagnostics& diagnostics) {
  const auto is_node_set = [&](const DeckName& name) { return node_sets.count(fold(name.text)) > 0; };
  for (const DeckName& name : interaction.side_a) {
    if (!is_node_set(name)) continue;
    add_error(diagnostics, name,
              fmt::format("the contact node set '{}' cannot be SIDE A, which gives the faces", name.text),
              "put it in SIDE B");
  }
  const auto& surfaces = interaction.surfaces;
  if (!surfaces.empty() && std::all_of(surfaces.begin(), surfaces.end(), is_node_set)) {
    add_error(diagnostics, surfaces.front(), "an interaction of contact node sets alone",
              "a node set meets faces only");
  }
}

/// The models among which a law selects; a failed model takes over later, so that a ring of them is fine.
std::vector<DeckName> selected_by(const FrictionLaw& law) {
  if (row_of(law).select == nullptr) return {};
  return law.values.names(ParameterKind::friction_model);
}

using Models = std::vector<FrictionModel>;

const FrictionModel* find_model(const Models& models, const DeckName& name) {
  const auto found =
      std::find_if(models.begin(), models.end(), [&](const auto& model) { return model.name == name; });
  return found == models.end() ? nullptr : &*found;
}

/// Whether the selections of `from` lead to the target.
///   seen  models that were followed before
bool leads_to(const Models& models, const FrictionModel& from, const FrictionModel& target,
              std::vector<const FrictionModel*>& seen) {
  seen.push_back(&from);
  for (const DeckName& name : selected_by(from.law)) {
    const FrictionModel* next = find_model(models, name);
    if (next == &target) return true;
    const bool is_new = next != nullptr && std::find(seen.begin(), seen.end(), next) == seen.end();
    if (is_new && leads_to(models, *next, target, seen)) return true;
  }
  return false;
}

void check_selections(const Models& models, const DeckNames& names, Diagnostics& diagnostics) {
  for (const FrictionModel& model : models) {
    std::vector<const FrictionModel*> seen;
    if (!names.is_used(NameKind::friction_model, model.name) || !leads_to(models, model, model, seen))
      continue;
    add_error(diagnostics, model.name,
              fmt::format("the friction model '{}' selects itself", model.name.text));
  }
}

}  // namespace

void check_contact(const ContactDefinition& contact, const DeckNames& names, Diagnostics& diagnostics) {
  const FoldedNames node_sets = node_sets_of(contact);
  for (const Interaction& interaction : contact.interactions)
    check_node_sets(interaction, node_sets, diagnostics);
  check_selections(contact.friction_models, names, diagnostics);
}

}  // namespace contactsim
