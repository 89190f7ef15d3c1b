// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/strain_measures.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

Eigen::Matrix3d some_rotation() {
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

/// A stretch of 2, 1 and 0.5 along the axes.
Eigen::Matrix3d stretch() { return Eigen::Vector3d(2.0, 1.0, 0.5).asDiagonal(); }

bool are_close(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) { return (a - b).norm() < 1e-14; }

}  // namespace

TEST_CASE("strains of a stretch that is then turned", "[core][output]") {
  const Eigen::Matrix3d rotation = some_rotation(), f = rotation * stretch();
  const Eigen::Matrix3d logarithm = Eigen::Vector3d(std::log(2.0), 0.0, -std::log(2.0)).asDiagonal();
  CHECK(are_close(log_strain(f), rotation * logarithm * rotation.transpose()));
  // (4 - 1) / 2, (1 - 1) / 2, (0.25 - 1) / 2.
  CHECK(are_close(green_lagrange_strain(f), Eigen::Vector3d(1.5, 0.0, -0.375).asDiagonal()));
  CHECK(are_close(rotation_of(f), rotation));
  CHECK(effective_strain(log_strain(f)) == Approx(2.0 / std::sqrt(3.0) * std::log(2.0)));
}

TEST_CASE("a rotation has no strain", "[core][output]") {
  CHECK(log_strain(some_rotation()).norm() < 1e-15);
  CHECK(green_lagrange_strain(some_rotation()).norm() < 1e-15);
}

TEST_CASE("von Mises stress and principal stresses by hand", "[core][output]") {
  const std::array<double, 6> uniaxial{5, 0, 0, 0, 0, 0}, shear{0, 0, 0, 2, 0, 0},
      hydrostatic{4, 4, 4, 0, 0, 0};
  CHECK(von_mises_stress(symmetric(uniaxial)) == Approx(5.0));
  CHECK(von_mises_stress(symmetric(shear)) == Approx(2.0 * std::sqrt(3.0)));
  CHECK(von_mises_stress(symmetric(hydrostatic)) == 0.0);
  const Eigen::Vector3d values = principal_values(symmetric(shear));
  CHECK((values - Eigen::Vector3d(2, 0, -2)).norm() < 1e-14);
}

TEST_CASE("tensors go to files in their order", "[core][output]") {
  Eigen::Matrix3d a;
  a << 11, 12, 13, 21, 22, 23, 31, 32, 33;
  CHECK(components_of(a) == std::array<double, 9>{11, 22, 33, 12, 23, 31, 21, 32, 13});
  const std::array<double, 6> c{1, 2, 3, 4, 5, 6};
  const Eigen::Matrix3d s = symmetric(c);
  CHECK(s.isApprox(s.transpose()));
  CHECK(components_of_symmetric(s) == c);
}
