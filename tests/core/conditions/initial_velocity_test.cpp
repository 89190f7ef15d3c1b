// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/initial_velocity.hpp"

#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Cubes from 0 to 1 and from 1 to 2 along x that share four nodes.
const Mesh& cubes_at_rest() {
  static const Mesh mesh =
      MeshBuilder().add_hexes({.id = 1}).add_hexes({.id = 2, .origin = {1, 0, 0}}).build();
  return mesh;
}

struct Set {
  Eigen::Matrix3Xd velocity;
  std::string messages;
};

/// The velocities that INITIAL VELOCITY blocks with these lines give at time 2.
Set set(const std::vector<std::string>& blocks) {
  std::string lines;
  for (const std::string& block : blocks) lines += "begin initial velocity\n" + block + "\nend\n";
  ConditionDeck deck(cubes_at_rest(), lines, 2.0);
  Set made{Eigen::Matrix3Xd::Zero(3, cubes_at_rest().n_nodes()), ""};
  set_initial_velocity(deck.scope(), made.velocity);
  made.messages = deck.messages();
  return made;
}

}  // namespace

TEST_CASE("an initial velocity goes along components, a direction or about an axis", "[core][conditions]") {
  CHECK(set({"node = 2\ncomponents = x z\nmagnitude = 3"}).velocity.col(1) == Eigen::Vector3d(3, 0, 3));
  CHECK(set({"node = 2\ndirection = slanted\nmagnitude = -10"})
            .velocity.col(1)
            .isApprox(Eigen::Vector3d(-6, -8, 0)));
  const Set turning = set({"include all blocks\ncylindrical axis = spin\nangular velocity = 2"});
  for (Eigen::Index i = 0; i < turning.velocity.cols(); ++i) {
    const Eigen::Vector3d x = cubes_at_rest().coordinates().col(i);
    CHECK(turning.velocity.col(i).isApprox(Eigen::Vector3d(-2 * x.y(), 2 * x.x(), 0)));
  }
}

TEST_CASE("an initial velocity may be a function of the time or the place", "[core][conditions]") {
  CHECK(set({"block = block_2\ncomponent = y\nfunction = ramp\nscale factor = 4"}).velocity(1, 1) == 8.0);
  const Set varying = set({"include all blocks\ncomponent = y\nfunction = at_x"});
  CHECK(varying.velocity.row(1) == 2.0 * cubes_at_rest().coordinates().row(0));
  CHECK(set({"include all blocks\ncomponent = y\nfunction = bad_at_x"}).messages ==
        "c.i:1:1: error: the initial velocity has no finite value at node 2\n");
}

TEST_CASE("of several initial velocities the last counts, and a change is reported", "[core][conditions]") {
  const std::string at_1 = "block = block_1\ncomponent = x\nmagnitude = 5";
  const Set equal = set({at_1, "block = block_2\ncomponent = x\nmagnitude = 5"});
  CHECK(equal.messages == "");
  CHECK(equal.velocity.row(0).isConstant(5.0));
  const Set other = set({at_1, "block = block_2\ncomponent = x\nmagnitude = 7"});
  CHECK(other.velocity(0, 0) == 5.0);
  CHECK(other.velocity(0, 1) == 7.0);
  CHECK(other.messages ==
        "c.i:6:1: warning: the initial velocity takes the place of the initial velocity at c.i:1:1 at node 2 "
        "and "
        "3 more; of several blocks on a node the last one counts [initial-velocity-replaced]\n");
  const Set apart = set({at_1, "block = block_1\ncomponent = y\nmagnitude = 7"});
  CHECK(apart.velocity.col(0) == Eigen::Vector3d(5, 7, 0));
  CHECK(apart.messages == "");
}
