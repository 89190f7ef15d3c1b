// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("point masses have their density as mass, and no step of their own", "[core][springs]") {
  const Mesh mesh = MeshBuilder().add_spheres(1, "", {{0, 0, 0}, {1, 0, 0}}).build();
  const std::vector<double> sizes(2, 0.3);
  for (const ElementFormulation* row : {&sphere_point_mass, &sphere_point_inertia}) {
    const ModelBlock block = make_discrete_block(mesh, 0, *row, 5.0, sizes);
    CHECK(block.mass[0](0) == 5.0);
    CHECK(block.mass[0](1) == 5.0);
    CHECK_FALSE(row->has_material());
    CHECK(row->step_rule == StepRule::none);
    CHECK(row->has_rotations == (row == &sphere_point_inertia));
    ModelBlockState state = make_state(block);
    const Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Constant(3, 2, 7.0);
    const ChunkStep step =
        row->advance(block, block.chunks[0], {0.0, 1.0, mesh.coordinates(), v, 1.0, &v}, state);
    CHECK(step.stable_step == std::numeric_limits<double>::infinity());
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, 2);
    block.sums.add(state.forces, forces);
    CHECK(forces.isZero(0.0));
  }
}
