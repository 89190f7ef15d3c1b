// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/definition/friction.hpp"
#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// Every interface law that decks may define.
std::span<const InterfaceLawRow> interface_law_rows();

/// The row of a law. Throws std::logic_error when there is none: laws are made of rows.
const InterfaceLawRow& row_of(const FrictionLaw& law);

/// A law of a row, its parameters at their defaults.
FrictionLaw make_friction_law(std::string_view name);

/// Whether a law, or one of the models that it may become, has a pressure of its own.
bool has_pressure(const FrictionLaw& law, std::span<const FrictionModel> models);

/// A law as tables show it: "frictionless", "friction 0.3", "tied", "spring weld".
std::string describe_law(const FrictionLaw& law);

}  // namespace contactsim
