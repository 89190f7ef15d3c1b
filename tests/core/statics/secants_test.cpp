// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/secants.hpp"

#include <Eigen/LU>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("steps that span the unknowns solve an unsymmetric stiffness", "[core][statics]") {
  Eigen::Matrix3d stiffness;
  stiffness << 4, 1, 0, -2, 3, 1, 0.5, 0, 2;
  const Eigen::Vector3d residual(1, -2, 3);
  Secants secants;
  Eigen::VectorXd left = residual;
  CHECK(secants.take_out(left).isZero(0.0));
  CHECK(left == residual);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::VectorXd step = Eigen::Vector3d::Unit(i) + 0.1 * Eigen::Vector3d::Ones();
    secants.add(step, -stiffness * step);
  }
  const Eigen::VectorXd found = secants.take_out(left);
  CHECK(left.norm() < 1e-12);
  CHECK((stiffness * found - residual).norm() < 1e-12);
  secants.clear();
  CHECK(secants.take_out(left).isZero(0.0));
}
