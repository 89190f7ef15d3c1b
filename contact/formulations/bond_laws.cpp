// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "contact/formulations/bonds.hpp"

namespace contactsim {

namespace {

double envelope(double normal, double tangential, double exponent) {
  return std::pow(normal, exponent) + std::pow(tangential, exponent);
}

/// The law of one opening, visited by what holds.
struct BondLawVisitor {
  double apart = 0.0, slip = 0.0;  ///< >= 0 [length]
  double area = 0.0, penalty = 0.0;
  BondHistory& history;

  /// Normal and tangential force, the latter along the slip.
  struct Force {
    double normal = 0.0, tangential = 0.0, stored = 0.0, dissipated = 0.0;
    bool fails = false;
  };

  Force operator()(const SpringWeldLaw& bond_law) const {
    Force force;
    force.normal = apart > 0.0 ? area * bond_law.normal.at(apart) : 0.0;
    force.tangential = slip > 0.0 ? area * bond_law.tangential.at(slip) : 0.0;
    force.stored = area * (bond_law.normal.integral(apart) + bond_law.tangential.integral(slip));
    force.fails =
        envelope(apart / bond_law.normal.last(), slip / bond_law.tangential.last(), bond_law.exponent) >= 1.0;
    return force;
  }

  Force operator()(const ThreadedJointLaw& bond_law) const {
    const double factor = bond_law.by_gap ? bond_law.by_gap_scale * bond_law.by_gap->evaluate(apart) : 1.0;
    const double normal = apart > 0.0 ? bond_law.normal.at(apart) : 0.0;
    const double tangential = slip > 0.0 ? factor * bond_law.tangential.at(slip) : 0.0;
    Force force;
    force.normal = area * normal;
    force.tangential = area * tangential;
    const double along = area * bond_law.tangential.integral(slip);
    force.stored = area * bond_law.normal.integral(apart) + factor * along;
    // The threads let go as they open: the gap does no work on what the factor takes away.
    force.dissipated = history.tangential_energy * (history.gap_factor - factor);
    history.tangential_energy = along;
    history.gap_factor = factor;
    force.fails = envelope(std::max(normal, 0.0) / bond_law.normal_capacity,
                           std::abs(tangential) / bond_law.tangential_capacity, bond_law.exponent) >= 1.0;
    return force;
  }

  Force operator()(const CohesiveLaw& bond_law) const {
    const double gn = bond_law.critical_normal, gt = bond_law.critical_tangential;
    const double lambda = std::hypot(apart / gn, slip / gt);
    const double stiffest = penalty * std::min(gn, gt * gt / gn);
    Force force;
    if (lambda > history.worst) {
      const double most = std::min(lambda, 1.0);
      const double traction = std::min(bond_law.traction.at(most), stiffest * most);
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

  Force operator()(const WeldLaw&) const { return {}; }
};

struct Stiffness {
  double penalty = 0.0;

  double operator()(const SpringWeldLaw& bond_law) const {
    return std::max(bond_law.normal.steepest(), bond_law.tangential.steepest());
  }
  double operator()(const ThreadedJointLaw& bond_law) const {
    return std::max(bond_law.normal.steepest(), bond_law.tangential.steepest());
  }
  double operator()(const CohesiveLaw& bond_law) const {
    const double gn = bond_law.critical_normal, gt = bond_law.critical_tangential;
    const double steepest = bond_law.traction.at(0.0) > 0.0 ? std::numeric_limits<double>::infinity()
                                                            : bond_law.traction.steepest();
    const double slope = std::min(steepest, penalty * std::min(gn, gt * gt / gn));
    return slope * std::max(1.0 / gn, gn / (gt * gt));
  }
  double operator()(const WeldLaw&) const { return 0.0; }
};

}  // namespace

BondAnswer answer(const BondLaw& bond_law, const Opening& opening, double area, double penalty,
                  BondHistory& history) {
  const double slip = opening.slip.norm();
  const BondLawVisitor::Force force =
      std::visit(BondLawVisitor{std::max(opening.normal, 0.0), slip, area, penalty, history}, bond_law);
  BondAnswer found;
  found.normal = force.normal;
  if (slip > 0.0) found.tangential = force.tangential / slip * opening.slip;
  found.stored = force.stored;
  found.dissipated = force.dissipated;
  found.fails = force.fails;
  return found;
}

double bond_stiffness(const BondLaw& bond_law, double area, double penalty) {
  return area * std::visit(Stiffness{penalty}, bond_law);
}

}  // namespace contactsim
