// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/material_commands.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

using Required = std::vector<std::pair<const char*, double>>;

Required required_of(const ElasticPlasticModel& model) {
  return {{"yield stress", model.yield_stress}, {"hardening modulus", model.hardening_modulus}};
}

Required required_of(const PowerHardeningModel& model) {
  return {{"yield stress", model.yield_stress},
          {"hardening constant", model.hardening_constant},
          {"hardening exponent", model.hardening_exponent}};
}

Required required_of(const JohnsonCookModel& model) {
  return {{"yield stress", model.yield_stress},
          {"hardening constant", model.hardening_constant},
          {"hardening exponent", model.hardening_exponent}};
}

/// Elastic models need their elastic constants only, an opaque one is not understood.
template <class Model>
Required required_of(const Model&) {
  return {};
}

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
  if (elastic != nullptr && count_given(*elastic) != 2) {
    diagnostics.add_error(
        model.name.location,
        fmt::format("{} needs two elastic constants, found {}", what, count_given(*elastic)),
        "give two of youngs modulus, poissons ratio, shear modulus, bulk modulus, lambda",
        static_cast<int>(model.name.text.size()));
  }
  const Required required = std::visit([](const auto& m) { return required_of(m); }, model.parameters);
  for (const auto& [name, value] : required) {
    if (!std::isnan(value)) continue;
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
