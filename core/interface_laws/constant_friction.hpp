// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// CONSTANT FRICTION MODEL: the surfaces stick until the tangential force would pass coefficient * normal
/// force, then they slip under that force (Coulomb).
inline InterfaceLawRow constant_friction() {
  InterfaceLawRow row{
      "constant friction",
      "Coulomb friction",
      {parameter::non_negative("friction coefficient",
                               "Coulomb coefficient: largest tangential over normal force [1]")
           .otherwise(0.0)}};
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    InterfaceLaw law;
    law.friction = input.values.real("friction coefficient");
    return law;
  };
  row.describe = [](const ParameterValues& values) {
    return fmt::format("friction {:.6g}", values.real("friction coefficient"));
  };
  return row;
}

}  // namespace contactsim
