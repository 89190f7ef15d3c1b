// SPDX-License-Identifier: BSD-3-Clause
// Rows of nodes that turn; those of nodes that only move are in output_table_test.cpp.
#include "support/row_values.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A run whose nodes turn: of node 2 every rotational vector is another one.
struct TurningRun : SampleRun {
  TurningRun() {
    const Eigen::Matrix3Xd none = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
    NodalRotations& r = state.rotations;
    r.angle = r.velocity = r.acceleration = r.moments.internal = r.moments.external = none;
    model.inertia = Eigen::RowVectorXd::Constant(mesh.n_nodes(), 0.5);
    r.angle.col(2) << 1, 2, 3;
    r.velocity.col(2) << 4, 5, 6;
    r.acceleration.col(2) << 8, 0, -2;
    r.moments.internal.col(2) << 3, 1, 0;
    r.moments.external.col(2) << -1, 0, 7;
  }
};

const std::vector<std::string> rotational{
    "rotational_displacement", "rotational_velocity", "rotational_acceleration", "moment_external",
    "moment_internal",         "moment_contact",      "reaction_moment"};

}  // namespace

TEST_CASE("accelerations are those of the state", "[core][output]") {
  SampleRun run;
  run.state.acceleration.col(3) << 1, -2, 3;
  check_close(nodal(run, "acceleration", 3), {1, -2, 3});
  check_close(nodal(run, "acceleration", 2), {0, 0, 0});
}

TEST_CASE("rotational variables of a model in which nothing turns are zero", "[core][output]") {
  const SampleRun run;
  for (const std::string& name : rotational) {
    CAPTURE(name);
    check_close(nodal(run, name, 2), {0, 0, 0});
  }
  check_close(nodal(run, "rotational_mass", 2), {0});
}

TEST_CASE("rotational variables by hand", "[core][output]") {
  TurningRun run;
  check_close(nodal(run, "rotational_displacement", 2), {1, 2, 3});
  check_close(nodal(run, "rotational_velocity", 2), {4, 5, 6});
  check_close(nodal(run, "rotational_acceleration", 2), {8, 0, -2});
  check_close(nodal(run, "moment_external", 2), {-1, 0, 7});
  check_close(nodal(run, "moment_internal", 2), {-3, -1, 0});  // as the elements resist
  check_close(nodal(run, "moment_contact", 2), {0, 0, 0});     // there is no contact
  run.state.rotations.moments.contact = Eigen::Matrix3Xd::Constant(3, run.mesh.n_nodes(), 2.0);
  check_close(nodal(run, "moment_contact", 2), {2, 2, 2});
  for (const std::string& name : rotational) {
    if (name != "moment_contact") check_close(nodal(run, name, 1), {0, 0, 0});
  }
}

TEST_CASE("a rotational mass next to none counts as none", "[core][output]") {
  TurningRun run;
  run.model.inertia(1) = minimum_nodal_mass;
  check_close(nodal(run, "rotational_mass", 2), {0.5});
  CHECK(nodal(run, "rotational_mass", 1) == std::vector<double>{0.0});
}

TEST_CASE("what holds a node from turning is the reaction moment", "[core][output]") {
  TurningRun run;
  PrescribedMotion held;
  held.nodes = {{2}};
  run.model.rotation_constraints = KinematicConstraints(run.mesh, {held});
  // inertia x acceleration - (internal + external) = (4, 0, -1) - (2, 1, 7)
  check_close(nodal(run, "reaction_moment", 2), {2, -1, -8});
  run.state.rotations.acceleration.col(1) << 1, 1, 1;
  check_close(nodal(run, "reaction_moment", 1), {0, 0, 0});  // free
}
