// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "contact/bonds.hpp"

namespace contactsim {

namespace {

double envelope(double normal, double tangential, double exponent) {
  return std::pow(normal, exponent) + std::pow(tangential, exponent);
}

/// The law of one opening, visited by what holds.
struct BondLaw {
  double apart = 0.0, slip = 0.0;  ///< >= 0 [length]
  double area = 0.0, penalty = 0.0;
  BondHistory& history;

  /// Normal and tangential force, the latter along the slip.
  struct Force {
    double normal = 0.0, tangential = 0.0, stored = 0.0, dissipated = 0.0;
    bool fails = false;
  };

  Force operator()(const SpringHold& hold) const {
    Force force;
    force.normal = apart > 0.0 ? area * hold.normal.at(apart) : 0.0;
    force.tangential = slip > 0.0 ? area * hold.tangential.at(slip) : 0.0;
    force.stored = area * (hold.normal.integral(apart) + hold.tangential.integral(slip));
    force.fails = envelope(apart / hold.normal.last(), slip / hold.tangential.last(), hold.exponent) >= 1.0;
    return force;
  }

  Force operator()(const ThreadHold& hold) const {
    const double factor = hold.by_gap ? hold.by_gap_scale * hold.by_gap->evaluate(apart) : 1.0;
    const double normal = apart > 0.0 ? hold.normal.at(apart) : 0.0;
    const double tangential = slip > 0.0 ? factor * hold.tangential.at(slip) : 0.0;
    Force force;
    force.normal = area * normal;
    force.tangential = area * tangential;
    const double along = area * hold.tangential.integral(slip);
    force.stored = area * hold.normal.integral(apart) + factor * along;
    // The threads let go as they open: the gap does no work on what the factor takes away.
    force.dissipated = history.tangential_energy * (history.gap_factor - factor);
    history.tangential_energy = along;
    history.gap_factor = factor;
    force.fails = envelope(std::max(normal, 0.0) / hold.normal_capacity,
                           std::abs(tangential) / hold.tangential_capacity, hold.exponent) >= 1.0;
    return force;
  }

  Force operator()(const CohesiveHold& hold) const {
    const double gn = hold.critical_normal, gt = hold.critical_tangential;
    const double lambda = std::hypot(apart / gn, slip / gt);
    const double stiffest = penalty * std::min(gn, gt * gt / gn);
    Force force;
    if (lambda > history.worst) {
      const double most = std::min(lambda, 1.0);
      const double traction = std::min(hold.traction.at(most), stiffest * most);
      // Between two lines to the origin lies what damage has taken.
      force.dissipated = 0.5 * gn * area * (history.worst_traction * most - traction * history.worst);
      history.worst = most;
      history.worst_traction = traction;
    }
    if (history.worst == 0.0) return force;
    const double slope = history.worst_traction / history.worst;
    force.normal = area * slope * apart / gn;
    force.tangential = area * slope * gn / gt * slip / gt;
    force.stored = 0.5 * gn * area * slope * lambda * lambda;
    force.fails = lambda >= 1.0;
    return force;
  }

  Force operator()(const WeldHold&) const { return {}; }
};

struct Stiffness {
  double penalty = 0.0;

  double operator()(const SpringHold& hold) const {
    return std::max(hold.normal.steepest(), hold.tangential.steepest());
  }
  double operator()(const ThreadHold& hold) const {
    return std::max(hold.normal.steepest(), hold.tangential.steepest());
  }
  double operator()(const CohesiveHold& hold) const {
    const double gn = hold.critical_normal, gt = hold.critical_tangential;
    const double steepest =
        hold.traction.at(0.0) > 0.0 ? std::numeric_limits<double>::infinity() : hold.traction.steepest();
    const double slope = std::min(steepest, penalty * std::min(gn, gt * gt / gn));
    return slope * std::max(1.0 / gn, gn / (gt * gt));
  }
  double operator()(const WeldHold&) const { return 0.0; }
};

}  // namespace

BondAnswer answer(const Hold& hold, const Opening& opening, double area, double penalty,
                  BondHistory& history) {
  const double slip = opening.slip.norm();
  const BondLaw::Force force =
      std::visit(BondLaw{std::max(opening.normal, 0.0), slip, area, penalty, history}, hold);
  BondAnswer found;
  found.normal = force.normal;
  if (slip > 0.0) found.tangential = force.tangential / slip * opening.slip;
  found.stored = force.stored;
  found.dissipated = force.dissipated;
  found.fails = force.fails;
  return found;
}

double bond_stiffness(const Hold& hold, double area, double penalty) {
  return area * std::visit(Stiffness{penalty}, hold);
}

}  // namespace contactsim
