// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/step_forces.hpp"

namespace contactsim {

Eigen::VectorXd StepForces::all() const {
  return now(&NodalForces::internal) + now(&NodalForces::external) + now(&NodalForces::contact);
}

Eigen::VectorXd StepForces::all_at_start() const {
  Eigen::VectorXd forces =
      at_start(&NodalForces::internal) + at_start(&NodalForces::external) + at_start(&NodalForces::contact);
  bodies.gather_at_start(forces);
  return forces;
}

}  // namespace contactsim
