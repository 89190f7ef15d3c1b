// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/friction_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// What a law refers to and what it lacks.
struct LawContents {
  std::vector<const ScaledFunction*> functions;
  std::vector<DeckName> models;      ///< other friction models
  std::vector<DeckName> periods;     ///< time stepping blocks
  std::vector<const char*> missing;  ///< commands without which the law says nothing

  void need(const ScaledFunction& function, const char* command) {
    functions.push_back(&function);
    if (!function.function) missing.push_back(command);
  }
  void need(double value, const char* command) {
    if (std::isnan(value)) missing.push_back(command);
  }
  void refer_to(const std::optional<DeckName>& model) {
    if (model) models.push_back(*model);
  }

  void operator()(const Frictionless&) {}
  void operator()(const ConstantFriction&) {}
  void operator()(const Tied&) {}
  void operator()(const Glued&) {}
  void operator()(const SpringWeld& weld) {
    need(weld.normal, "NORMAL DISPLACEMENT FUNCTION");
    need(weld.tangential, "TANGENTIAL DISPLACEMENT FUNCTION");
    refer_to(weld.failure.failed_model);
  }
  void operator()(const SurfaceWeld& weld) {
    need(weld.normal_capacity, "NORMAL CAPACITY");
    need(weld.tangential_capacity, "TANGENTIAL CAPACITY");
    refer_to(weld.failure.failed_model);
  }
  void operator()(const Adhesion& adhesion) { need(adhesion.adhesion, "ADHESION FUNCTION"); }
  void operator()(const CohesiveZone& zone) {
    need(zone.traction, "TRACTION DISPLACEMENT FUNCTION");
    need(zone.critical_normal_gap, "CRITICAL NORMAL GAP");
    need(zone.critical_tangential_gap, "CRITICAL TANGENTIAL GAP");
  }
  void operator()(const Junction& junction) {
    need(junction.normal, "NORMAL TRACTION FUNCTION");
    need(junction.tangential, "TANGENTIAL TRACTION FUNCTION");
  }
  void operator()(const Threaded& threaded) {
    need(threaded.normal, "NORMAL TRACTION FUNCTION");
    need(threaded.tangential, "TANGENTIAL TRACTION FUNCTION");
    functions.push_back(&threaded.tangential_gap);
    need(threaded.normal_capacity, "NORMAL CAPACITY");
    need(threaded.tangential_capacity, "TANGENTIAL CAPACITY");
    refer_to(threaded.failure.failed_model);
  }
  void operator()(const PressureVelocityFriction& friction) {
    need(friction.reference_pressure, "REFERENCE PRESSURE");
  }
  void operator()(const HybridFriction& hybrid) {
    refer_to(hybrid.initially_close);
    refer_to(hybrid.initially_far);
  }
  void operator()(const TimeVariantFriction& variant) {
    if (variant.models.empty()) missing.push_back("MODEL");
    for (const PeriodModel& model : variant.models) {
      models.push_back(model.model);
      periods.insert(periods.end(), model.periods.begin(), model.periods.end());
    }
  }
};

LawContents contents_of(const FrictionLaw& law) {
  LawContents contents;
  std::visit(contents, law);
  return contents;
}

/// Whether the law only selects among other models; a failed model takes over later, so that a ring of them
/// is fine.
bool is_selection(const FrictionLaw& law) {
  return std::holds_alternative<HybridFriction>(law) || std::holds_alternative<TimeVariantFriction>(law);
}

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
  const LawContents contents = contents_of(model.law);
  for (const ScaledFunction* function : contents.functions) uses_.use(*function);
  for (const DeckName& other : contents.models) use(other);
  uses_.use_periods(contents.periods);
  for (const char* command : contents.missing) {
    uses_.add_error(model.name, fmt::format("the friction model '{}' has no {}", model.name.text, command));
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
  for (const DeckName& name : contents_of(from.law).models) {
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
