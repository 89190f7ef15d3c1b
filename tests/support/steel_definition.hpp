// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/definition/simulation.hpp"
#include "core/dynamics/model.hpp"
#include "support/material_model.hpp"

namespace contactsim::test {

inline DeckName deck_name(const std::string& text) { return {text, {}}; }

/// One material `steel` with the models `elastic` and `strange`, given to `block`.
inline SimulationDefinition steel_definition(const std::string& block) {
  SimulationDefinition definition;
  const MaterialModel elastic =
      material_model("elastic", {{"youngs modulus", 200e9}, {"poissons ratio", 0.3}});
  definition.materials.push_back({deck_name("steel"), 7800.0, {elastic, {deck_name("strange"), {}}}});
  BlockParameters parameters;
  parameters.names = {deck_name(block)};
  parameters.material = deck_name("steel");
  parameters.model = deck_name("elastic");
  definition.finite_element_models.push_back({deck_name("fem"), {}, {}, {parameters}, {}});
  return definition;
}

/// What making a model of a mesh says, a line each.
inline std::string model_errors(const SimulationDefinition& definition, const Mesh& mesh) {
  Diagnostics diagnostics;
  make_model(definition, {}, mesh, diagnostics);
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += diagnostic.text + "\n";
  return text;
}

}  // namespace contactsim::test
