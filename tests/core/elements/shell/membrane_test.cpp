// SPDX-License-Identifier: BSD-3-Clause
// What every membrane must do. Moduli are near 1e11, edges near 1, steps of size 1.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
constexpr double thickness = 0.05;
constexpr double size_of_forces = 1e11 * thickness;

/// Calls check(shell) for every row, in the plane or warped.
template <class Check>
void for_each_membrane(const Check& check) {
  for (const ElementFormulation* row : membrane_elements()) {
    for (const double warp : {0.0, 0.1}) {
      INFO(name_of(*row) << ", warp " << warp);
      Matrix3Xd x = distorted(regular_shell(row->shape), 0.15, 4);
      x.row(2) = distorted(Matrix3Xd::Zero(3, x.cols()), warp, 9).row(2);
      check(LoneShell(*row, ElasticLaw{steel}, rotation_of(0.7) * x, thickness, gauss_layers(1)));
    }
  }
}

ChunkStep move(LoneShell& shell, const Matrix3Xd& there) {
  return shell.move_to(there, Matrix3Xd::Zero(3, there.cols()));
}

/// A square membrane under the same tension both ways.
LoneShell tensed_square(double strain) {
  const Matrix3Xd x = regular_shell(Shape::quad4);
  LoneShell shell(*find_membrane_element(Shape::quad4), ElasticLaw{steel}, x, thickness, gauss_layers(1));
  move(shell, (1.0 + strain) * x);
  return shell;
}

}  // namespace

TEST_CASE("a rigid motion of a membrane strains nothing and turns its forces", "[core][membranes]") {
  for_each_membrane([](LoneShell shell) {
    const Matrix3Xd x = shell.coordinates;
    for (int i = 1; i <= 5; ++i) move(shell, (rotation_of(0.3 * i) * x).colwise() + Vector3d(1.0 * i, 2, 3));
    CHECK(shell.forces().norm() < 1e-13 * size_of_forces);
    move(shell, x);
    const Matrix3Xd there = distorted(x, 1e-3, 2) * 1.01;
    move(shell, there);
    const Matrix3Xd before = shell.forces();
    REQUIRE(before.norm() > 1e-3 * size_of_forces);
    for (int i = 1; i <= 5; ++i) move(shell, rotation_of(0.3 * i) * there);
    CHECK((shell.forces() - rotation_of(1.5) * before).norm() < 1e-12 * size_of_forces);
  });
}

TEST_CASE("forces of a membrane balance, and it has no moments", "[core][membranes]") {
  for_each_membrane([](LoneShell shell) {
    move(shell, 1.01 * distorted(shell.coordinates, 0.01, 2));
    const Matrix3Xd force = shell.forces();
    CHECK(force.rowwise().sum().norm() < 1e-13 * force.norm());
    CHECK(total_moment(shell).norm() < 1e-12 * force.norm());
    CHECK(shell.state.moments.empty());
    CHECK(shell.block.inertia.empty());
  });
}

TEST_CASE("forces of a membrane are the derivatives of the work", "[core][membranes]") {
  for_each_membrane([](LoneShell shell) {
    for (unsigned i = 1; i <= 4; ++i) move(shell, 1.005 * distorted(shell.coordinates, 0.002, i));
    check_derivatives_of_work(shell, 1e-6 * size_of_forces);
  });
}

TEST_CASE("tension flattens a warped membrane as the full integral of it does", "[core][membranes]") {
  LoneShell shell = tensed_square(1e-3);
  const double tension = shell.stress(0)(0, 0), height = 1e-3;
  Matrix3Xd there = shell.coordinates;
  there.row(2) += Eigen::RowVector4d(height, -height, height, -height);
  const double before = shell.state.at(shell.block.layout, 0, shell.block.layout.energy());
  move(shell, there);
  REQUIRE(tension > 1e7);
  // (tension t / 2) times the integral of the squared slope of height xi eta: 8/3 height^2 for any square.
  CHECK(shell.forces()(2, 0) == Approx(-0.25 * tension * thickness * 8.0 / 3.0 * height).epsilon(2e-3));
  CHECK(shell.forces()(2, 1) == Approx(-shell.forces()(2, 0)).epsilon(1e-9));
  CHECK(before > 0.0);

  LoneShell pressed = tensed_square(-1e-3);
  there = pressed.coordinates;
  there.row(2) += Eigen::RowVector4d(height, -height, height, -height);
  move(pressed, there);
  CHECK(std::abs(pressed.forces()(2, 0)) < 1e-9 * size_of_forces * height);  // it does not fold by itself
}

TEST_CASE("the stable step of a membrane is below that of its highest frequency", "[core][membranes]") {
  for_each_membrane([](LoneShell shell) {
    const Eigen::Index n = 3 * shell.coordinates.cols();
    constexpr double h = 1e-7;
    Eigen::MatrixXd stiffness(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      LoneShell moved = shell;
      Matrix3Xd there = shell.coordinates;
      there(i) += h;
      move(moved, there);
      stiffness.col(i) = -moved.forces().reshaped() / h;
    }
    const double mass = shell.block.mass[0](0) / static_cast<double>(shell.coordinates.cols());
    const double limit = 2.0 / std::sqrt((0.5 * (stiffness + stiffness.transpose())).operatorNorm() / mass);
    const double bound = shell.stay().stable_step;
    CHECK(bound <= (1.0 + 1e-5) * limit);
    CHECK(bound > 0.6 * limit);
  });
}
