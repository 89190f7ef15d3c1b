// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "core/materials/material_table.hpp"
#include "support/catch.hpp"
#include "support/function_definition.hpp"
#include "support/material_model.hpp"

/// Laws of models as decks give them.
namespace contactsim::test {

/// With a function named f, from (0, 200e6) to (0.1, 300e6).
inline std::optional<MaterialLaw> made_law(const MaterialModel& model, Diagnostics& diagnostics) {
  const FunctionDefinition function =
      table_function(FunctionType::piecewise_linear, {{0.0, 200e6}, {0.1, 300e6}});
  return make_material_law(model, {&function, 1}, diagnostics);
}

inline void set_values(MaterialModel& model,
                       std::initializer_list<std::pair<const char*, ParameterValue>> given) {
  for (const auto& [phrase, value] : given) model.values.set(phrase, value);
}

/// Of elastic constants of steel; the rest as given.
inline MaterialModel steel_model(const std::string& name,
                                 std::initializer_list<std::pair<const char*, ParameterValue>> given = {}) {
  MaterialModel model = material_model(name, {{"bulk modulus", 160e9}, {"shear modulus", 80e9}});
  set_values(model, given);
  return model;
}

/// The law of a model that must be right.
template <class Law>
Law law_of(const MaterialModel& model) {
  Diagnostics diagnostics;
  const auto law = made_law(model, diagnostics);
  REQUIRE(law);
  CHECK(diagnostics.empty());
  CHECK(law->moduli().bulk == 160e9);
  CHECK(law->moduli().shear == 80e9);
  REQUIRE(law->get_if<Law>() != nullptr);
  return *law->get_if<Law>();
}

/// The one error of a model that makes no law.
inline std::string model_error(const MaterialModel& model) {
  Diagnostics diagnostics;
  CHECK_FALSE(made_law(model, diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  return diagnostics.all()[0].text;
}

/// A plausible value for a parameter.
inline ParameterValue example_of(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::word:
      return std::int64_t{0};
    case ParameterKind::function:
      return DeckName{"f", {}};
    case ParameterKind::poissons_ratio:
      return 0.3;
    default:
      break;
  }
  if (parameter.phrase == "yield stress") return 200e6;
  if (parameter.phrase.starts_with("nu")) return 0.3;
  if (parameter.phrase == "c10" || parameter.phrase == "c01") return 2e10;  // of a shear modulus of 80e9
  return parameter.phrase.starts_with("e") || parameter.phrase.starts_with("g") ? 2e11 : 0.5;
}

}  // namespace contactsim::test
