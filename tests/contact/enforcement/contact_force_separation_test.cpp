// SPDX-License-Identifier: BSD-3-Clause
// SEPARATION = OFF: what has touched pulls across a gap, and slides.
#include "contact/enforcement/contact_force.hpp"
#include "core/dynamics/state.hpp"
#include "support/catch.hpp"
#include "support/law_bodies.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace contact_force_separation_test {

namespace {

const std::string held = "penalty stiffness = 1e4\nseparation = off\n";

/// A unit cube over a plate of 6 x 6 x 1 cells, each 0.5 wide.
MeshBuilder cube_on_plate(double gap, int n = 1) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {6, 6, 1}, .size = {3, 3, 1}});
  return b.add_hexes({.id = 2, .cells = {n, n, n}, .origin = {0.75, 1.1, 1.0 + gap}, .share_nodes = false});
}

void move(ContactBodies& bodies, const Vector3d& way, int n_steps = 20) {
  bodies.set_velocity(1, way / n_steps);
  for (int i = 0; i < n_steps; ++i) bodies.step(1.0);
  bodies.set_velocity(1, Vector3d::Zero());
  bodies.step(1.0);
}

}  // namespace

TEST_CASE("what has touched pulls when it is drawn up", "[contact][contact_force][separation]") {
  const std::string form = formulation();
  // Areas of nodes of both sides are iterated; those of faces are exact.
  const double rounded_areas = form.empty() ? 1e-9 : 0.005;
  ContactBodies bodies(cube_on_plate(0.0005), general_contact(held + form));
  bodies.ask();
  move(bodies, {0, 0, 0.0005});
  CHECK(lift(bodies) == 0.0);  // it has not touched yet
  move(bodies, {0, 0, -0.0015});
  CHECK(lift(bodies) == Approx(5.0).epsilon(rounded_areas));
  move(bodies, {0, 0, 0.0015});
  CHECK(lift(bodies) == Approx(-10.0).epsilon(rounded_areas));
  CHECK(bodies.net_force().norm() < 1e-10);
  CHECK(bodies.net_moment().norm() < 1e-9);
  CHECK(bodies.contact.stored() == Approx(0.005).epsilon(rounded_areas));
  ContactBodies parting(cube_on_plate(-0.0005), general_contact("penalty stiffness = 1e4\n" + form));
  parting.ask();
  move(parting, {0, 0, 0.0015});
  CHECK(parting.force_size() == 0.0);
}

TEST_CASE("what may not part slides freely, to other faces too", "[contact][contact_force][separation]") {
  const int n = GENERATE(1, 3);
  ContactBodies bodies(cube_on_plate(-0.0005, n), general_contact(held + formulation()));
  bodies.ask();
  move(bodies, {0, 0, 0.0015});
  move(bodies, {0.1, 0, 0});
  CHECK(lift(bodies) == Approx(-10.0).epsilon(0.01));
  CHECK(std::abs(bodies.force_on(1).x()) < 1e-9);
  move(bodies, {0.9, -0.75, 0}, 60);
  CHECK(lift(bodies) == Approx(-10.0).epsilon(0.01));
  CHECK(bodies.force_on(1).head<2>().norm() < 1e-9);
}

TEST_CASE("friction of what may not part is of what presses", "[contact][contact_force][separation]") {
  const std::string rough = "friction model = r\n",
                    model = "end\nbegin constant friction model r\nfriction coefficient = 0.5\n";
  ContactBodies bodies(cube_on_plate(-0.001), general_contact(held + rough + formulation() + model));
  bodies.ask();
  move(bodies, {0.02, 0, 0}, 400);
  CHECK(bodies.force_on(1).x() == Approx(-5.0).epsilon(0.01));
  move(bodies, {0, 0, 0.002});
  move(bodies, {0.05, 0, 0});
  CHECK(bodies.force_on(1).x() == 0.0);
  CHECK(lift(bodies) == Approx(-10.0).epsilon(0.01));
}

TEST_CASE("a pull ends where the gap is wider than the search reaches",
          "[contact][contact_force][separation]") {
  ContactBodies bodies(cube_on_plate(-0.001),
                       general_contact(held + "normal tolerance = 0.05\n" + formulation()));
  bodies.ask();
  move(bodies, {0, 0, 0.041});
  CHECK(lift(bodies) == Approx(-400.0).epsilon(0.01));
  move(bodies, {0, 0, 0.02});
  CHECK(lift(bodies) == 0.0);
  move(bodies, {0, 0, -0.03});  // it has to touch again
  CHECK(lift(bodies) == 0.0);
}

TEST_CASE("nodes that have touched a plane are held to it", "[contact][contact_force][separation]") {
  Region region = parse_region(
      "begin analytic object floor\ntype = plane\nnormal direction = 0 0 1\norigin = 0 0 0\nend\n");
  region.contact = parse_contact(
      "contact surface body contains block_1\ncontact surface wall contains floor\n"
      "begin interaction\nsurfaces = wall body\n" +
      held + "end\n");
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .origin = {0, 0, -0.001}, .size = {1, 1, 1}});
  ContactBodies bodies(b, region);
  bodies.ask();
  bodies.set_velocity(0, {0.1, 0, 0.002});
  bodies.step(1.0);
  CHECK(bodies.force_on(0).z() == Approx(-10.0));
  CHECK(bodies.force_on(0).head<2>().norm() < 1e-12);
}

TEST_CASE("momentum balance holds what has touched", "[contact][contact_force][separation]") {
  const std::string lines = "separation = off\n" + formulation();
  ContactBodies bodies(cube_on_plate(0.0), general_contact("enforcement = momentum_balance\n" + lines));
  constexpr double dt = 0.01;
  State state = make_state(bodies.x, bodies.model.blocks, 0.0);
  state.dt = state.next_dt = dt;
  state.acceleration = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
  bodies.ask();
  const auto step_at = [&](const Vector3d& velocity) {
    bodies.set_velocity(1, velocity);
    state.velocity = bodies.v;
    state.coordinates = bodies.x;
    bodies.dt = dt;
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
    bodies.contact.set_forces(bodies.motion(), forces);
    REQUIRE(bodies.contact.balance(state, forces));
    bodies.forces = forces;
    return forces;
  };
  // In the air, before it has touched, it flies off freely.
  CHECK(step_at({0, 0, 0.1}).isZero(1e-12));
  CHECK(step_at({0, 0, -0.1}).norm() > 0.0);
  const Eigen::Matrix3Xd pulled = step_at({0.2, 0, 0.1});
  CHECK(lift(bodies) < 0.0);
  CHECK(std::abs(bodies.force_on(1).x()) < 1e-9);
  CHECK(bodies.net_force().norm() < 1e-9 * pulled.norm());
  // The sides keep together: along the normal nothing is left of their motion against each other.
  const Eigen::Matrix3Xd after =
      state.velocity + dt * pulled.cwiseQuotient(bodies.model.mass.replicate<3, 1>());
  double of_cube = 0.0, of_plate = 0.0;
  int n_cube = 0;
  for (Eigen::Index i = 0; i < after.cols(); ++i) {
    if (bodies.x(2, i) != 1.0) continue;
    const bool is_cube = i >= after.cols() - 8;
    if (is_cube) of_cube += after(2, i), ++n_cube;
    if (!is_cube && bodies.forces(2, i) != 0.0) of_plate = std::max(of_plate, after(2, i));
  }
  CHECK(n_cube == 4);
  CHECK(of_cube / n_cube < 0.07);
  CHECK(of_plate > 0.01);
}

}  // namespace contact_force_separation_test
