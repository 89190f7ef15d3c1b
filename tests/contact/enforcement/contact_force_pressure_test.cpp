// SPDX-License-Identifier: BSD-3-Clause
// PRESSURE FUNCTION MODEL and EXPONENTIAL PRESSURE MODEL, as forces and energies.
#include "contact/enforcement/contact_force.hpp"
#include "support/catch.hpp"
#include "support/law_bodies.hpp"
#include "support/lofted_meshes.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// 200 at 0.01, 1000 at 0.02.
const std::string stiffening = line_function("f", "0 0\n0.01 200\n0.02 1000\n");
const std::string by_function = "begin pressure function model p\nfunction = f\n",
                  exponential =
                      "begin exponential pressure model p\npressure at zero gap = 100\n"
                      "clearance at zero pressure = 0.01\n";

std::string any_form() {
  const std::string enforcement = GENERATE("", "enforcement = momentum_balance\n"),
                    formulation = GENERATE("", "constraint formulation = node_face\n");
  return enforcement + formulation;
}

std::string pressed(const std::string& model, const std::string& more = any_form()) {
  return general_contact("friction model = p\n" + more + "end\n" + model);
}

/// A bounce of the upper body, as if rigid, off the lower one that is held.
struct Bounce {
  double speed = 0.0;    // it leaves with
  double deepest = 0.0;  // penetration
  double least_step = 0.0;
};

Bounce bounce(ContactBodies& bodies, double speed, double mass, double dt) {
  bodies.ask();
  double velocity = -speed, dt_before = dt;
  Bounce found{0.0, 0.0, dt};
  for (int i = 0; i < 20000; ++i) {
    const ForceReport report = bodies.step(dt_before);
    const double next = std::min(dt, report.stable_step);
    found.least_step = std::min(found.least_step, next);
    velocity += 0.5 * (dt_before + next) * lift(bodies) / mass;
    dt_before = next;
    bodies.set_velocity(1, {0, 0, velocity});
    if (i > 10 && velocity > 0.0 && lift(bodies) == 0.0) break;
  }
  found.speed = velocity;
  found.deepest = bodies.contact.histories()[PairIndex{0}].deepest;
  return found;
}

}  // namespace

TEST_CASE("a pressure function presses by the overclosure", "[contact][contact_force][pressure]") {
  const std::string deck = pressed(by_function);
  ContactBodies shallow(stacked_cubes(-0.01), deck, stiffening);
  shallow.ask();
  CHECK(lift(shallow) == Approx(200.0));
  CHECK(shallow.contact.stored() == Approx(1.0));
  CHECK(shallow.net_force().norm() < 1e-10);
  CHECK(shallow.net_moment().norm() < 1e-10);
  ContactBodies deeper(stacked_cubes(-0.015, 2), deck, stiffening);
  deeper.ask();
  CHECK(lift(deeper) == Approx(600.0));
  CHECK(deeper.contact.stored() == Approx(3.0));
  ContactBodies apart(stacked_cubes(0.001), deck, stiffening);
  apart.ask();
  CHECK(lift(apart) == 0.0);
}

TEST_CASE("soft contact begins before touch", "[contact][contact_force][pressure]") {
  const std::string form = any_form();
  ContactBodies table(stacked_cubes(0.005), pressed(by_function, form),
                      line_function("f", "-0.01 0\n0 100\n0.01 300\n"));
  table.ask();
  CHECK(lift(table) == Approx(50.0));
  CHECK(table.contact.stored() == Approx(0.125));
  CHECK(table.contact.points()[0].open_gap() == Approx(0.005));
  CHECK(table.contact.pair_steps()[PairIndex{0}].penetration == 0.0);
  ContactBodies curve(stacked_cubes(0.0), pressed(exponential, form));
  curve.ask();
  CHECK(lift(curve) == Approx(100.0));
  ContactBodies open(stacked_cubes(0.0101), pressed(exponential, form));
  open.ask();
  CHECK(lift(open) == 0.0);
  ContactBodies half(stacked_cubes(0.005), pressed(exponential, form));
  half.ask();
  CHECK(lift(half) == Approx(18.877).epsilon(1e-4));
}

TEST_CASE("soft contact may begin more than half an element before touch",
          "[contact][contact_force][pressure]") {
  ContactBodies bodies(stacked_cubes(0.1), pressed(by_function),
                       line_function("f", "-0.8 0\n0 100\n0.01 300\n"));
  bodies.ask();
  CHECK(lift(bodies) == Approx(87.5));
}

TEST_CASE("gaps are offset before a pressure counts them", "[contact][contact_force][pressure]") {
  ContactBodies offset(stacked_cubes(0.03), pressed(by_function, "contact offset = 0.04\n" + any_form()),
                       stiffening);
  offset.ask();
  CHECK(lift(offset) == Approx(200.0));
  ContactBodies clear(stacked_cubes(0.003), pressed(by_function, "initial clearance = -0.015\n" + any_form()),
                      stiffening);
  clear.ask();
  CHECK(lift(clear) == Approx(600.0));
}

TEST_CASE("a bounce off a pressure function keeps its energy", "[contact][contact_force][pressure]") {
  struct Case {
    std::string model, function;
    double speed;
  };
  const auto [model, function, speed] =
      GENERATE(Case{by_function, stiffening, 0.5}, Case{by_function, stiffening, 3.0},
               Case{by_function, line_function("f", "0 0\n0.01 1\n0.011 1e5\n"), 1.0},
               Case{by_function, line_function("f", "-0.1 0\n0 1e4\n"), 2.0}, Case{exponential, "", 0.05},
               Case{exponential, "", 2.0},
               Case{by_function,
                    "begin function f\ntype is analytic\nevaluate expression is \"1e4 * (exp(50 * x) - 1)\"\n"
                    "end\n",
                    1.0});
  const std::string form = any_form();
  CAPTURE(model, function, speed, form);
  ContactBodies bodies(stacked_cubes(0.11), pressed(model, form), function);
  const Bounce found = bounce(bodies, speed, 10.0, 2e-3);
  CHECK(found.speed == Approx(speed).epsilon(0.02));
  CHECK(std::abs(bodies.contact.histories()[PairIndex{0}].made()) < 0.02 * 5.0 * speed * speed);
}

TEST_CASE("friction goes with the pressure, and its spring bears the step",
          "[contact][contact_force][pressure]") {
  ContactBodies bodies(
      stacked_cubes(-0.01),
      pressed(by_function + "friction coefficient = 0.3\n", "penalty stiffness = 1e5\n" + any_form()),
      stiffening);
  bodies.ask();
  const Vector3d first = force_after(bodies, {1e-9, 0, 0});
  CHECK(first.x() < 0.0);
  CHECK(first.x() > -60.0);
  for (int i = 0; i < 400; ++i) force_after(bodies, {0.0001, 0, 0});
  CHECK(bodies.force_on(1).x() == Approx(-0.3 * lift(bodies)));
}

TEST_CASE("the stable step is that of the slope at the depth to come", "[contact][contact_force][pressure]") {
  const auto step_of = [](const std::string& values) {
    ContactBodies bodies(stacked_cubes(-0.001), pressed(by_function, ""), line_function("f", values));
    return bodies.ask().stable_step;
  };
  const double soft = step_of("0 0\n1 1e3\n"), stiff = step_of("0 0\n1 1e5\n");
  CHECK(stiff < soft);
  CHECK(soft / stiff == Approx(10.0).epsilon(0.2));
}

TEST_CASE("every kind of contact point has the pressure", "[contact][contact_force][pressure]") {
  MeshBuilder rods;
  add_rod(rods, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(rods, {.id = 2, .cells = 3, .from = {0.1, -1, 0.205}, .to = {0.1, 1, 0.205}});
  ContactBodies crossing(rods, pressed(exponential, ""));
  crossing.ask();
  CHECK(lift(crossing) > 0.0);
  ContactBodies bars(crossed_bars(0.005), pressed(exponential, ""));
  bars.ask();
  CHECK(lift(bars) > 0.0);
  Region region = parse_region(
      "begin analytic object floor\ntype = plane\nnormal direction = 0 0 1\norigin = 0 0 0\nend\n");
  region.contact = parse_contact(
      "contact surface body contains block_1\ncontact surface wall contains floor\n"
      "begin interaction\nsurfaces = wall body\nfriction model = p\nend\n" +
      exponential + "end\n");
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .origin = {0, 0, 0}, .size = {1, 1, 1}});
  ContactBodies on_plane(b, region);
  on_plane.ask();
  CHECK(on_plane.force_on(0).z() == Approx(100.0));
}
