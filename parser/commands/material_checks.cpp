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

Required required_of(const MooneyRivlinModel& model) { return {{"c10", model.c10}, {"c01", model.c01}}; }

Required required_of(const OrthotropicModel& m) {
  return {{"e11", m.e11},   {"e22", m.e22}, {"e33", m.e33}, {"nu12", m.nu12}, {"nu13", m.nu13},
          {"nu23", m.nu23}, {"g12", m.g12}, {"g13", m.g13}, {"g23", m.g23}};
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
