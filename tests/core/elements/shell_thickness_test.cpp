// SPDX-License-Identifier: BSD-3-Clause
// Thickness and bulk viscosity of shells and membranes. Moduli are near 1e11, edges 1, steps of size 1.
#include <cmath>

#include "core/materials/elastic.hpp"
#include "core/materials/linear_hardening.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;

namespace shell_thickness_test {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
constexpr double poissons = (3 * 160e9 - 2 * 80e9) / (2 * (3 * 160e9 + 80e9));
constexpr double thickness = 0.1;

std::vector<const ElementFormulation*> thin_elements() {
  std::vector<const ElementFormulation*> rows;
  for (const auto part : {shell_elements(), membrane_elements()})
    rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

double growth_of(const LoneShell& shell) {
  return shell.state.at(shell.block.layout, 0, shell.block.thickness_growth());
}

/// Stretches by factors along x and y in many steps.
ChunkStep stretch(LoneShell& shell, double x, double y) {
  constexpr int n_steps = 100;
  const Matrix3Xd none = Matrix3Xd::Zero(3, shell.coordinates.cols());
  ChunkStep step{};
  for (int i = 0; i < n_steps; ++i) {
    Matrix3Xd there = shell.coordinates;
    there.row(0) *= std::pow(x, 1.0 / n_steps);
    there.row(1) *= std::pow(y, 1.0 / n_steps);
    step = shell.move_to(there, none);
  }
  return step;
}

}  // namespace

TEST_CASE("the thickness of an elastic shell follows the strain of its surface",
          "[core][shells][membranes]") {
  for (const ElementFormulation* row : thin_elements()) {
    INFO(name_of(*row) << ", rotations " << row->has_rotations);
    LoneShell shell(*row, ElasticLaw{steel}, regular_shell(row->shape), thickness);
    stretch(shell, 1.2, 0.9);
    const double strain = std::log(1.2 * 0.9);
    CHECK(std::log1p(growth_of(shell)) == Approx(-poissons / (1.0 - poissons) * strain).epsilon(1e-4));
    CHECK(stretch(shell, 1.0, 1.0).min_volume == Approx(thickness * (1.0 + growth_of(shell)) * 1.08 *
                                                        (row->n_nodes == 3 ? std::sqrt(0.1875) : 1.0)));
    stretch(shell, 1.0 / 1.2, 1.0 / 0.9);
    CHECK(growth_of(shell) == Approx(0.0).margin(1e-4));  // steps of other middles
  }
}

TEST_CASE("a shell that flows keeps its volume and pulls by its thickness of now",
          "[core][shells][membranes]") {
  constexpr double yield = 1e6;  // next to nothing of it is elastic
  for (const ElementFormulation* row : thin_elements()) {
    if (row->n_nodes == 3) continue;
    INFO(name_of(*row) << ", rotations " << row->has_rotations);
    LoneShell shell(*row, PlasticLaw<LinearHardening>{steel, {yield, 0.0, 0.0}}, regular_shell(row->shape),
                    thickness);
    stretch(shell, 1.5, 1.5);
    CHECK((1.0 + growth_of(shell)) * 2.25 == Approx(1.0).epsilon(1e-4));
    const double pull = 0.5 * yield * thickness / 2.25 * 1.5;  // half of an edge's at each node
    CHECK(shell.forces()(0, 0) == Approx(pull).epsilon(1e-3));
    CHECK(shell.forces()(1, 2) == Approx(-pull).epsilon(1e-3));
  }
}

TEST_CASE("bending alone leaves the thickness of a shell", "[core][shells]") {
  for (const ElementFormulation* row : shell_elements()) {
    const Matrix3Xd x = regular_shell(row->shape);
    LoneShell shell(*row, ElasticLaw{steel}, x, thickness);
    Matrix3Xd turns = Matrix3Xd::Zero(3, x.cols());
    turns.row(1) = 0.01 * x.row(0);
    shell.move_to(x, turns);
    CHECK(shell.moments().norm() > 1e3);
    CHECK(growth_of(shell) == Approx(0.0).margin(1e-14));
  }
}

TEST_CASE("bulk viscosity resists the rate of a shell's area and shortens its step",
          "[core][shells][membranes]") {
  for (const ElementFormulation* row : thin_elements()) {
    if (row->n_nodes == 3) continue;
    INFO(name_of(*row) << ", rotations " << row->has_rotations);
    const Matrix3Xd x = regular_shell(row->shape), none = Matrix3Xd::Zero(3, 4);
    const auto shell_of = [&](double linear, double quadratic) {
      ElementProperties properties = undamped(ElasticLaw{steel});
      properties.linear_bulk_viscosity = linear;
      properties.quadratic_bulk_viscosity = quadratic;
      return LoneShell(make_shell_block(one_element_mesh(row->shape, x), 0, *row, properties, gauss_layers(1),
                                        {&thickness, 1}),
                       x);
    };
    const double direct = 4.0 * 80e9 * (steel.lambda() + 80e9) / (steel.lambda() + 160e9);
    for (const double rate : {100.0, -100.0}) {
      const double dt = 1e-7;
      Matrix3Xd there = x;
      there.row(0) *= 1.0 + rate * dt;
      LoneShell plain = shell_of(0.0, 0.0), viscous = shell_of(0.06, 1.2);
      const ChunkStep before = plain.move_to(there, none, dt), after = viscous.move_to(there, none, dt);
      const double undamped_step = before.stable_step;
      const double share = 0.06 + (rate < 0.0 ? 1.44 * undamped_step * 100.0 : 0.0);
      const double stress = direct * undamped_step * share * rate;
      CHECK(viscous.forces()(0, 0) - plain.forces()(0, 0) == Approx(0.5 * thickness * stress).epsilon(1e-4));
      CHECK(viscous.forces()(1, 0) - plain.forces()(1, 0) == Approx(0.5 * thickness * stress).epsilon(1e-4));
      CHECK(after.viscous_work == Approx(stress * rate * thickness * dt).epsilon(1e-4));
      CHECK(before.viscous_work == 0.0);
      const double z = share * direct / (direct - 80e9);
      CHECK(after.stable_step == Approx(undamped_step * (std::sqrt(1.0 + z * z) - z)).epsilon(1e-4));
    }
  }
}

}  // namespace shell_thickness_test
