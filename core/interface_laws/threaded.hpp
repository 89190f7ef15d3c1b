// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// The tractions of a threaded joint, that along the slip times a factor of the gap, as threads let go. It
/// fails when (N / normal_capacity)^p + (T / tangential_capacity)^p >= 1 of the two, p the exponent.
struct ThreadedJoint {
  LawCurve normal, tangential;     ///< displacement [length] to traction [force/length^2]
  std::optional<Function> by_gap;  ///< factor of the tangential traction [1]; without it 1
  double by_gap_scale = 1.0;
  double normal_capacity = 0.0, tangential_capacity = 0.0;  ///< [force/length^2]
  double exponent = 2.0;                                    ///< [1]

  BondForce operator()(const BondOpening& opening, BondHistory& history) const {
    const auto& [apart, slip, area, penalty] = opening;
    const double factor = by_gap ? by_gap_scale * by_gap->evaluate(apart) : 1.0;
    const double across = apart > 0.0 ? normal.at(apart) : 0.0;
    const double along = slip > 0.0 ? factor * tangential.at(slip) : 0.0;
    BondForce force;
    force.normal = area * across;
    force.tangential = area * along;
    const double tangential_energy = area * tangential.integral(slip);
    force.stored = area * normal.integral(apart) + factor * tangential_energy;
    // The threads let go as they open: the gap does no work on what the factor takes away.
    force.dissipated = history.tangential_energy * (history.gap_factor - factor);
    history.tangential_energy = tangential_energy;
    history.gap_factor = factor;
    force.fails = envelope(std::max(across, 0.0) / normal_capacity, std::abs(along) / tangential_capacity,
                           exponent) >= 1.0;
    return force;
  }
};

inline BondLaw make_threaded_bond(const ThreadedJoint& joint) {
  BondLaw bond;
  bond.force = joint;
  bond.stiffness = [stiffest = std::max(joint.normal.steepest(), joint.tangential.steepest())](double) {
    return stiffest;
  };
  return bond;
}

/// THREADED MODEL: what touches at the start is held by such tractions.
inline InterfaceLawRow threaded() {
  InterfaceLawRow row{
      "threaded", "Springs in tension, as in a threaded joint",
      joined(
          {scaled_function("normal traction", "of the gap [length]: the traction [force/length^2]"),
           scaled_function("tangential traction", "of the slip [length]: the traction [force/length^2]"),
           scaled_function("tangential traction gap",
                           "of the gap [length]: a factor of the tangential traction [1]", false),
           {parameter::positive("normal capacity", "Normal traction at failure [force/length^2]").required(),
            parameter::positive("tangential capacity", "Tangential traction at failure [force/length^2]")
                .required(),
            envelope_exponent()},
           failure_parameters()})};
  row.holds_at_start = true;
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    const ParameterValues& values = input.values;
    const auto normal = input.curve("normal traction"), tangential = input.curve("tangential traction");
    const bool has_factor = values.has("tangential traction gap function");
    const auto by_gap = has_factor ? input.function("tangential traction gap") : std::nullopt;
    if (!normal || !tangential || (has_factor && !by_gap)) return std::nullopt;
    InterfaceLaw law;
    law.bond_law = make_threaded_bond({*normal, *tangential, by_gap, input.scale("tangential traction gap"),
                                       values.real("normal capacity"), values.real("tangential capacity"),
                                       values.real("failure envelope exponent")});
    return law;
  };
  return row;
}

}  // namespace contactsim
