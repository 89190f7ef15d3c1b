// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// Tractions that fail with gap and slip together. With lambda = sqrt((gap / g_n)^2 + (slip / g_t)^2) and the
/// function s(lambda), the normal traction is s / lambda * gap / g_n and the tangential one
/// s / lambda * (g_n / g_t) * slip / g_t. When lambda falls, s goes back along a straight line to the origin;
/// at lambda = 1 it fails. Source: Tvergaard and Hutchinson, J. Mech. Phys. Solids 41 (1993) 1119-1135;
/// unloading as in Camacho and Ortiz, Int. J. Solids Struct. 33 (1996) 2899-2938.
struct CohesiveZone {
  LawCurve traction;                              ///< lambda [1] to traction [force/length^2]
  double normal_gap = 0.0, tangential_gap = 0.0;  ///< g_n and g_t, > 0 [length]

  BondForce operator()(const BondOpening& opening, BondHistory& history) const {
    const auto& [apart, slip, area, penalty] = opening;
    const double gn = normal_gap, gt = tangential_gap;
    const double lambda = std::hypot(apart / gn, slip / gt);
    const double stiffest = penalty * std::min(gn, gt * gt / gn);
    BondForce force;
    if (lambda > history.worst) {
      const double most = std::min(lambda, 1.0);
      const double now = std::min(traction.at(most), stiffest * most);
      // Between two lines to the origin lies what damage has taken.
      force.dissipated = 0.5 * gn * area * (history.worst_traction * most - now * history.worst);
      history.worst = most;
      history.worst_traction = now;
    }
    if (history.worst == 0.0) return force;
    const double slope = history.worst_traction / history.worst;
    force.normal = area * slope * apart / gn;
    force.tangential = area * slope * gn / gt * slip / gt;
    force.stored = 0.5 * gn * area * slope * lambda * lambda;
    force.fails = lambda >= 1.0;
    return force;
  }

  /// As BondLaw::stiffness.
  double stiffness(double penalty) const {
    const double gn = normal_gap, gt = tangential_gap;
    const double steepest =
        traction.at(0.0) > 0.0 ? std::numeric_limits<double>::infinity() : traction.steepest();
    const double slope = std::min(steepest, penalty * std::min(gn, gt * gt / gn));
    return slope * std::max(1.0 / gn, gn / (gt * gt));
  }
};

inline BondLaw make_cohesive_bond(const CohesiveZone& zone) {
  BondLaw bond;
  bond.force = zone;
  bond.stiffness = [zone](double penalty) { return zone.stiffness(penalty); };
  return bond;
}

/// COHESIVE ZONE MODEL: what touches at the start is held by such tractions, then it is frictionless.
inline InterfaceLawRow cohesive_zone() {
  InterfaceLawRow row{
      "cohesive zone", "Traction by the size of normal and tangential opening",
      joined({scaled_function("traction displacement",
                              "of the opening over the critical one [1]: the traction [force/length^2]"),
              {parameter::positive("critical normal gap", "Normal opening at failure [length]").required(),
               parameter::positive("critical tangential gap", "Tangential opening at failure [length]")
                   .required()}})};
  row.holds_at_start = true;
  row.make = [](const InterfaceLawInput& input) -> std::optional<InterfaceLaw> {
    const auto traction = input.curve("traction displacement");
    if (!traction) return std::nullopt;
    if (!traction->softens()) {
      const DeckName& name = input.values.name("traction displacement function");
      input.diagnostics.add_error(
          name.location,
          fmt::format(
              "the traction '{}' of a cohesive zone must not rise faster than its abscissa, or be negative",
              name.text),
          "unloading to the origin would make energy");
      return std::nullopt;
    }
    InterfaceLaw law;
    law.bond_law = make_cohesive_bond(
        {*traction, input.values.real("critical normal gap"), input.values.real("critical tangential gap")});
    return law;
  };
  return row;
}

}  // namespace contactsim
