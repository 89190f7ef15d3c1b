// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// HYBRID MODEL: one model for the points that were within the CAPTURE TOLERANCE of the other side at the
/// start, another one for the rest.
inline InterfaceLawRow hybrid() {
  InterfaceLawRow row{
      "hybrid",
      "Model by the gap at the start",
      {parameter::friction_model("initially close", "Friction model where the sides touch at the start")
           .shown_as("frictionless"),
       parameter::friction_model("initially far", "Friction model everywhere else")
           .shown_as("frictionless")}};
  row.select = [](const ParameterValues& values) -> LawSelection {
    return {values.find_name("initially close"), values.find_name("initially far"), {}};
  };
  return row;
}

}  // namespace contactsim
