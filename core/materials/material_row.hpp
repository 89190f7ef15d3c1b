// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/parameter_values.hpp"
#include "core/materials/elastic_constants.hpp"
#include "core/materials/material_law.hpp"

namespace contactsim {

/// What a law is made of.
struct MaterialInput {
  const ParameterValues& values;                  ///< whole: what is required is there
  std::span<const FunctionDefinition> functions;  ///< of the deck
  Diagnostics& diagnostics;

  /// The moduli of the two elastic constants that are given.
  ElasticModuli moduli() const { return make_elastic_moduli(elastic_constants_of(values)); }
};

/// Makes a law. Throws std::invalid_argument with a text for the user when the parameters give no stable
/// material; nothing when it has added an error at its function.
using MakeMaterialLaw = std::optional<MaterialLaw> (*)(const MaterialInput& input);

/// How many elastic constants a model takes.
enum class ElasticNeed : std::uint8_t { two, none_or_two, one_or_two };

/// A material: one model of PARAMETERS FOR MODEL.
struct MaterialRow {
  std::vector<std::string> names;     ///< lower case, blanks as underscores; all but the first stand for it
  std::string help;                   ///< one line
  std::vector<Parameter> parameters;  ///< besides the elastic constants
  std::vector<const LawKind*> laws = {};  ///< of the classes that `make` may give
  MakeMaterialLaw make = nullptr;         ///< null: the model is read, a run refuses it
  ElasticNeed elastic = ElasticNeed::two;
  /// Of models whose required parameters depend on others: phrases of those that are missing besides.
  std::vector<std::string> (*missing_besides)(const ParameterValues& values) = nullptr;
};

}  // namespace contactsim
