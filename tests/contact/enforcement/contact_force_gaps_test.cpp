// SPDX-License-Identifier: BSD-3-Clause
// CONTACT OFFSET, INITIAL CLEARANCE, IGNORE INITIAL OVERLAP and OVERLAP RAMP TIME, as forces.
#include "contact/enforcement/contact_force.hpp"
#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string stiff = "penalty stiffness = 1e4\n";

/// Moves a block in many steps.
void move(ContactBodies& bodies, std::size_t block, const Vector3d& way) {
  constexpr int n_steps = 200;
  bodies.set_velocity(block, way / n_steps);
  for (int i = 0; i < n_steps; ++i) bodies.step(1.0);
  bodies.set_velocity(block, Vector3d::Zero());
}

/// Moves the upper cube and asks anew.
double lift_after(ContactBodies& bodies, const Vector3d& way) {
  move(bodies, 1, way);
  return lift(bodies);
}

}  // namespace

TEST_CASE("a contact offset is taken off every gap", "[contact][contact_force][gaps]") {
  const std::string line = stiff + "contact offset = 0.04\n" + formulation();
  ContactBodies near(stacked_cubes(0.03), general_contact(line));
  near.ask();
  CHECK(lift(near) == Approx(100.0));
  CHECK(near.net_force().norm() < 1e-10);
  CHECK(near.net_moment().norm() < 1e-10);

  ContactBodies far(stacked_cubes(0.1), general_contact(line));
  far.ask();
  CHECK(lift(far) == 0.0);
  CHECK(lift_after(far, {0, 0, -0.0599}) == 0.0);
  CHECK(lift_after(far, {0, 0, -0.0011}) == Approx(10.0));
}

TEST_CASE("an offset of more than half an element is contact too", "[contact][contact_force][gaps]") {
  const std::string line = GENERATE("contact offset = 0.6\n", "initial clearance = -0.57\n");
  ContactBodies bodies(stacked_cubes(0.03), general_contact(stiff + line + formulation()));
  bodies.ask();
  CHECK(lift(bodies) == Approx(5700.0));
  CHECK(lift_after(bodies, {0, 0, -0.01}) == Approx(5800.0));
}

TEST_CASE("a negative contact offset lets sides overlap by it", "[contact][contact_force][gaps]") {
  ContactBodies bodies(stacked_cubes(-0.03),
                       general_contact(stiff + "contact offset = -0.02\n" + formulation()));
  bodies.ask();
  CHECK(lift(bodies) == Approx(100.0));
}

TEST_CASE("an initial clearance counts whatever the mesh says", "[contact][contact_force][gaps]") {
  const std::string more = stiff + formulation();
  ContactBodies wider(stacked_cubes(0.003), general_contact(more + "initial clearance = 0.01\n"));
  wider.ask();
  CHECK(lift(wider) == 0.0);
  CHECK(lift_after(wider, {0, 0, -0.0099}) == 0.0);
  CHECK(lift_after(wider, {0, 0, -0.0011}) == Approx(10.0));

  ContactBodies narrower(stacked_cubes(0.2), general_contact(more + "initial clearance = 0.01\n"));
  narrower.ask();
  CHECK(lift(narrower) == 0.0);
  CHECK(lift_after(narrower, {0, 0, -0.011}) == Approx(10.0));

  ContactBodies overlapping(stacked_cubes(0.003), general_contact(more + "initial clearance = -0.001\n"));
  overlapping.ask();
  CHECK(lift(overlapping) == Approx(10.0));
}

TEST_CASE("an initial clearance reaches as far as SEARCH DISTANCE says", "[contact][contact_force][gaps]") {
  const bool has_distance = GENERATE(true, false);
  const std::string reach = has_distance ? "search distance = 0.6\n" : "";
  ContactBodies bodies(stacked_cubes(0.5, 2),
                       general_contact(stiff + formulation() + "initial clearance = 0.01\n" + reach));
  bodies.ask();
  CHECK(lift_after(bodies, {0, 0, -0.011}) == Approx(has_distance ? 10.0 : 0.0));
}

TEST_CASE("an ignored overlap of the start pushes only by what closes further",
          "[contact][contact_force][gaps]") {
  ContactBodies bodies(stacked_cubes(-0.01, 2),
                       general_contact(stiff + "ignore initial overlap = on\n" + formulation()));
  bodies.ask();
  CHECK(bodies.force_size() == 0.0);
  CHECK(lift_after(bodies, {0, 0, -0.005}) == Approx(50.0));
  // Wherever it slides: half of it is over the lower cube still.
  CHECK(lift_after(bodies, {0.5, 0, 0}) == Approx(25.0).epsilon(0.01));
  CHECK(lift_after(bodies, {0, 0, 0.006}) == 0.0);
}

TEST_CASE("a wedge of overlap that is ignored pushes nowhere", "[contact][contact_force][gaps]") {
  ContactBodies bodies(stacked_cubes(0.0, 4),
                       general_contact(stiff + "ignore initial overlap = on\n" + formulation()));
  const Eigen::RowVectorXd down = 0.05 * bodies.x.row(0);
  for (Eigen::Index i = 125; i < bodies.x.cols(); ++i) bodies.x(2, i) -= down[i];
  bodies.ask();
  CHECK(bodies.force_size() < 1e-9);
  // All of the unit area is closed by 0.01 more than its deepest point, or than the node's own.
  CHECK(lift_after(bodies, {0, 0, -0.02}) > 100.0);
}

TEST_CASE("overlaps of the start come in over their ramp", "[contact][contact_force][gaps]") {
  ContactBodies bodies(stacked_cubes(-0.01, 2),
                       general_contact(stiff + "overlap ramp time = 0.1\n" + formulation()));
  bodies.ask();
  CHECK(bodies.force_size() == 0.0);
  for (int i = 1; i <= 20; ++i) {
    bodies.step(0.01);
    CHECK(lift(bodies) == Approx(100.0 * std::min(1.0, 0.1 * i)));
  }
}

TEST_CASE("gaps to an analytic plane are offset alike", "[contact][contact_force][gaps]") {
  struct Case {
    std::string line;
    double z, down, force;  // of the start; moved down; lift then
  };
  const auto [line, z, down, force] = GENERATE(Case{"contact offset = 0.04\n", 0.03, 0.0, 100.0},
                                               Case{"contact offset = 0.04\n", 0.03, 0.01, 200.0},
                                               Case{"initial clearance = 0.01\n", 0.003, 0.011, 10.0},
                                               Case{"initial clearance = -0.001\n", 0.003, 0.0, 10.0},
                                               Case{"ignore initial overlap = on\n", -0.01, 0.005, 50.0},
                                               Case{"overlap ramp time = 0.1\n", -0.01, 0.0, 0.0});
  Region region = parse_region(
      "begin analytic object floor\ntype = plane\nnormal direction = 0 0 1\norigin = 0 0 0\nend\n");
  region.contact = parse_contact(
      "contact surface body contains block_1\ncontact surface wall contains floor\n"
      "begin interaction\nsurfaces = wall body\n" +
      stiff + line + "end\n");
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .origin = {0, 0, z}, .size = {1, 1, 1}});
  ContactBodies bodies(b, region);
  bodies.ask();
  if (down > 0.0) move(bodies, 0, {0, 0, -down});
  CHECK(bodies.force_on(0).z() == Approx(force).margin(1e-5));
}

TEST_CASE("gaps of crossing rods are offset alike", "[contact][contact_force][gaps]") {
  struct Case {
    std::string line;
    double gap, down;
    bool is_pushed;
  };
  const auto [line, gap, down, is_pushed] =
      GENERATE(Case{"", -0.01, 0.0, true}, Case{"", 0.01, 0.0, false},
               Case{"contact offset = 0.02\n", 0.01, 0.0, true},
               Case{"ignore initial overlap = on\n", -0.01, 0.0, false},
               Case{"ignore initial overlap = on\n", -0.01, 0.001, true},
               Case{"overlap ramp time = 1\n", -0.01, 0.0, false},
               Case{"initial clearance = -0.001\n", 0.005, 0.0, true});
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(b, {.id = 2, .cells = 3, .from = {0.1, -1, 0.2 + gap}, .to = {0.1, 1, 0.2 + gap}});
  ContactBodies bodies(b, general_contact(stiff + line));
  bodies.ask();
  if (down > 0.0) move(bodies, 1, {0, 0, -down});
  CHECK((lift(bodies) > 0.0) == is_pushed);
}

TEST_CASE("sharp edges feel a contact offset", "[contact][contact_force][gaps]") {
  ContactBodies bodies(crossed_bars(0.01), general_contact(stiff + "contact offset = 0.02\n"));
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
}
