// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/material_commands.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

/// Parameters that a model must have, and whether it has them.
using Required = std::vector<std::pair<const char*, bool>>;

bool is_given(double value) { return !std::isnan(value); }

Required required_of(const ElasticPlasticModel& model) {
  return {{"yield stress", is_given(model.yield_stress)},
          {"hardening modulus", is_given(model.hardening_modulus)}};
}

Required required_of(const PowerHardeningModel& model) {
  return {{"yield stress", is_given(model.yield_stress)},
          {"hardening constant", is_given(model.hardening_constant)},
          {"hardening exponent", is_given(model.hardening_exponent)}};
}

Required required_of(const JohnsonCookModel& model) {
  return {{"yield stress", is_given(model.yield_stress)},
          {"hardening constant", is_given(model.hardening_constant)},
          {"hardening exponent", is_given(model.hardening_exponent)}};
}

Required required_of(const MultilinearModel& model) {
  return {{"yield stress", is_given(model.yield_stress)},
          {"hardening function", model.hardening_function.has_value()}};
}

Required required_of(const TearingModel& model) {
  Required required = required_of(model.plastic);
  required.emplace_back("critical tearing parameter", is_given(model.critical_tearing));
  required.emplace_back("critical crack opening strain", is_given(model.critical_opening));
  return required;
}

Required required_of(const J2Model& model) {
  Required required{{"yield stress", is_given(model.yield_stress)},
                    {"hardening model", model.hardening.has_value()}};
  if (!model.hardening) return required;
  switch (model.flow_stress().value_or(HardeningModel::decoupled_flow_stress)) {
    case HardeningModel::voce:
      required.emplace_back("exponential coefficient", is_given(model.exponential_coefficient));
      [[fallthrough]];
    case HardeningModel::linear:
      required.emplace_back("hardening modulus", is_given(model.hardening_modulus));
      break;
    case HardeningModel::power_law:
      required.emplace_back("hardening constant", is_given(model.hardening_constant));
      required.emplace_back("hardening exponent", is_given(model.hardening_exponent));
      break;
    case HardeningModel::user_defined:
      required.emplace_back("hardening function", model.hardening_function.has_value());
      break;
    case HardeningModel::decoupled_flow_stress:
      required.emplace_back("isotropic hardening model", false);
  }
  return required;
}

Required required_of(const MooneyRivlinModel& model) {
  return {{"c10", is_given(model.c10)}, {"c01", is_given(model.c01)}};
}

Required required_of(const OrthotropicModel& m) {
  return {{"e11", is_given(m.e11)},   {"e22", is_given(m.e22)},   {"e33", is_given(m.e33)},
          {"nu12", is_given(m.nu12)}, {"nu13", is_given(m.nu13)}, {"nu23", is_given(m.nu23)},
          {"g12", is_given(m.g12)},   {"g13", is_given(m.g13)},   {"g23", is_given(m.g23)}};
}

/// Elastic models need their elastic constants only, an opaque one is not understood.
template <class Model>
Required required_of(const Model&) {
  return {};
}

/// Which numbers of elastic constants will do.
template <class Model>
bool is_enough(const Model&, int n_given) {
  return n_given == 2;
}
bool is_enough(const OrthotropicModel&, int n_given) { return n_given == 0 || n_given == 2; }
bool is_enough(const MooneyRivlinModel&, int n_given) { return n_given == 1 || n_given == 2; }

int count_given(const ElasticConstants& elastic) {
  return elastic.youngs_modulus.has_value() + elastic.poissons_ratio.has_value() +
         elastic.shear_modulus.has_value() + elastic.bulk_modulus.has_value() + elastic.lambda.has_value();
}

}  // namespace

void check_used_model(const MaterialDefinition& material, const MaterialModel& model,
                      Diagnostics& diagnostics) {
  const std::string what =
      fmt::format("the model '{}' of the material '{}'", model.name.text, material.name.text);
  const ElasticConstants* elastic = find_elastic_constants(model);
  const int n_given = elastic != nullptr ? count_given(*elastic) : 0;
  const auto will_do = [&](const auto& parameters) { return is_enough(parameters, n_given); };
  if (elastic != nullptr && !std::visit(will_do, model.parameters)) {
    diagnostics.add_error(model.name.location,
                          fmt::format("{} needs two elastic constants, found {}", what, n_given),
                          "give two of youngs modulus, poissons ratio, shear modulus, bulk modulus, lambda",
                          static_cast<int>(model.name.text.size()));
  }
  const Required required = std::visit([](const auto& m) { return required_of(m); }, model.parameters);
  for (const auto& [name, is_there] : required) {
    if (is_there) continue;
    diagnostics.add_error(model.name.location, fmt::format("{} needs '{}'", what, name), "",
                          static_cast<int>(model.name.text.size()));
  }
}

void check_used_material(const MaterialDefinition& material, Diagnostics& diagnostics) {
  if (!std::isnan(material.density)) return;
  diagnostics.add_error(material.name.location,
                        fmt::format("the material '{}' has no density", material.name.text),
                        "add DENSITY = <mass per volume>", static_cast<int>(material.name.text.size()));
}

}  // namespace contactsim
