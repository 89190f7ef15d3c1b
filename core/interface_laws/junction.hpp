// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// JUNCTION MODEL: surfaces that are apart pull each other with a traction that depends on the gap. Along the
/// surface they stick until the traction would pass g(slip rate), then they slip under it; from the cutoff
/// gap on nothing acts along the surface.
inline InterfaceLawRow junction() {
  constexpr const char* cutoff_phrase = "normal cutoff distance for tangential traction";
  InterfaceLawRow row{
      "junction", "Traction across a gap, tangential traction by slip rate",
      joined({scaled_function("normal traction", "of the gap [length]: the traction [force/length^2]"),
              scaled_function("tangential traction",
                              "of the slip rate [length/time]: the largest traction [force/length^2]"),
              {parameter::non_negative(cutoff_phrase,
                                       "Gap from which on there is no tangential traction [length]")
                   .shown_as("where the normal function ends")}})};
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    InterfaceLaw law;
    law.pull = input.curve("normal traction");
    auto traction = input.function("tangential traction");
    if (!law.pull || !traction) return std::nullopt;
    law.rate_limit = {*traction, input.scale("tangential traction"),
                      input.values.find_real(cutoff_phrase).value_or(law.pull->last())};
    return law;
  };
  return row;
}

}  // namespace contactsim
