// SPDX-License-Identifier: BSD-3-Clause
#include "parser/friction_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// Whether the law only selects among other models; a failed model takes over later, so that a ring of them
/// is fine.
bool is_selection(const FrictionLaw& law) { return row_of(law).select != nullptr; }

}  // namespace

FrictionNames::FrictionNames(std::span<const FrictionModel> models, const NameUses& uses)
    : models_(models), uses_(uses) {
  for (const FrictionModel& model : models_) {
    const FrictionModel* first = find(model.name);
    if (first == &model || !(first->law == model.law)) {
      names_.define(model.name, uses_.diagnostics());
      continue;
    }
    uses_.diagnostics().add_warning(
        "deck-duplicate", model.name.location,
        fmt::format("the friction model '{}' is defined twice, with equal content", model.name.text),
        "the first stands at " + to_string(first->name.location), static_cast<int>(model.name.text.size()));
  }
  names_.add_built_in("frictionless");
  names_.add_built_in("tied");
}

const FrictionModel* FrictionNames::find(const DeckName& name) const {
  const auto found =
      std::find_if(models_.begin(), models_.end(), [&](const auto& m) { return m.name == name; });
  return found == models_.end() ? nullptr : &*found;
}

void FrictionNames::use(const DeckName& reference) {
  if (!names_.knows(reference.text) && uses_.outside().materials.knows(reference.text)) {
    uses_.add_error(reference, fmt::format("'{}' is a material, not a friction model", reference.text),
                    "cohesive materials as friction models are not supported");
    return;
  }
  names_.use(reference, uses_.diagnostics());
}

void FrictionNames::check(const FrictionModel& model) {
  const ParameterValues& values = model.law.values;
  for (const DeckName& function : values.names(ParameterKind::function))
    uses_.outside().functions.use(function, uses_.diagnostics());
  for (const DeckName& other : values.names(ParameterKind::friction_model)) use(other);
  for (const Parameter& parameter : values.parameters()) {
    if (parameter.kind != ParameterKind::models_by_period || !values.has(parameter.phrase)) continue;
    for (const PeriodModel& one : values.models(parameter.phrase)) uses_.use_periods(one.periods);
  }
  for (const std::string& phrase : missing_parameters(values.parameters(), values)) {
    uses_.add_error(model.name,
                    fmt::format("the friction model '{}' has no {}", model.name.text, upper_case(phrase)));
  }
  std::vector<const FrictionModel*> seen;
  if (is_selection(model.law) && leads_to(model, model, seen)) {
    uses_.add_error(model.name, fmt::format("the friction model '{}' selects itself", model.name.text));
  }
}

bool FrictionNames::leads_to(const FrictionModel& from, const FrictionModel& target,
                             std::vector<const FrictionModel*>& seen) const {
  if (!is_selection(from.law)) return false;
  seen.push_back(&from);
  for (const DeckName& name : from.law.values.names(ParameterKind::friction_model)) {
    const FrictionModel* next = find(name);
    if (next == &target) return true;
    const bool is_new = next != nullptr && std::find(seen.begin(), seen.end(), next) == seen.end();
    if (is_new && leads_to(*next, target, seen)) return true;
  }
  return false;
}

void FrictionNames::check_used() {
  std::vector<bool> is_checked(models_.size(), false);
  bool has_new = true;
  while (has_new) {
    has_new = false;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (is_checked[i] || !names_.is_used(models_[i].name.text)) continue;
      is_checked[i] = has_new = true;
      if (find(models_[i].name) == &models_[i]) check(models_[i]);
    }
  }
}

}  // namespace contactsim
