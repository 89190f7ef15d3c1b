// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/step_forces.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A cube whose cap is a rigid body; forces of a node are (1, 2, 4) at the start and ten times as large now.
struct ForcedCube {
  CappedCube cube;
  StaticBodies bodies{cube.model, cube.state};
  StaticUnknowns unknowns{cube.model, bodies.n_nodes(), false};
  StepStart start;

  ForcedCube() {
    set_forces(1.0);
    start.remember(cube.state);
    bodies.begin_step();
    set_forces(10.0);
  }
  void set_forces(double size) {
    const Eigen::Index n = cube.state.coordinates.cols();
    cube.state.forces.internal = Eigen::Matrix3Xd::Constant(3, n, size);
    cube.state.forces.external = Eigen::Matrix3Xd::Constant(3, n, 2.0 * size);
    cube.state.forces.contact = Eigen::Matrix3Xd::Constant(3, n, 4.0 * size);
  }
  StepForces forces() const { return {unknowns, bodies, cube.state, start}; }
  Eigen::Index n_of_mesh() const { return 3 * cube.state.coordinates.cols(); }
  bool are_of_mesh(const Eigen::VectorXd& vector, double value) const {
    return (vector.head(n_of_mesh()).array() == value).all() &&
           vector.tail(vector.size() - n_of_mesh()).isZero(0.0);
  }
};

}  // namespace

TEST_CASE("the forces of a step are those of its start, of now and their means", "[core][statics]") {
  const ForcedCube cube;
  CHECK(cube.are_of_mesh(cube.forces().at_start(&NodalForces::external), 2.0));
  CHECK(cube.are_of_mesh(cube.forces().now(&NodalForces::external), 20.0));
  CHECK(cube.are_of_mesh(cube.forces().mean(&NodalForces::external), 11.0));
  CHECK(cube.are_of_mesh(cube.forces().all(), 70.0));
}

TEST_CASE("forces are summed over the nodes of a rigid body", "[core][statics]") {
  const ForcedCube cube;
  const auto& nodes = cube.cube.model.rigid.bodies[0].nodes;
  const auto n = static_cast<double>(nodes.size());
  REQUIRE(n > 1.0);
  const Eigen::Index centre = 3 * Eigen::Index{cube.bodies.centre_node(0)};
  for (const auto& [sums, size] : {std::pair{cube.forces().all_at_start(), 7.0},
                                   std::pair{cube.forces().gathered(cube.forces().all()), 70.0}}) {
    for (Eigen::Index i = 0; i < 3; ++i) CHECK(sums(centre + i) == Approx(n * size));
    for (const NodeIndex node : nodes) CHECK(sums.segment<3>(3 * Eigen::Index{node.value}).isZero(0.0));
    // All others keep theirs.
    CHECK(sums.head(cube.n_of_mesh()).sum() ==
          Approx(size * (static_cast<double>(cube.n_of_mesh()) - 3.0 * n)));
  }
}
