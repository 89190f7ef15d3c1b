// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/face_forces.hpp"

#include <Eigen/Geometry>
#include <random>

#include "core/mesh/face_geometry.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

Corners columns(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
  Corners corners;
  corners << a, b, c, d;
  return corners;
}

/// The pressure forces by a fine midpoint rule on a grid of n x n cells: the definition, slowly.
Corners slow_pressure_forces(const Corners& x, const Eigen::Vector4d& pressure, int n) {
  Corners forces = Corners::Zero();
  for (int i = 0; i < n * n; ++i) {
    const double p = (i % n + 0.5) / n, q = (i / n + 0.5) / n;
    const Eigen::Vector4d shape((1 - p) * (1 - q), p * (1 - q), p * q, (1 - p) * q);
    const Eigen::Vector3d along_p = (1 - q) * (x.col(1) - x.col(0)) + q * (x.col(2) - x.col(3));
    const Eigen::Vector3d along_q = (1 - p) * (x.col(3) - x.col(0)) + p * (x.col(2) - x.col(1));
    forces -= pressure.dot(shape) / (n * n) * along_p.cross(along_q) * shape.transpose();
  }
  return forces;
}

Corners random_corners(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  Corners corners = columns({0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
  for (double& value : corners.reshaped()) value += shift(random);
  return corners;
}

}  // namespace

TEST_CASE("a uniform pressure on a rectangle pushes a quarter of its force at each corner",
          "[core][conditions]") {
  const Corners corners = columns({0, 0, 1}, {2, 0, 1}, {2, 3, 1}, {0, 3, 1});
  const Corners forces = pressure_forces(corners, Eigen::Vector4d::Constant(4.0));
  CHECK(forces.isApprox(Eigen::Vector3d(0, 0, -6) * Eigen::RowVector4d::Ones()));
}

TEST_CASE("a pressure that rises along a rectangle is lumped as a linear load", "[core][conditions]") {
  const Corners corners = columns({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  const Corners forces = pressure_forces(corners, {0.0, 6.0, 6.0, 0.0});
  CHECK(forces.row(2).isApprox(Eigen::RowVector4d(-0.5, -1, -1, -0.5)));  // a sixth and a third of 6, halved
}

TEST_CASE("a triangle carries a third of its load at each corner", "[core][conditions]") {
  const Corners corners = columns({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 3, 0});
  const Corners forces = pressure_forces(corners, Eigen::Vector4d::Constant(2.0));
  CHECK(forces.col(0).isApprox(Eigen::Vector3d(0, 0, -2)));
  CHECK(forces.col(1).isApprox(Eigen::Vector3d(0, 0, -2)));
  CHECK((forces.col(2) + forces.col(3)).isApprox(Eigen::Vector3d(0, 0, -2)));
  const Corners pulled = traction_forces(corners, Eigen::Vector4d::Constant(2.0), Eigen::Vector3d::UnitX());
  CHECK(pulled.row(0).head<2>().isApprox(Eigen::RowVector2d(2, 2)));
  CHECK(pulled(0, 2) + pulled(0, 3) == Approx(2.0));
}

TEST_CASE("pressure forces of warped faces are the exact integral", "[core][conditions]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Corners corners = random_corners(seed);
    const Eigen::Vector4d pressure(1.0, -2.0, 3.0, 0.5);
    const Corners exact = pressure_forces(corners, pressure);
    // A midpoint rule of 40 x 40 cells is right to about 1 / (2 x 40^2).
    CHECK((exact - slow_pressure_forces(corners, pressure, 40)).norm() < 1e-3 * exact.norm());
  }
}

TEST_CASE("the closed form of a uniform pressure is the integral", "[core][conditions]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Corners corners = random_corners(seed);
    CHECK(pressure_forces(corners, 1.5).isApprox(pressure_forces(corners, Eigen::Vector4d::Constant(1.5))));
  }
}

TEST_CASE("a uniform pressure adds up to itself times the area vector", "[core][conditions]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Corners x = random_corners(seed);
    const Eigen::Vector3d total = pressure_forces(x, Eigen::Vector4d::Constant(3.0)).rowwise().sum();
    const Eigen::Vector3d expected = -3.0 * area_vector(x.col(0), x.col(1), x.col(2), x.col(3));
    CHECK((total - expected).norm() < 1e-14);
  }
}
