// SPDX-License-Identifier: BSD-3-Clause
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace contact_force_laws_test {

namespace {

const std::string stiff = "penalty stiffness = 1000\n", node_face = "constraint formulation = node_face\n";

/// A cube over a plate of 3 x 3 cells.
MeshBuilder cube_over_plate(double gap) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  return b.add_hexes({.id = 2, .origin = {0.7, 1.2, 1.0 + gap}, .share_nodes = false});
}

}  // namespace

TEST_CASE("tied bodies keep their gap as they turn and pull when they are drawn apart",
          "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ContactBodies bodies(cube_over_plate(0.05),
                       general_contact("friction model = tied\n" + stiff + formulation));
  bodies.ask();
  CHECK(bodies.forces.norm() < 1e-11);
  CHECK(!bodies.contact.ties().empty());
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.01, Vector3d(1, 2, 3).normalized()).matrix();
  for (int step = 0; step < 150; ++step) {
    const Eigen::Matrix3Xd before = bodies.x;
    bodies.v = turn * before - before;
    bodies.step(1.0);
    CHECK(bodies.forces.norm() < 1e-9);
  }
  const Vector3d up = Eigen::AngleAxisd(1.5, Vector3d(1, 2, 3).normalized()) * Vector3d::UnitZ();
  bodies.shift(1, 0.01 * up);
  bodies.ask();
  CHECK(bodies.net_force().norm() < 1e-10);
  CHECK(bodies.net_moment().norm() < 1e-9);
  const Vector3d on_cube = bodies.force_on(1);
  CHECK((on_cube - on_cube.dot(up) * up).norm() < 1e-9);
  CHECK(on_cube.dot(up) < 0.0);
  if (formulation.empty()) CHECK(on_cube.dot(up) == Approx(-1000.0 * 0.01));
}

TEST_CASE("bodies that have touched under a glued model hold each other from then on",
          "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ContactBodies bodies(
      cube_over_plate(0.005),
      general_contact("friction model = sticky\n" + stiff + formulation + "end\nbegin glued model sticky\n"));
  bodies.ask();
  CHECK(bodies.contact.ties().empty());
  bodies.set_velocity(1, {0, 0, -0.01});
  bodies.step(1.0);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(!bodies.contact.ties().empty());
  const std::size_t n_ties = bodies.contact.ties().size();
  bodies.set_velocity(1, {0, 0, 0.02});
  bodies.step(1.0);
  CHECK(bodies.force_on(1).z() < 0.0);
  if (formulation.empty()) CHECK(bodies.force_on(1).z() == Approx(-1000.0 * 0.02));
  CHECK(bodies.net_force().norm() < 1e-10);
  bodies.set_velocity(1, {0.01, 0, 0});
  bodies.step(1.0);
  CHECK(bodies.force_on(1).x() < 0.0);
  CHECK(bodies.contact.ties().size() == n_ties);
}

TEST_CASE("what a glued place holds when it is tied stays with its pair", "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ContactBodies bodies(
      cube_over_plate(0.005),
      general_contact("friction model = sticky\n" + stiff + formulation + "end\nbegin glued model sticky\n"));
  const auto work = [&] {
    double sum = 0.0;
    for (const PairHistory& history : bodies.contact.histories()) sum += history.work;
    return sum;
  };
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -0.01});
  bodies.step(1.0);
  const double before = work();
  CHECK(before == Approx(0.5 * 1000.0 * 0.005 * 0.005).epsilon(0.003));  // areas of both ways are iterated
  bodies.set_velocity(1, {0, 0, 0});
  bodies.step(1.0);
  CHECK(!bodies.contact.ties().empty());
  CHECK(work() == Approx(before));
}

TEST_CASE("contact acts in its periods only, ties too", "[contact][contact_force]") {
  const std::string law = GENERATE(std::string(), std::string("friction model = tied\n"));
  Region region;
  region.contact = parse_contact(general_contact(law + stiff));
  region.contact->periods.inactive = {{"second", {}}};
  TimeSteppingBlock first, second;
  first.name = {"first", {}};
  first.start_time = 0.0;
  second.name = {"second", {}};
  second.start_time = 1.0;
  const std::vector<TimeSteppingBlock> blocks{first, second};
  ContactBodies bodies(cube_over_plate(law.empty() ? -0.1 : 0.05), region);
  ContactForce force({*bodies.region.contact, bodies.definition, bodies.model, blocks});
  const auto norm_at = [&](double time) {
    force.set_forces({time, time > 0.0 ? 0.1 : 0.0, bodies.x, bodies.v, 1.0}, bodies.forces);
    return bodies.forces.norm();
  };
  norm_at(0.0);
  bodies.shift(1, {0, 0, law.empty() ? 0.0 : 0.01});
  CHECK(norm_at(0.5) > 1.0);
  CHECK(norm_at(1.5) == 0.0);
  CHECK(force.points().empty());
  for (const ConstraintForces& held : force.constraint_forces()) CHECK(held.forces.forces.norm() == 0.0);
}

}  // namespace contact_force_laws_test
