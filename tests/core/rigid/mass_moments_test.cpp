// SPDX-License-Identifier: BSD-3-Clause
#include "core/rigid/mass_moments.hpp"

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_shell.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A brick of 1 x 2 x 3 with its corner in the origin.
MassMoments brick_of(MeshBuilder builder, const ElementFormulation& element) {
  const Mesh mesh = builder.build();
  const ModelBlock block = make_solid_block(mesh, 0, element, {ElasticLaw{{1.0, 1.0}}, 2.0});
  return mass_moments(block, mesh, {0.5, 1.0, 1.5});
}

}  // namespace

TEST_CASE("the moments of a brick are exact for any cells", "[core][rigid]") {
  const Box box{.cells = {2, 1, 3}, .size = {1, 2, 3}};
  const MassMoments bricks[] = {brick_of(MeshBuilder().add_hexes(box), hex8_mean_quadrature),
                                brick_of(MeshBuilder().add_tets(box), tet4_mean_quadrature),
                                brick_of(MeshBuilder().add_ten_node_tets(box), tet10_composite),
                                brick_of(MeshBuilder().add_wedges(box), wedge6_mean_quadrature),
                                brick_of(MeshBuilder().add_pyramids(box), pyramid5_mean_quadrature)};
  for (const MassMoments& moments : bricks) {
    CHECK(moments.mass == Approx(12.0));
    CHECK(moments.first.norm() < 1e-12);
    const Eigen::Matrix3d inertia = inertia_of(moments.second);
    CHECK(inertia.diagonal().isApprox(Eigen::Vector3d(4 + 9, 1 + 9, 1 + 4), 1e-12));
    CHECK((inertia - Eigen::Matrix3d(inertia.diagonal().asDiagonal())).norm() < 1e-12);
  }
}

TEST_CASE("the moments of a sheet of shells are those of a thin brick", "[core][rigid]") {
  const Mesh mesh = MeshBuilder().add_shells({.cells = {3, 2}, .u = {1, 0, 0}, .v = {0, 2, 0}}).build();
  const std::vector<double> thickness(6, 0.3);
  const ModelBlock block =
      make_shell_block(mesh, 0, shell4_bt_shell, {ElasticLaw{{1.0, 1.0}}, 2.0}, gauss_layers(), thickness);
  const MassMoments moments = mass_moments(block, mesh, {0.5, 1.0, 0.0});
  CHECK(moments.mass == Approx(1.2));
  const Eigen::Matrix3d inertia = inertia_of(moments.second);
  CHECK(inertia.diagonal().isApprox(Eigen::Vector3d(4 + 0.09, 1 + 0.09, 1 + 4) * 0.1, 1e-12));
}

TEST_CASE("point masses of a rigid body count with their inertia", "[core][rigid][springs]") {
  const Mesh mesh = MeshBuilder().add_spheres(1, "", {Eigen::Vector3d(1, 2, 3)}).build();
  const double none = 1.0;
  ModelBlock block = make_discrete_block(mesh, 0, sphere_point_mass, 5.0, {&none, 1});
  block.discrete.inertia << 2.0, 0.1, 0.0, 0.1, 3.0, 0.0, 0.0, 0.0, 4.0;
  const MassMoments moments = mass_moments(block, mesh, {0.0, 2.0, 3.0});
  CHECK(moments.mass == 5.0);
  CHECK(moments.first == Eigen::Vector3d(5, 0, 0));
  Eigen::Matrix3d expected = block.discrete.inertia;
  expected(1, 1) += 5.0;
  expected(2, 2) += 5.0;
  CHECK(inertia_of(moments.second).isApprox(expected, 1e-12));
}
