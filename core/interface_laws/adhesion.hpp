// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// ADHESION MODEL: surfaces that are apart by less than the last abscissa of a function pull each other with
/// the traction that it gives for the gap, whether they ever touched or not. There is no friction.
inline InterfaceLawRow adhesion() {
  InterfaceLawRow row{
      "adhesion", "Frictionless, with a traction across a gap",
      scaled_function("adhesion", "of the gap [length]: the traction that holds it [force/length^2]")};
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    InterfaceLaw law;
    law.pull = input.curve("adhesion");
    return law.pull ? std::optional(std::move(law)) : std::nullopt;
  };
  return row;
}

}  // namespace contactsim
