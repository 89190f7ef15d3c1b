// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/definition/material.hpp"
#include "core/materials/material_row.hpp"

namespace contactsim {

/// Every material that contactsim knows; their parameters begin with the elastic constants.
std::span<const MaterialRow> material_rows();

/// The row with the name, compared without case; null when there is none.
const MaterialRow* find_material_row(std::string_view name);

/// The laws that materials may have, each once.
std::vector<const LawKind*> material_laws();

/// The law of a model of the deck. Nothing when an error was added, at the model: it is not one that can be
/// integrated, or its constants give no stable material; or at its function: see make_hardening_curve.
///   functions  of the deck, that the model may name
std::optional<MaterialLaw> make_material_law(const MaterialModel& model,
                                             std::span<const FunctionDefinition> functions,
                                             Diagnostics& diagnostics);

}  // namespace contactsim
