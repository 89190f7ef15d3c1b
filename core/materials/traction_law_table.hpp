// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/material.hpp"
#include "core/definition/parameter_values.hpp"
#include "core/materials/traction_law.hpp"

namespace contactsim {

/// A material of cohesive elements: one model of PARAMETERS FOR MODEL.
struct TractionLawRow {
  std::string name;  ///< lower case, blanks as underscores
  std::string help;  ///< one line
  std::vector<Parameter> parameters;
  /// Throws std::invalid_argument with a text for the user when the parameters make no law.
  TractionLaw (*make)(const ParameterValues& values) = nullptr;
};

/// Every model that cohesive elements may have, and no other ones.
std::span<const TractionLawRow> traction_law_rows();

/// The row with the name, compared without case; null when there is none.
const TractionLawRow* find_traction_law_row(std::string_view name);

/// The law of a model of the deck. Nothing when an error was added, at the model: it is none of cohesive
/// elements, or its parameters make no law.
std::optional<TractionLaw> make_traction_law(const MaterialModel& model, Diagnostics& diagnostics);

}  // namespace contactsim
