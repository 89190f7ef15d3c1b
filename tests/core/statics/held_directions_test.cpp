// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/held_directions.hpp"

#include "support/catch.hpp"
#include "support/static_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A cube whose node 5 cannot move along x.
struct GuidedCube {
  GuidedCube() {
    PrescribedMotion hold;
    hold.direction = Components{{true, false, false}};
    hold.nodes = {{5}};
    cube.model.kinematic_constraints = KinematicConstraints(cube.mesh, {hold});
  }
  void find() { held.find(cube.model, cube.problem->bodies(), 0.0); }

  StaticCube cube;
  HeldDirections held{3 * Eigen::Index{cube.mesh.n_nodes()}, false};
};

}  // namespace

TEST_CASE("vectors lose what lies along held directions", "[core][statics]") {
  GuidedCube guided;
  guided.find();
  Eigen::VectorXd vector = Eigen::VectorXd::Ones(guided.cube.problem->size());
  guided.held.project(vector);
  CHECK(vector(15) == 0.0);
  vector(15) = 1.0;
  CHECK(vector == Eigen::VectorXd::Ones(vector.size()));
}

TEST_CASE("projections are looked up by node, displacement or rotation", "[core][statics]") {
  GuidedCube guided;
  guided.held.set_lifeless({{7}});
  guided.find();
  const FreeProjections free(guided.held, guided.cube.mesh.n_nodes());
  REQUIRE(free.find(5, false) != nullptr);
  CHECK(*free.find(5, false) == Eigen::Matrix3d(Eigen::Vector3d(0.0, 1.0, 1.0).asDiagonal()));
  CHECK(free.find(5, true) == nullptr);
  CHECK(free.find(6, false) == nullptr);
  REQUIRE(free.find(7, false) != nullptr);
  CHECK(free.find(7, false)->isZero(0.0));
}

TEST_CASE("lifeless nodes are held at once, or with what conditions hold", "[core][statics]") {
  GuidedCube guided;
  guided.find();
  guided.held.set_lifeless({{5}, {8}});
  CHECK(guided.held.displacements().size() == 1);
  guided.held.hold_lifeless();
  REQUIRE(guided.held.displacements().size() == 2);
  for (const FreeDirections& node : guided.held.displacements()) CHECK(node.projection.isZero(0.0));
  guided.held.set_lifeless({});
  guided.find();
  REQUIRE(guided.held.displacements().size() == 1);
  CHECK(guided.held.displacements()[0].projection.trace() == 2.0);
}
