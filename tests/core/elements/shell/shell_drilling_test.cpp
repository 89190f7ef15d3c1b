// SPDX-License-Identifier: BSD-3-Clause
// Shells with DRILLING STIFFNESS FACTOR. Moduli are near 1e11, edges near 1, steps of size 1.
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

constexpr double drilled_thickness = 0.05;

/// A warped and distorted shell that resists drilling.
LoneShell drilled_shell(const ElementFormulation& row) {
  ShellSettings settings = gauss_layers();
  settings.drilling = 0.1;
  const Matrix3Xd x = rotation_of(0.7) * distorted(regular_shell(row.shape), 0.1, 4);
  return LoneShell(row, ElasticLaw{{160e9, 80e9}}, x, drilled_thickness, settings);
}

}  // namespace

TEST_CASE("fibres that turn about themselves are held by drilling stiffness", "[core][shells][drilling]") {
  for (const ElementFormulation* row : shell_elements()) {
    INFO(name_of(*row));
    const LoneShell shell = drilled_shell(*row);
    const Eigen::MatrixXd stiffness = stiffness_of(shell);
    const Eigen::VectorXd ascending = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                          0.5 * (stiffness + stiffness.transpose()), Eigen::EigenvaluesOnly)
                                          .eigenvalues();
    const double bending = 1e11 * drilled_thickness * drilled_thickness * drilled_thickness;
    CHECK(ascending.head(6).cwiseAbs().maxCoeff() < 5e-4 * bending);  // rigid motions
    CHECK(ascending(6) > 2e-3 * bending);
  }
}

TEST_CASE("one node that turns feels its share of the shear stiffness", "[core][shells][drilling]") {
  for (const ElementFormulation* row : shell_elements()) {
    INFO(name_of(*row));
    ShellSettings settings = gauss_layers();
    settings.drilling = 0.1;
    const Matrix3Xd x = regular_shell(row->shape);
    LoneShell shell(*row, ElasticLaw{{160e9, 80e9}}, x, drilled_thickness, settings);
    Matrix3Xd turns = Matrix3Xd::Zero(3, x.cols());
    turns(2, 0) = 0.01;
    const ChunkStep step = shell.move_to(x, turns);
    const double volume = step.min_volume,
                 moment = 0.01 * 0.1 * 80e9 * volume / static_cast<double>(x.cols());
    CHECK(shell.moments()(2, 0) == Approx(-moment));
    CHECK(shell.moments().rightCols(x.cols() - 1).norm() < 1e-9 * moment);
    CHECK(step.hourglass_work == Approx(0.5 * 0.01 * moment));
  }
}

TEST_CASE("drilling neither moves nor turns a shell as a whole, and turns with it",
          "[core][shells][drilling]") {
  for (const ElementFormulation* row : shell_elements()) {
    INFO(name_of(*row));
    LoneShell shell = drilled_shell(*row);
    const Matrix3Xd x = shell.coordinates;
    shell.move_to(distorted(x, 0.01, 2), random_turns(x.cols(), 0.01, 3));
    const Matrix3Xd force = shell.forces(), moment = shell.moments();
    CHECK(force.rowwise().sum().norm() < 1e-13 * force.norm());
    CHECK(total_moment(shell).norm() < 1e-12 * force.norm());

    const Matrix3Xd there = shell.coordinates;
    for (int i = 1; i <= 5; ++i) shell.move_to(rotation_of(0.3 * i) * there, turns_of(0.3, x.cols()));
    CHECK((shell.forces() - rotation_of(1.5) * force).norm() < 1e-12 * force.norm());
    CHECK((shell.moments() - rotation_of(1.5) * moment).norm() < 1e-12 * force.norm());
  }
}

TEST_CASE("drilling's forces and moments are the derivatives of the work", "[core][shells][drilling]") {
  for (const ElementFormulation* row : shell_elements()) {
    INFO(name_of(*row));
    LoneShell shell = drilled_shell(*row);
    const Eigen::Index n = shell.coordinates.cols();
    for (unsigned i = 1; i <= 4; ++i)
      shell.move_to(distorted(shell.coordinates, 0.01, i), random_turns(n, 0.01, 7 + i));
    check_derivatives_of_work(shell, 1e-8 * 1e11);
  }
}

TEST_CASE("the stable step of a shell that resists drilling is below that of its highest frequency",
          "[core][shells][drilling]") {
  for (const ElementFormulation* row : shell_elements()) {
    for (const double factor : {0.01, 1.0, 100.0}) {
      INFO(name_of(*row) << ", factor " << factor);
      ShellSettings settings = gauss_layers();
      settings.drilling = factor;
      const Matrix3Xd x = distorted(regular_shell(row->shape), 0.1, 4);
      LoneShell shell(*row, ElasticLaw{{160e9, 80e9}}, x, drilled_thickness, settings);
      const double limit = stable_limit(shell), bound = shell.stay().stable_step;
      CHECK(bound <= (1.0 + 1e-6) * limit);
      CHECK(bound > 0.6 * limit);
    }
  }
}
