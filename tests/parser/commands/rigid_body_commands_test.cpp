// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/rigid_body_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

TEST_CASE("a rigid body may be empty", "[parser][rigid body]") {
  const ParsedDeck deck = parsed_sierra("begin rigid body 1\nend rigid body 1\n");
  CHECK(deck.messages == "");
  const RigidBodyDefinition& body = deck.simulation.rigid_bodies.at(0);
  CHECK(body.name.text == "1");
  CHECK_FALSE(body.reference_location);
  CHECK_FALSE(body.mass);
  CHECK(std::isnan(body.magnitude));
}

TEST_CASE("a rigid body is bound", "[parser][rigid body]") {
  const ParsedDeck deck = parsed_sierra(
      "begin rigid body rb\n"
      "  reference location = 1.0, 2.0, 3.0\n"
      "  include nodes in nodelist_1 nodelist_2\n"
      "  mass = 4\n"
      "  inertia = 1 2 3 4 5 6\n"
      "  point mass = 0.5 at location 0 0 1\n"
      "  point mass = 0.25 at location 0 1 0\n"
      "  magnitude = 10\n"
      "  direction = down\n"
      "  angular velocity = 20\n"
      "  cylindrical axis = spin\n"
      "end\n");
  CHECK(deck.messages == "");
  const RigidBodyDefinition& body = deck.simulation.rigid_bodies.at(0);
  CHECK(body.reference_location == Eigen::Vector3d(1, 2, 3));
  CHECK(body.node_sets.size() == 2);
  CHECK(body.mass == 4.0);
  CHECK(body.inertia == std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  REQUIRE(body.point_masses.size() == 2);
  CHECK(body.point_masses[1].mass == 0.25);
  CHECK(body.point_masses[1].location == Eigen::Vector3d(0, 1, 0));
  CHECK(body.magnitude == 10.0);
  CHECK(body.direction->text == "down");
  CHECK(body.angular_velocity == 20.0);
  CHECK(body.cylindrical_axis->text == "spin");
}

TEST_CASE("too few numbers of an inertia are reported", "[parser][rigid body]") {
  CHECK(parsed_sierra("begin rigid body rb\n  inertia = 1 2 3\nend\n").messages ==
        "a.i:3:3: error: expected a number after 'inertia', found the end of the line\n");
}
