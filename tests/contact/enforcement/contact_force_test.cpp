// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_force.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace contact_force_test {

namespace {

const std::string stiff = "penalty stiffness = 1000\n", node_face = "constraint formulation = node_face\n";

/// A plate of n x n unit cells and another one of cells of a width on it, 0.5 from its edges.
///   tets  0: of hexahedra; 5, 6: of so many tetrahedra to a cell; 10: of tetrahedra of ten nodes
MeshBuilder two_plates(int n, double width, int tets = 0) {
  MeshBuilder b;
  const double size = n;
  const int m = static_cast<int>((size - 1.0) / width + 0.5);
  b.add_hexes({.id = 1, .cells = {n, n, 1}, .size = {size, size, 1}});
  const test::Box upper{.id = 2,
                        .cells = {m, m, 1},
                        .origin = {0.5, 0.5, 1.0},
                        .size = {size - 1.0, size - 1.0, 1},
                        .share_nodes = false};
  if (tets == 10) return b.add_ten_node_tets(upper);
  return tets > 0 ? b.add_tets(upper, tets) : b.add_hexes(upper);
}

/// Moves all nodes at random, and the second block down.
void disturb(ContactBodies& bodies, double size, double down) {
  Random random(7);
  for (Eigen::Index i = 0; i < bodies.x.cols(); ++i) bodies.x.col(i) += random_vector(random, size);
  bodies.shift(1, {0, 0, -down});
}

}  // namespace

TEST_CASE("contact adds no net force and no net moment to bodies with warped faces",
          "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face + "tangential tolerance = 0\n");
  const int tets = GENERATE(0, 5, 10);
  // A node behind the edge of a hollow is pushed from beside it: depth times distance, of few nodes.
  const double moment_share = formulation.empty() ? 1e-11 : 1e-4;
  ContactBodies bodies(two_plates(4, 0.75, tets), general_contact(stiff + formulation));
  disturb(bodies, 0.05, 0.1);
  bodies.ask();
  CHECK(bodies.force_size() > 100.0);
  CHECK(bodies.net_force().norm() < 1e-13 * bodies.force_size());
  CHECK(bodies.net_moment().norm() < moment_share * bodies.force_size());
  CHECK((bodies.force_on(0) + bodies.force_on(1)).norm() < 1e-13 * bodies.force_size());
  CHECK(bodies.force_on(1).z() > 0.5 * bodies.force_size() / 2.0);
  CHECK((bodies.contact.pair_steps()[{0}].force - bodies.force_on(0)).norm() < 1e-10);
}

TEST_CASE("friction and damping add no net force", "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ContactBodies bodies(two_plates(4, 0.75),
                       general_contact(stiff + formulation +
                                       "contact damping fraction = 0.1\nfriction model = rough\nend\n"
                                       "begin constant friction model rough\nfriction coefficient = 0.4\n"));
  disturb(bodies, 0.05, 0.1);
  bodies.ask();
  bodies.set_velocity(1, {0.02, 0.01, -0.01});
  for (int step = 0; step < 5; ++step) {
    const ForceReport report = bodies.step(1.0);
    CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
    CHECK(report.friction_work >= 0.0);
    CHECK(report.contact_damping_work > 0.0);
  }
  const Vector3d on_upper = bodies.force_on(1);
  CHECK(on_upper.x() < 0.0);
  CHECK(on_upper.head<2>().norm() < 0.45 * on_upper.z());
  CHECK(on_upper.head<2>().norm() > 0.1 * on_upper.z());
}

TEST_CASE("surfaces kept apart by next to nothing push each other not at all", "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  ContactBodies bodies(two_plates(4, 0.75), general_contact(stiff + formulation));
  bodies.shift(1, {0, 0, 1e-9});
  bodies.ask();
  CHECK(bodies.forces == Eigen::Matrix3Xd::Zero(3, bodies.x.cols()));
  bodies.v.colwise() = Vector3d(3, 4, 5);
  bodies.step(0.1);
  CHECK(bodies.forces == Eigen::Matrix3Xd::Zero(3, bodies.x.cols()));
  bodies.shift(1, {0, 0, -2e-9});
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
}

TEST_CASE("a plate one element thick does not touch itself", "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {8, 8, 1}, .size = {8, 8, 0.02}});
  ContactBodies bodies(b, "skin all blocks = on\nbegin interaction defaults\nself contact = on\n" + stiff +
                              formulation + "end\n");
  bodies.ask();
  CHECK(bodies.forces.norm() == 0.0);
  Random random(1);
  for (int step = 0; step < 5; ++step) {
    for (Eigen::Index i = 0; i < bodies.x.cols(); ++i) bodies.v.col(i) = random_vector(random, 0.002);
    bodies.step(1.0);
    CHECK(bodies.forces.norm() == 0.0);
  }
}

TEST_CASE("cubes that share an edge do not touch beside it", "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {1, 1, 0}});
  b.add_hexes({.id = 3, .origin = {2, 1, 0}});
  ContactBodies bodies(b, general_contact("self contact = on\n" + stiff + formulation));
  bodies.ask();
  CHECK(bodies.forces.norm() == 0.0);
  Random random(2);
  for (int step = 0; step < 5; ++step) {
    for (Eigen::Index i = 0; i < bodies.x.cols(); ++i) bodies.v.col(i) = random_vector(random, 0.02);
    bodies.step(1.0);
    CHECK(bodies.forces.norm() == 0.0);
  }
}

TEST_CASE("a cube that lands on the edge of a plate is pushed up and not aside", "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
  b.add_hexes({.id = 2, .origin = {1.75, 0.5, 1.01}, .share_nodes = false});
  ContactBodies bodies(b, general_contact(stiff + formulation));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -0.005});
  for (int step = 0; step < 12; ++step) {
    bodies.step(1.0);
    const Vector3d force = bodies.force_on(1);
    CHECK(force.head<2>().norm() < 1e-9);
    if (step > 2) CHECK(force.z() > 0.0);
  }
  if (formulation.empty()) CHECK(bodies.force_on(1).z() == Approx(1000.0 * 0.25 * 0.05));
}

TEST_CASE("what a penalty presses past the edge of a face keeps its force", "[contact][contact_force]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {0, 0, 1}, .share_nodes = false});
  ContactBodies bodies(b, general_contact(stiff + node_face));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -0.01});
  bodies.step(1.0);
  bodies.set_velocity(1, {1e-3, 0, 0});
  for (int step = 0; step < 5; ++step) {
    CHECK(bodies.force_on(1).z() == Approx(10.0).epsilon(0.01));
    bodies.step(1.0);
  }
}

TEST_CASE("a bounce off a penalty spring is that of the spring", "[contact][contact_force]") {
  // Verification case U2 in small: a cube of mass 1 on a plate, held together by nothing but contact.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  b.add_hexes({.id = 2, .origin = {1.2, 0.9, 1.0}, .share_nodes = false});
  ContactBodies bodies(b, general_contact(stiff));
  bodies.ask();
  const double dt = 1e-4;
  double speed = -1.0, deepest = 0.0, largest = 0.0, contact_time = 0.0;
  for (int step = 0; step < 1200; ++step) {
    bodies.set_velocity(1, {0, 0, speed});
    bodies.step(dt);
    const double force = bodies.force_on(1).z();
    speed += dt * force;
    largest = std::max(largest, force);
    deepest = std::max(deepest, 1.0 - bodies.x.rightCols(8).row(2).minCoeff());
    contact_time += force > 0.0 ? dt : 0.0;
  }
  const double frequency = std::sqrt(1000.0);
  CHECK(speed == Approx(1.0).epsilon(1e-3));
  CHECK(deepest == Approx(1.0 / frequency).epsilon(1e-3));
  CHECK(largest == Approx(frequency).epsilon(1e-3));
  CHECK(contact_time == Approx(EIGEN_PI / frequency).epsilon(1e-2));
  const PairHistory& history = bodies.contact.histories()[{0}];
  CHECK(history.contact_time == Approx(contact_time));
  CHECK(history.peak_force == Approx(largest));
  CHECK(history.impulse.z() == Approx(2.0).epsilon(1e-3));
  CHECK(history.work == Approx(0.0).margin(1e-9));
}

TEST_CASE("a hit of few steps keeps no energy, wherever its first and last one fall",
          "[contact][contact_force]") {
  const std::string formulation = GENERATE(std::string(), node_face);
  const double dt = 0.01;  // a hit lasts ten steps
  for (int i = 0; i < 8; ++i) {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
    b.add_hexes({.id = 2, .origin = {1.2, 0.9, 1.0 + 0.125 * i * dt}, .share_nodes = false});
    ContactBodies bodies(b, general_contact(stiff + formulation));
    bodies.ask();
    double speed = -1.0;
    for (int step = 0; step < 16; ++step) {
      bodies.set_velocity(1, {0, 0, speed});
      bodies.step(dt);
      speed += dt * bodies.force_on(1).z();
    }
    CHECK(speed > 0.999);
    CHECK(speed < 1.005);  // the next hit takes back what the last step of this one gives too much
  }
}

}  // namespace contact_force_test
