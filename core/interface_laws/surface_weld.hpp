// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// Tied until the force N across the tie and T along it reach (N / normal capacity)^2 + (T / tangential
/// capacity)^2 > 1; N is 0 in compression.
template <bool is_per_area>
std::optional<InterfaceLaw> make_weld(const InterfaceLawInput& input) {
  InterfaceLaw law;
  law.law = ContactLaw::welded;
  law.weld = {is_per_area, input.values.real("normal capacity"), input.values.real("tangential capacity")};
  return law;
}

template <bool is_per_area>
InterfaceLawRow make_weld_row(const std::string& name, const std::string& of, const std::string& dimension) {
  const auto capacity = [&](const char* phrase, const char* direction) {
    return parameter::positive(phrase,
                               fmt::format("{} {} [{}] that breaks the weld", direction, of, dimension))
        .required();
  };
  InterfaceLawRow row{
      name, fmt::format("Tied until a {} envelope is reached", of),
      joined({{capacity("normal capacity", "Normal"), capacity("tangential capacity", "Tangential")},
              failure_parameters()})};
  row.holds_at_start = true;
  row.make = make_weld<is_per_area>;
  return row;
}

/// SURFACE WELD MODEL, of forces.
inline InterfaceLawRow surface_weld() { return make_weld_row<false>("surface weld", "force", "force"); }

/// AREA WELD MODEL, of tractions.
inline InterfaceLawRow area_weld() { return make_weld_row<true>("area weld", "traction", "force/length^2"); }

}  // namespace contactsim
