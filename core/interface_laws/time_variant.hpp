// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// TIME VARIANT MODEL: another model in each time stepping block, the deck's PERIOD; frictionless in periods
/// that none names.
inline InterfaceLawRow time_variant() {
  InterfaceLawRow row{
      "time variant",
      "Model by time stepping block",
      {parameter::models_by_period("model", "Friction model in these time stepping blocks").required()}};
  row.select = [](const ParameterValues& values) -> LawSelection { return {{}, {}, values.models("model")}; };
  return row;
}

}  // namespace contactsim
