// SPDX-License-Identifier: BSD-3-Clause
// SIDES = TOP or BOTTOM: which side of shells takes part in a pair.
#include "contact/enforcement/contact_force.hpp"
#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace contact_force_sides_test {

namespace {

const std::string stiff = "penalty stiffness = 1e4\n";

std::string deck(const std::string& lines) {
  return "skin all blocks = on\nbegin interaction\nside a = block_1\nside b = block_2\n" + lines + "end\n";
}

/// A shell of 4 x 4 elements at z 0, 0.1 thick, whose normal looks along z, and a cube, 0.4 wide.
MeshBuilder cube_beside_shell(double z) {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {4, 4}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.1);
  return b.add_hexes({.id = 2, .origin = {0.7, 0.8, z}, .size = {0.4, 0.4, 0.4}, .share_nodes = false});
}

/// The largest force on the way, and the height of the cube's bottom at the first one.
struct Passage {
  double force = 0.0, at = 0.0;
};

Passage pass(ContactBodies& bodies, double way, double from) {
  Passage found;
  constexpr int n_steps = 400;
  bodies.set_velocity(1, {0, 0, way / n_steps});
  bodies.ask();
  for (int i = 0; i < n_steps; ++i) {
    bodies.step(1.0);
    const double force = bodies.force_on(1).norm();
    if (force > 0.0 && found.force == 0.0) found.at = from + (i + 1) * way / n_steps;
    found.force = std::max(found.force, force);
  }
  return found;
}

}  // namespace

TEST_CASE("a cube from below passes the top of a shell, one from above meets it",
          "[contact][contact_force][sides]") {
  const std::string lines = stiff + formulation();
  const auto [sides, is_from_above] =
      GENERATE(std::pair("top", true), std::pair("norm", true), std::pair("bottom", false),
               std::pair("revnorm", false), std::pair("sneg", false));
  const std::string row = (std::string(sides).find("norm") != std::string::npos ? "morient = " : "sides = ");
  ContactBodies from_below(cube_beside_shell(-0.6), deck(lines + row + sides + "\n"));
  ContactBodies from_above(cube_beside_shell(0.2), deck(lines + row + sides + "\n"));
  const Passage up = pass(from_below, 1.0, -0.6), down = pass(from_above, -1.0, 0.2);
  CHECK((up.force == 0.0) == is_from_above);
  CHECK((down.force == 0.0) == !is_from_above);
  // By the face of the shell, which is half of its thickness off the middle.
  if (is_from_above) CHECK(down.at == Approx(0.05).margin(0.003));
  if (!is_from_above) CHECK(up.at == Approx(-0.45).margin(0.003));
}

TEST_CASE("both sides of a shell take part without a word", "[contact][contact_force][sides]") {
  const std::string lines = stiff + formulation() + GENERATE("", "sides = both\n", "morient = opengap\n");
  ContactBodies from_below(cube_beside_shell(-0.6), deck(lines));
  ContactBodies from_above(cube_beside_shell(0.2), deck(lines));
  CHECK(pass(from_below, 0.3, -0.6).force > 0.0);
  CHECK(pass(from_above, -0.3, 0.2).force > 0.0);
}

TEST_CASE("lofts that overlap by as much as half of them part by the side that is named",
          "[contact][contact_force][sides]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {5, 5}, .u = {10, 0, 0}, .v = {0, 10, 0}}, 2.0);
  add_plate(b, {.id = 2, .cells = {5, 5}, .origin = {0, 0, 1.0}, .u = {10, 0, 0}, .v = {0, 10, 0}}, 2.0);
  const std::string lines = stiff + formulation();
  ContactBodies by_top(b, deck(lines + "sides = top\n"));
  by_top.ask();
  CHECK(by_top.force_on(1).z() == Approx(1e6));
  CHECK(by_top.net_force().norm() < 1e-6);
  ContactBodies by_chance(b, deck(lines));
  by_chance.ask();
  CHECK(by_chance.force_on(1).z() == 0.0);
  // The side is of SIDE A: the other way round the lower plate's top is asked for all the same.
  ContactBodies turned(b, "skin all blocks = on\nbegin interaction\nside a = block_2\nside b = block_1\n" +
                              lines + "sides = bottom\nend\n");
  turned.ask();
  CHECK(turned.force_on(1).z() == Approx(1e6));
}

TEST_CASE("without sides of an interaction all its shells have theirs", "[contact][contact_force][sides]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {2, 2}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.2);
  add_plate(b, {.id = 2, .cells = {2, 2}, .origin = {0, 0, 0.19}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.2);
  ContactBodies both(b, general_contact(stiff + formulation()));
  both.ask();
  CHECK(both.force_on(1).z() == Approx(400.0));
  ContactBodies tops(b, general_contact(stiff + formulation() + "sides = top\n"));
  tops.ask();
  CHECK(tops.force_size() == 0.0);
}

}  // namespace contact_force_sides_test
