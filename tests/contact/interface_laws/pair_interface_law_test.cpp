// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/pair_interface_law.hpp"

#include "support/catch.hpp"
#include "support/law_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

std::vector<TimeSteppingBlock> two_periods() {
  std::vector<TimeSteppingBlock> blocks(2);
  blocks[0].name = {"first", {}};
  blocks[0].start_time = 0.0;
  blocks[1].name = {"second", {}};
  blocks[1].start_time = 1.0;
  return blocks;
}

const std::string rub = "begin constant friction model rub\nfriction coefficient = 0.3\nend\n";

}  // namespace

TEST_CASE("a time variant model rubs in one period and ties in the next", "[contact][interface_law]") {
  const std::string formulation = GENERATE(std::string(), by_nodes);
  ContactBodies bodies(law_mesh(-0.01),
                       law_deck("begin time variant model m\nmodel = rub during periods first\n"
                                "model = tied during periods second\nend\n" +
                                    rub,
                                formulation),
                       "", two_periods());
  bodies.ask();
  Vector3d force = force_after(bodies, {0.05, 0, 0}, 0.5);
  CHECK(force.x() == Approx(-0.3 * 10.0));
  CHECK(force.z() == Approx(10.0));
  CHECK(bodies.contact.ties().empty());
  bodies.time = 0.9;
  force = force_after(bodies, {0, 0, 0}, 0.1);  // the second period begins: tied as it is
  CHECK(!bodies.contact.ties().empty());
  CHECK(force.norm() < 1e-9);
  force = force_after(bodies, {0.01, 0, 0});
  CHECK(force.x() == Approx(-1000.0 * 0.01));
  CHECK(std::abs(force.z()) < 1e-9);
}

TEST_CASE("what sticks does not slip however far it is moved, and parts freely", "[contact][interface_law]") {
  const std::string formulation = GENERATE(std::string(), by_nodes);
  ContactBodies bodies(law_mesh(-0.01), law_deck("begin stick model m\nend\n", formulation));
  bodies.ask();
  Vector3d force = force_after(bodies, {0.2, 0, 0});
  CHECK(force.x() == Approx(-1000.0 * 0.2));
  CHECK(force.z() == Approx(10.0));
  force = force_after(bodies, {0, 0, 0.02});
  CHECK(force.norm() < 1e-9);
}

TEST_CASE("a period that a time variant model does not name is frictionless", "[contact][interface_law]") {
  ContactBodies bodies(law_mesh(-0.01),
                       law_deck("begin time variant model m\nmodel = tied during periods first\nend\n"), "",
                       two_periods());
  bodies.ask();
  CHECK(bodies.contact.ties().size() == 1);
  force_after(bodies, {0.01, 0, 0}, 0.5);
  const Vector3d force = force_after(bodies, {0.01, 0, 0}, 0.5);
  CHECK(bodies.contact.ties().empty());
  CHECK(std::abs(force.x()) < 1e-9);
  CHECK(force.z() == Approx(10.0));
}

TEST_CASE("a hybrid model ties what is close at the start and lets the rest slide",
          "[contact][interface_law]") {
  const std::string formulation = GENERATE(std::string(), by_nodes);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  b.add_hexes({.id = 2, .origin = {0.2, 0.2, 1.0}, .share_nodes = false});
  b.add_hexes({.id = 3, .origin = {1.8, 1.8, 1.5}, .share_nodes = false});
  ContactBodies bodies(
      b,
      "contact surface plate contains block_1\ncontact surface tops contains block_2 block_3\n"
      "begin interaction\nside a = plate\nside b = tops\nfriction model = m\n"
      "penalty stiffness = 1000\n" +
          formulation + "end\n" + rub +
          "begin hybrid model m\ninitially close = tied\ninitially far = rub\nend\n");
  bodies.ask();
  CHECK(!bodies.contact.ties().empty());
  bodies.set_velocity(2, {0, 0, -0.51});
  bodies.step(1.0);
  bodies.set_velocity(1, {0, 0, 0.01});
  bodies.set_velocity(2, {0.05, 0, 0});
  bodies.step(1.0);
  CHECK(bodies.force_on(1).z() == Approx(-10.0));
  CHECK(bodies.force_on(2).z() == Approx(10.0));
  CHECK(bodies.force_on(2).x() == Approx(-3.0));
}

TEST_CASE("pressure and slip rate make the friction of a pv dependent model", "[contact][interface_law]") {
  const std::string formulation = GENERATE(std::string(), by_nodes);
  ContactBodies bodies(law_mesh(-0.01),
                       law_deck("begin pv_dependent model m\nstatic coefficient = 0.5\n"
                                "dynamic coefficient = 0.1\nvelocity decay = 2\nreference pressure = 10\n"
                                "offset pressure = 5\npressure exponent = 2\nend\n",
                                formulation));
  bodies.ask();
  // Pressure 10 = 1000 x 0.01; at slip rate 0.5 mu = 0.1 + 0.4 / e; ((10 + 5) / 10)^2 = 2.25.
  const Vector3d force = force_after(bodies, {0.05, 0, 0});
  CHECK(force.x() == Approx(-2.25 * (0.1 + 0.4 * std::exp(-1.0))));
  CHECK(force.z() == Approx(10.0));
  const Vector3d slower = force_after(bodies, {0.01, 0, 0});
  CHECK(slower.x() == Approx(-2.25 * (0.1 + 0.4 * std::exp(-0.2))));
  CHECK(friction_work(bodies) > 0.0);
}

TEST_CASE("a junction pulls by its gap and holds along the surface by its slip rate",
          "[contact][interface_law]") {
  const std::string formulation = GENERATE(std::string(), by_nodes, both_ways);
  ContactBodies bodies(law_mesh(0.02),
                       law_deck("begin junction model m\nnormal traction function = pull\n"
                                "tangential traction function = drag\ntangential traction scale factor = 2\n"
                                "normal cutoff distance for tangential traction = 0.05\nend\n",
                                formulation),
                       line_function("pull", "0 0\n0.1 20\n") + line_function("drag", "0 0.5\n1 1.5\n"));
  bodies.ask();
  CHECK(bodies.force_on(1).z() == Approx(-4.0));
  Vector3d force = force_after(bodies, {0.05, 0, 0});
  CHECK(force.z() == Approx(-4.0));
  CHECK(force.x() == Approx(-2.0 * 1.0));  // 2 x drag(0.5)
  CHECK(bodies.net_force().norm() < 1e-10);
  CHECK(bodies.net_moment().norm() < 1.0001 * 2.0 * 0.02);  // the force along the surface over the gap
  force = force_after(bodies, {0.05, 0, 0.04});
  CHECK(force.z() == Approx(-12.0));
  CHECK(std::abs(force.x()) < 1e-9);
  force = force_after(bodies, {0.05, 0, -0.07});
  CHECK(force.z() == Approx(10.0));
  CHECK(force.x() == Approx(-2.0));
  force = force_after(bodies, {0, 0, 0.12});
  CHECK(force.norm() < 1e-9);
}

TEST_CASE("an adhesion model pulls over a gap and pushes without friction", "[contact][interface_law]") {
  const std::string formulation = GENERATE(std::string(), by_nodes, both_ways);
  ContactBodies bodies(law_mesh(0.05),
                       law_deck("begin adhesion model m\nadhesion function = stick\n"
                                "adhesion scale factor = 3\nend\n",
                                formulation),
                       line_function("stick", "0 2\n0.1 0\n"));
  bodies.ask();
  CHECK(bodies.force_on(1).z() == Approx(-3.0));
  const double before = bodies.contact.histories().front().work;
  Vector3d force = force_after(bodies, {0.05, 0, -0.03});
  CHECK(force.z() == Approx(-4.8));
  CHECK(std::abs(force.x()) < 1e-9);
  // From 3 to 4.8 over 0.03: what the pull has done is missing in the potential.
  CHECK(bodies.contact.histories().front().work - before == Approx(-0.5 * (3.0 + 4.8) * 0.03));
  force = force_after(bodies, {0.05, 0, -0.03});
  CHECK(force.z() == Approx(10.0));
  CHECK(std::abs(force.x()) < 1e-9);
  force = force_after(bodies, {0, 0, 0.12});
  CHECK(force.norm() < 1e-9);
  CHECK(bodies.contact.histories().front().work == Approx(0.0).margin(1e-12));
  force = force_after(bodies, {0, 0, -0.06});
  CHECK(force.z() == Approx(-3.0));
}

TEST_CASE("an adhesion model pulls at an analytic plane", "[contact][interface_law]") {
  Region region = parse_region(
      "begin analytic object floor\ntype = plane\nnormal direction = 0 0 1\n"
      "origin = 0 0 0\nend\n");
  region.contact = parse_contact(
      "contact surface body contains block_1\ncontact surface wall contains floor\n"
      "begin interaction\nsurfaces = wall body\nfriction model = m\npenalty stiffness = 1000\nend\n"
      "begin adhesion model m\nadhesion function = stick\nend\n");
  MeshBuilder b;
  b.add_hexes({.id = 1, .origin = {0, 0, 0.05}});
  ContactBodies bodies(b, region, line_function("stick", "0 6\n0.1 0\n"));
  bodies.ask();
  CHECK(bodies.force_on(0).z() == Approx(-3.0));
}
