// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/stored_values.hpp"

#include "core/conditions/external_force.hpp"
#include "core/conditions/kinematic_constraints.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const Mesh& cube_with_values() {
  static const Mesh mesh =
      MeshBuilder()
          .add_hexes({.id = 1})
          .add_side_set(1, "top", [](const CandidateSide& s) { return s.centroid.z() == 1; })
          .build();
  return mesh;
}

/// The times 0, 1 and 3; at them p is 1, 2 and 4 at every node, d_x the node's position, d_y ten times the
/// time.
StoredVariables results() {
  StoredVariables stored;
  stored.times = {0.0, 1.0, 3.0};
  stored.nodal.names = {"p", "d_x", "d_y"};
  stored.nodal.read = [times = stored.times](std::size_t variable, std::size_t time) {
    std::vector<double> values(8, variable == 0 ? times[time] + 1.0 : 10.0 * times[time]);
    for (std::size_t i = 0; variable == 1 && i < 8; ++i) values[i] = static_cast<double>(i);
    return values;
  };
  stored.element.read = stored.nodal.read;
  return stored;
}

/// The accelerations from rest, over a step of 0.5 from 1 on, under the lines of a prescribed velocity.
struct Driven {
  explicit Driven(const std::string& lines, bool has_results = true) {
    const StoredVariables stored = results();
    ConditionDeck deck(cube_with_values(), "begin prescribed velocity\n" + lines + "end\n", 0.0,
                       has_results ? &stored : nullptr);
    const KinematicConstraints kinematic_constraints = make_kinematic_constraints(deck.scope());
    messages = deck.messages();
    const Eigen::Matrix3Xd rest = Eigen::Matrix3Xd::Zero(3, 8);
    acceleration = rest;
    kinematic_constraints.constrain({1.0, 1.5, 0.5, cube_with_values().coordinates(), rest}, acceleration);
  }
  Eigen::Matrix3Xd acceleration;  ///< equals the velocity: half of both steps is 1 [time]
  std::string messages;
};

Eigen::Matrix3Xd forces(const std::string& lines) {
  const StoredVariables stored = results();
  ConditionDeck deck(cube_with_values(), lines, 0.0, &stored);
  ExternalForce force = make_external_force(deck.scope(), Eigen::RowVectorXd::Ones(8));
  REQUIRE(deck.messages() == "");
  Eigen::Matrix3Xd made(3, 8);
  force.set_forces({2.0, 0.1, cube_with_values().coordinates(), cube_with_values().coordinates()}, made);
  return made;
}

}  // namespace

TEST_CASE("a condition follows what the mesh file stores, linearly between its times", "[core][conditions]") {
  const std::string lines = "node = 3 7\ncomponents = x z\nread variable = P\nscale factor = 2\n";
  CHECK(Driven(lines).acceleration.col(2).isApprox(Eigen::Vector3d(4.5, 0, 4.5)));  // p(1.25) = 2.25
  CHECK(Driven(lines + "time = last\n").acceleration.col(6) == Eigen::Vector3d(8, 0, 8));
  CHECK(Driven(lines + "time = 2\n").acceleration.col(6) == Eigen::Vector3d(6, 0, 6));
  CHECK(Driven(lines).acceleration.col(1).isZero(0.0));
}

TEST_CASE("each component reads its own variable when there is no common one", "[core][conditions]") {
  const Driven driven("node = 3 7\ncomponents = x y\nread variable = d\n");
  CHECK(driven.messages == "");
  CHECK(driven.acceleration.col(6).isApprox(Eigen::Vector3d(6, 12.5, 0)));
  CHECK(driven.acceleration.col(2).isApprox(Eigen::Vector3d(2, 12.5, 0)));
}

TEST_CASE("loads may be read from the mesh file", "[core][conditions]") {
  const Eigen::Matrix3Xd pushed =
      forces("begin prescribed force\nnode = 2\ncomponents = x y\nread variable = d\nend\n");
  CHECK(pushed.col(1).isApprox(Eigen::Vector3d(1, 20, 0)));
  const Eigen::Matrix3Xd pressed =
      forces("begin pressure\nsurface = top\nread variable = p\nobject type = node\nend\n");
  CHECK(pressed.rowwise().sum().isApprox(Eigen::Vector3d(0, 0, -3)));
}

TEST_CASE("what the mesh file does not store cannot be read", "[core][conditions]") {
  const std::string lines = "node = 1\ncomponents = x z\nread variable = ";
  CHECK(Driven(lines + "dd\n").messages == "c.i:4:17: error: the mesh file has no nodal variable 'dd'\n");
  CHECK(Driven(lines + "d\n").messages ==
        "c.i:4:17: error: the mesh file has no nodal variable 'd'; did you mean 'p'?\n");
  CHECK(Driven(lines + "p\n", false).messages ==
        "c.i:4:17: error: the mesh file holds no results to read from\n");
  CHECK(Driven(lines + "p\nobject type = face\n").messages ==
        "c.i:4:17: error: the prescribed velocity can read nodal variables only; write OBJECT TYPE = NODE\n");
}
