// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/bonded/bonds.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

BondAnswer answer(const BondLaw& bond_law, const Opening& opening, double area, double penalty,
                  BondHistory& history) {
  const double slip = opening.slip.norm();
  const BondForce force = bond_law.force({std::max(opening.normal, 0.0), slip, area, penalty}, history);
  BondAnswer found;
  found.normal = force.normal;
  if (slip > 0.0) found.tangential = force.tangential / slip * opening.slip;
  found.stored = force.stored;
  found.dissipated = force.dissipated;
  found.fails = force.fails;
  return found;
}

double bond_stiffness(const BondLaw& bond_law, double area, double penalty) {
  return area * bond_law.stiffness(penalty);
}

BondStep find_bond_step(const BondLaw& bond_law, const CornerVectors& x, const Bond& bond) {
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  const Eigen::Vector3d origin = x.col(0);
  const CornerVectors arms = x.colwise() - origin;
  const Eigen::Vector3d between = arms.leftCols<4>() * bond.weights_1 - arms.rightCols<4>() * bond.weights_2;
  const Eigen::Vector3d moved = axes.transpose() * between - bond.rest;
  BondStep step;
  step.history = bond.history;
  const BondAnswer found =
      answer(bond_law, {moved.z(), moved.head<2>()}, bond.size, bond.penalty, step.history);
  step.fails = found.fails;
  const Eigen::Vector3d pull =
      axes * Eigen::Vector3d(found.tangential.x(), found.tangential.y(), found.normal);
  CornerForces& forces = step.forces;
  forces.forces << -pull * bond.weights_1.transpose(), pull * bond.weights_2.transpose();
  balance(arms, forces.forces);
  forces.normal = axes.col(2);
  forces.stored = found.stored;
  forces.dissipated = found.dissipated;
  return step;
}

}  // namespace contactsim
