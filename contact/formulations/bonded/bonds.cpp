// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/bonded/bonds.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

bool bond_faces(const MovingFace& first, const MovingFace& second, double tolerance, Bond& bond) {
  const auto found = find_face_face_points(first, second);
  if (!found) return false;
  found->visit_near(tolerance, [&bond](double area, double, const Eigen::Vector4d& weights_1,
                                       const Eigen::Vector4d& weights_2) {
    bond.weights_1 += area * weights_1;
    bond.weights_2 += area * weights_2;
    bond.area += area;
  });
  if (bond.area == 0.0) return false;
  bond.weights_1 /= bond.area;
  bond.weights_2 /= bond.area;
  bond.rest = axes_of(second.x).transpose() * (first.x * bond.weights_1 - second.x * bond.weights_2);
  return true;
}

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

TieForces step_bond(const BondLaw& bond_law, const TieVectors& x, Bond& bond) {
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  const Eigen::Vector3d origin = x.col(0);
  const TieVectors arms = x.colwise() - origin;
  const Eigen::Vector3d between = arms.leftCols<4>() * bond.weights_1 - arms.rightCols<4>() * bond.weights_2;
  const Eigen::Vector3d moved = axes.transpose() * between - bond.rest;
  const BondAnswer found =
      answer(bond_law, {moved.z(), moved.head<2>()}, bond.size, bond.penalty, bond.history);
  bond.has_failed = found.fails;
  const Eigen::Vector3d pull =
      axes * Eigen::Vector3d(found.tangential.x(), found.tangential.y(), found.normal);
  TieForces forces;
  forces.forces << -pull * bond.weights_1.transpose(), pull * bond.weights_2.transpose();
  balance(arms, forces.forces);
  forces.normal = axes.col(2);
  forces.stored = found.stored;
  forces.dissipated = found.dissipated;
  return forces;
}

DecayingConstraint make_decaying(const InterfaceConstraint& constraint, const TieForces& at_failure,
                                 const TieVectors& x, std::int64_t n_steps) {
  DecayingConstraint fading;
  static_cast<InterfaceConstraint&>(fading) = constraint;
  fading.forces = axes_of(x.rightCols<4>()).transpose() * at_failure.forces;
  fading.stored = at_failure.stored;
  fading.n_steps = n_steps;
  return fading;
}

TieForces find_decaying_forces(const DecayingConstraint& constraint, const TieVectors& x) {
  const double left = 1.0 - static_cast<double>(constraint.n_done) / static_cast<double>(constraint.n_steps);
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  const Eigen::Vector3d origin = x.col(0);
  TieForces found;
  found.forces = left * (axes * constraint.forces);
  balance(x.colwise() - origin, found.forces);
  found.normal = axes.col(2);
  found.stored = left * constraint.stored;
  return found;
}

double weld_envelope(const WeldLaw& weld, const InterfaceConstraint& constraint, const TieForces& forces) {
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  const double along = forces.normal.dot(on_first),
               size = weld.is_per_area ? constraint.area : constraint.share;
  const double normal = std::max(-along, 0.0) / (weld.normal_capacity * size);
  const double tangential = (on_first - along * forces.normal).norm() / (weld.tangential_capacity * size);
  return normal * normal + tangential * tangential;
}

}  // namespace contactsim
