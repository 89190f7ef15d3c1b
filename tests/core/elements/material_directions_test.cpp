// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/material_directions.hpp"

#include "core/elements/elements.hpp"
#include "core/materials/orthotropic.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

const MaterialLaw ply = make_orthotropic_law({{}, 30.0, 3.0, 2.0, 0.3, 0.25, 0.4, 1.0, 1.5, 0.8});

/// Direction 1 or 2 of the first element.
Vector3d direction(const ModelBlock& block, std::size_t which) {
  return {block.directions[3 * which](0), block.directions[3 * which + 1](0),
          block.directions[3 * which + 2](0)};
}

}  // namespace

TEST_CASE("a solid takes the directions of the system, turned about its axes", "[core][directions]") {
  const Matrix3Xd x = regular_element(Shape::hex8);
  const Mesh mesh = one_element_mesh(Shape::hex8, x);
  ModelBlock block = make_solid_block(mesh, 0, hex8_mean_quadrature, undamped(ply));
  const double root = std::sqrt(0.5);
  CHECK_FALSE(set_directions({{}, {3, 45.0}, {1, 90.0}}, mesh, block));
  CHECK((direction(block, 0) - Vector3d(root, root, 0.0)).norm() < 1e-15);
  CHECK((direction(block, 1) - Vector3d::UnitZ()).norm() < 1e-15);
  const ModelBlockState state = make_state(block);
  for (std::size_t i = 0; i < 6; ++i) CHECK(state.at(block.layout, 0, 6 + i) == block.directions[i](0));
  CoordinateSystem around{
      CoordinateSystemKind::cylindrical, x.rowwise().mean() - Vector3d(0.0, 3.0, 0.0), {}};
  around.axes.setIdentity();
  CHECK_FALSE(set_directions({around, {}, {}}, mesh, block));
  CHECK((direction(block, 0) - Vector3d::UnitY()).norm() < 1e-15);
  CHECK((direction(block, 1) + Vector3d::UnitX()).norm() < 1e-15);
}

TEST_CASE("a shell lays direction 1 into its surface", "[core][directions][shells]") {
  const Matrix3Xd x = regular_shell(Shape::shell4);
  const Mesh mesh = one_element_mesh(Shape::shell4, x);
  const double thickness = 0.1;
  const ElementFormulation& row = *find_shell_element(Shape::shell4, "bt_shell");
  ModelBlock block = make_shell_block(mesh, 0, row, undamped(ply), gauss_layers(), {&thickness, 1});
  const Eigen::Matrix3d frame = row.frame(x);
  // About y by 30 degrees: 1 leaves the surface; about z by 20 degrees before: 1 lies beside x.
  CHECK_FALSE(set_directions({{}, {3, 20.0}, {2, 30.0}}, mesh, block));
  const double angle = 20.0 * std::acos(-1.0) / 180.0;
  const Vector3d expected = frame * Vector3d(std::cos(angle), std::sin(angle), 0.0);
  CHECK((direction(block, 0) - expected).norm() < 1e-14);
  CHECK(direction(block, 1).dot(expected) == Approx(0.0).margin(1e-15));
  const auto lost = set_directions({{}, {2, 90.0}, {}}, mesh, block);
  REQUIRE(lost);
  CHECK(*lost == 0);
}
