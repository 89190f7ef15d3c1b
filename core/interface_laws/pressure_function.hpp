// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include "core/interface_laws/interface_law_row.hpp"
#include "core/interface_laws/pressure_law.hpp"

namespace contactsim {

inline Parameter friction_of_pressure() {
  return parameter::non_negative("friction coefficient",
                                 "Coulomb coefficient: largest tangential over normal force [1]")
      .otherwise(0.0);
}

/// PRESSURE FUNCTION MODEL: the sides press each other by a function of how far they overlap, in place of the
/// penalty.
inline InterfaceLawRow pressure_function() {
  InterfaceLawRow row{
      "pressure function",
      "Pressure by a function of the overclosure",
      {parameter::function("function",
                           "Function of the overclosure [length], below 0 a gap: the pressure "
                           "[force/length^2], which does not fall; a table goes on along its last line")
           .required(),
       parameter::positive("scale factor", "Multiplies the function [1]").otherwise(1.0),
       friction_of_pressure()}};
  row.has_pressure = true;
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    InterfaceLaw law;
    law.pressure = make_pressure_law(input.values.name("function"), input.values.real("scale factor"),
                                     input.functions, input.diagnostics);
    law.friction = input.values.real("friction coefficient");
    return law.pressure ? std::optional(std::move(law)) : std::nullopt;
  };
  row.describe = [](const ParameterValues& values) {
    const auto function = values.find_name("function");
    return function ? fmt::format("pressure {}", function->text) : std::string("pressure function");
  };
  return row;
}

/// EXPONENTIAL PRESSURE MODEL: the same by p0 / (e - 1) x (e^x - 1), x = overclosure / c0 + 1: soft contact
/// that begins before touch. Source: PRESSURE-OVERCLOSURE=EXPONENTIAL of Abaqus.
inline InterfaceLawRow exponential_pressure() {
  InterfaceLawRow row{
      "exponential pressure",
      "Pressure that grows exponentially from a clearance on",
      {parameter::positive("pressure at zero gap", "Pressure p0 when the sides touch [force/length^2]")
           .required(),
       parameter::positive("clearance at zero pressure", "Gap c0 at which the pressure begins [length]")
           .required(),
       friction_of_pressure()}};
  row.has_pressure = true;
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    InterfaceLaw law;
    law.pressure = PressureLaw::exponential(input.values.real("pressure at zero gap"),
                                            input.values.real("clearance at zero pressure"));
    law.friction = input.values.real("friction coefficient");
    return law;
  };
  return row;
}

}  // namespace contactsim
