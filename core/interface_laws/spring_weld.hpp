// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// Two springs, one across the gap and one along the slip, that fail when
/// (gap / gap_max)^p + (slip / slip_max)^p >= 1, where the maxima are the last abscissas of the two curves
/// and p is the exponent.
///   normal, tangential  displacement [length] to force [force]
inline BondLaw make_spring_bond(const LawCurve& normal, const LawCurve& tangential, double exponent) {
  BondLaw bond;
  bond.is_in_forces = true;
  bond.stiffness = [stiffest = std::max(normal.steepest(), tangential.steepest())](double) {
    return stiffest;
  };
  bond.force = [normal, tangential, exponent](const BondOpening& opening, BondHistory&) {
    const auto& [apart, slip, area, penalty] = opening;
    BondForce force;
    force.normal = apart > 0.0 ? area * normal.at(apart) : 0.0;
    force.tangential = slip > 0.0 ? area * tangential.at(slip) : 0.0;
    force.stored = area * (normal.integral(apart) + tangential.integral(slip));
    force.fails = envelope(apart / normal.last(), slip / tangential.last(), exponent) >= 1.0;
    return force;
  };
  return bond;
}

/// SPRING WELD MODEL: what touches at the start is held by such springs.
inline InterfaceLawRow spring_weld() {
  InterfaceLawRow row{
      "spring weld", "Springs between the sides, with a failure envelope",
      joined({scaled_function("normal displacement", "of opening [length]: the normal force [force]"),
              scaled_function("tangential displacement", "of slip [length]: the tangential force [force]"),
              {envelope_exponent()},
              failure_parameters()})};
  row.holds_at_start = true;
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    const auto normal = input.curve("normal displacement"),
               tangential = input.curve("tangential displacement");
    if (!normal || !tangential) return std::nullopt;
    InterfaceLaw law;
    law.bond_law = make_spring_bond(*normal, *tangential, input.values.real("failure envelope exponent"));
    return law;
  };
  return row;
}

}  // namespace contactsim
