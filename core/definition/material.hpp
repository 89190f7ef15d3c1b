// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "core/definition/parameter_values.hpp"

namespace contactsim {

/// BEGIN PARAMETERS FOR MODEL <name> inside a material. core/materials/material_table.hpp lists the models by
/// their names; one that is not there has no values, and is wrong only when a block uses it.
struct MaterialModel {
  DeckName name;
  ParameterValues values;
};

/// BEGIN MATERIAL <name>. Several models may stand in it; blocks select one each.
struct MaterialDefinition {
  DeckName name;
  double density = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [mass/length^3]
  std::vector<MaterialModel> models;
};

/// The model of the material with the name, compared without case; null when there is none.
const MaterialModel* find_model(const MaterialDefinition& material, std::string_view name);

}  // namespace contactsim
