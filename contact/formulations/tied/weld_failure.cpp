// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/weld_failure.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

double weld_envelope(const WeldLaw& weld, const InterfaceConstraint& constraint, const CornerForces& forces) {
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  const double along = forces.normal.dot(on_first),
               size = weld.is_per_area ? constraint.area : constraint.share;
  const double normal = std::max(-along, 0.0) / (weld.normal_capacity * size);
  const double tangential = (on_first - along * forces.normal).norm() / (weld.tangential_capacity * size);
  return normal * normal + tangential * tangential;
}

CornerForces forces_at_failure(const WeldLaw& weld, const InterfaceConstraint& constraint,
                               CornerForces forces) {
  forces.forces /= std::sqrt(weld_envelope(weld, constraint, forces));
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  if (forces.normal.dot(on_first) > 0.0)
    forces.forces -= (forces.normal * (forces.normal.transpose() * forces.forces)).eval();
  return forces;
}

}  // namespace contactsim
