// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/contact_output.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/watched_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A plate of 3 x 3 unit cells, a cube on its middle and one far away that takes no part.
MeshBuilder cube_on_plate() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  b.add_hexes({.id = 2, .origin = {1, 1, 1}, .share_nodes = false});
  b.add_node_set(1, "feet", std::vector<std::uint32_t>{32, 33, 34, 35});
  return b.add_hexes({.id = 3, .origin = {20, 0, 0}});
}

std::string rough(const std::string& more = "") {
  return general_contact("penalty stiffness = 1000\n" + more +
                             "friction model = rough\nend\nbegin constant friction model rough\n"
                             "friction coefficient = 0.5\n",
                         "contact surface low contains block_1\ncontact surface high contains block_2\n");
}

/// The lower nodes of the cube as a surface of nodes.
std::string by_node_set() {
  return general_contact(
      "penalty stiffness = 1000\nfriction model = rough\nend\n"
      "begin constant friction model rough\nfriction coefficient = 0.5\n",
      "contact surface low contains block_1\ncontact node set high contains nodelist_1\n");
}

/// The cube on the plate.
struct Watched : WatchedContact {
  explicit Watched(const std::string& lines) : WatchedContact(cube_on_plate(), lines) {}
};

}  // namespace

TEST_CASE("contact variables are there before the first step", "[contact][contact_output]") {
  Watched bodies(rough());
  bodies.ask();
  bodies.take(0);
  const Eigen::Matrix3Xd status = bodies.nodal("contact_status");
  CHECK(status.row(0).leftCols(40).isConstant(0.5));
  CHECK(status.row(0).rightCols(8).isZero());
  for (const OutputVariable& variable : bodies.variables) {
    if (variable.location == FieldLocation::node) CHECK(bodies.nodal(variable.name).allFinite());
  }
  CHECK(bodies.global("contact_force_low").norm() == 0.0);
  CHECK(bodies.global("contact_centre_low_high").norm() == 0.0);
}

TEST_CASE("nodes and totals of a cube pressed on a plate have the values of the pressure",
          "[contact][contact_output]") {
  Watched bodies(rough());
  bodies.shift(1, {0, 0, -0.01});
  bodies.ask();
  bodies.take(0);
  CHECK((bodies.global("contact_force_high") - Vector3d(0, 0, 10)).norm() < 1e-10);
  CHECK((bodies.global("contact_force_low") + Vector3d(0, 0, 10)).norm() < 1e-10);
  CHECK((bodies.global("contact_force_low_high") + Vector3d(0, 0, 10)).norm() < 1e-10);
  CHECK((bodies.global("contact_moment_high") - Vector3d(15, -15, 0)).norm() < 1e-9);
  CHECK((bodies.global("contact_moment_low") + bodies.global("contact_moment_high")).norm() < 1e-9);
  CHECK((bodies.global("contact_centre_high").head<2>() - Eigen::Vector2d(1.5, 1.5)).norm() < 1e-12);
  CHECK((bodies.global("contact_line_point_high") - bodies.global("contact_centre_high")).norm() < 1e-9);
  CHECK((bodies.global("contact_normal_line_point_high") - bodies.global("contact_centre_high")).norm() <
        1e-9);
  CHECK(bodies.global("contact_friction_line_point_high").norm() == 0.0);
  CHECK(bodies.nodal("contact_slip_status").maxCoeff() == 1.0);
  CHECK(bodies.global("contact_area_high").x() == Approx(1.0));
  CHECK(bodies.nodal("contact_normal_force_magnitude").row(0).sum() == Approx(20.0));
  CHECK(bodies.nodal("contact_area").row(0).sum() == Approx(2.0));
  const Eigen::Matrix3Xd status = bodies.nodal("contact_status"),
                         traction = bodies.nodal("contact_normal_traction_magnitude"),
                         gap = bodies.nodal("contact_normal_gap"),
                         direction = bodies.nodal("contact_normal_direction"),
                         pair = bodies.nodal("contact_interaction");
  int n_touching = 0;
  for (Eigen::Index i = 32; i < 40; ++i) {
    const bool is_low = bodies.x(2, i) < 1.5;
    n_touching += is_low ? 1 : 0;
    CHECK(status(0, i) == (is_low ? 1.0 : 0.5));
    CHECK(traction(0, i) == Approx(is_low ? 10.0 : 0.0));
    // Nothing is near the top: the margin of the search, by a quarter of three faces.
    CHECK(gap(0, i) == Approx(is_low ? -0.01 : 0.15 * std::sqrt(0.75)));
    CHECK(pair(0, i) == (is_low ? 1.0 : 0.0));
    CHECK((direction.col(i) - Vector3d(0, 0, is_low ? 1 : 0)).norm() < 1e-12);
  }
  CHECK(n_touching == 4);
}

TEST_CASE("nodes that do not touch have their gap up to the tracking distance, else that distance",
          "[contact][contact_output]") {
  const std::string formulation =
      GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const double height = GENERATE(0.09, 0.11);
  Watched bodies(rough("tracking distance = 0.1\n" + formulation)), without(rough(formulation));
  for (Watched* each : {&bodies, &without}) {
    each->shift(1, {0, 0, height});
    each->ask();
    each->take(0);
  }
  CHECK(bodies.forces == without.forces);
  const Eigen::Matrix3Xd gap = bodies.nodal("contact_normal_gap");
  for (Eigen::Index i = 32; i < 40; ++i) {
    const bool is_low = bodies.x(2, i) < 1.5;
    CHECK(gap(0, i) == Approx(is_low && height < 0.1 ? height : 0.1).epsilon(1e-12));
  }
}

TEST_CASE("totals of nodes on faces are the sums of the forces on the bodies", "[contact][contact_output]") {
  Watched bodies(rough("constraint formulation = node_face\n"));
  bodies.shift(1, {0.1, 0.2, -0.01});
  bodies.ask();
  bodies.take(0);
  CHECK(bodies.force_on(1).z() > 1.0);
  CHECK((bodies.global("contact_force_high") - bodies.force_on(1)).norm() < 1e-12);
  CHECK((bodies.global("contact_force_low") - bodies.force_on(0)).norm() < 1e-12);
  CHECK((bodies.global("contact_moment_low") + bodies.global("contact_moment_high")).norm() < 1e-9);
  CHECK((bodies.global("contact_moment_low") + bodies.global("contact_moment_high") - bodies.net_moment())
            .norm() < 1e-9);
  const Eigen::Matrix3Xd normal = bodies.nodal("contact_normal_force_magnitude");
  for (Eigen::Index i = 0; i < bodies.x.cols(); ++i)
    CHECK(normal(0, i) == Approx(bodies.forces.col(i).norm()).margin(1e-12));
}

TEST_CASE("slips, friction energy and rates of a cube that slides add up to what the run lost",
          "[contact][contact_output]") {
  Watched bodies(rough());
  bodies.shift(1, {0, 0, -0.01});
  bodies.ask();
  bodies.set_velocity(1, {0.01, 0, 0});
  double lost = 0.0;
  for (int step = 1; step <= 10; ++step) {
    lost += bodies.step(1.0).friction_work;
    bodies.take(step);
    const Vector3d force = bodies.global("contact_force_high");
    CHECK((force - bodies.force_on(1)).norm() < 1e-10);
    CHECK((force + bodies.global("contact_force_low")).norm() < 1e-10);
  }
  CHECK((bodies.global("contact_normal_force_high") - Vector3d(0, 0, 10)).norm() < 1e-3);
  CHECK((bodies.global("contact_friction_force_high") - Vector3d(-5, 0, 0)).norm() < 1e-3);
  CHECK((bodies.global("contact_friction_force_low") - Vector3d(5, 0, 0)).norm() < 1e-3);
  CHECK((bodies.global("contact_normal_moment_high") + bodies.global("contact_friction_moment_high") -
         bodies.global("contact_moment_high"))
            .norm() < 1e-12);
  CHECK(bodies.global("friction_energy_low_high").x() == Approx(lost));
  CHECK(bodies.global("friction_energy_low").x() == Approx(lost));
  CHECK(bodies.nodal("contact_slip_status").maxCoeff() == 2.0);
  // It slips from 0.005 on, where the spring of 1000 holds 5.
  CHECK(lost == Approx(5.0 * (0.1 - 0.005)).epsilon(1e-3));  // slivers on new partners wait for a step
  CHECK(bodies.nodal("contact_frictional_energy").row(0).sum() == Approx(lost));
  const Eigen::Matrix3Xd slip = bodies.nodal("contact_accumulated_slip_vector"),
                         length = bodies.nodal("contact_accumulated_slip"),
                         rate = bodies.nodal("contact_slip_rate"),
                         held = bodies.nodal("contact_tangential_gap");
  for (Eigen::Index i = 32; i < 40; ++i) {
    if (bodies.x(2, i) > 1.5) continue;
    CHECK((slip.col(i) - Vector3d(0.095, 0, 0)).norm() < 1e-12);
    CHECK(length(0, i) == Approx(0.095));
    CHECK(rate(0, i) == Approx(0.01));
    CHECK(held(0, i) == Approx(0.005));
  }
  CHECK(bodies.nodal("contact_tangential_force_magnitude").rightCols(16).row(0).sum() == Approx(5.0));
  // Lifted off: forces are gone, what has been stays.
  bodies.set_velocity(1, {0, 0, 0.02});
  bodies.step(1.0);
  bodies.take(11);
  CHECK(bodies.global("contact_force_high").norm() == 0.0);
  CHECK(bodies.nodal("contact_status").maxCoeff() == 0.5);
  CHECK(bodies.nodal("contact_slip_rate").norm() == 0.0);
  CHECK(bodies.nodal("contact_frictional_energy").row(0).sum() == Approx(lost));
}

TEST_CASE("the slip of a node turns with its surface", "[contact][contact_output]") {
  const std::string lines = GENERATE(rough(), rough("constraint formulation = node_face\n"), by_node_set());
  Watched bodies(lines);
  bodies.shift(1, {0, 0, -0.01});
  bodies.ask();
  bodies.set_velocity(1, {0.001, 0, 0});
  double moved = 0.0;
  for (int step = 1; step <= 15; ++step) {
    bodies.step(1.0);
    moved += 0.001;
  }
  bodies.take(15);
  const auto foot = [&](Eigen::Index i) { return i >= 32 && i < 40 && bodies.x(2, i) < 1.5; };
  const Eigen::Matrix3Xd before = bodies.nodal("contact_accumulated_slip_vector");
  // The spring of 1000 under a pressure of 10 holds 0.005 of it; each node of a set has its own area.
  double slipped = 0.0;
  for (Eigen::Index i = 32; i < 40; ++i) {
    if (foot(i)) slipped = before(0, i);
  }
  CHECK(slipped > 0.5 * moved);
  if (lines == rough()) CHECK(slipped == Approx(0.01));
  // Everything turns by 90 degrees about z in nine steps.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::acos(0.0) / 9.0, Vector3d::UnitZ()).toRotationMatrix();
  for (int step = 16; step <= 24; ++step) {
    const Eigen::Matrix3Xd after = turn * bodies.x;
    bodies.v = after - bodies.x;
    bodies.step(1.0);
    bodies.take(step);
  }
  const Eigen::Matrix3Xd slip = bodies.nodal("contact_accumulated_slip_vector"),
                         length = bodies.nodal("contact_accumulated_slip");
  for (Eigen::Index i = 32; i < 40; ++i) {
    if (!foot(i)) continue;
    CHECK((slip.col(i) - Vector3d(0, slipped, 0)).norm() < 1e-3 * slipped);
    CHECK(length(0, i) == Approx(slipped).epsilon(1e-3));
  }
}

TEST_CASE("the slip rate is reported along friction and across it", "[contact][contact_output]") {
  Watched bodies(rough());
  bodies.shift(1, {0, 0, -0.01});
  bodies.ask();
  bodies.set_velocity(1, {0.01, 0, 0});
  for (int step = 1; step <= 3; ++step) bodies.step(1.0);
  bodies.take(3);
  const Eigen::Matrix3Xd vector = bodies.nodal("contact_slip_rate_vector"),
                         parts = bodies.nodal("contact_slip_rate_components"),
                         friction = bodies.nodal("contact_tangential_force"),
                         normal = bodies.nodal("contact_normal_force");
  for (Eigen::Index i = 32; i < 40; ++i) {
    const bool is_low = bodies.x(2, i) < 1.5;
    CHECK((vector.col(i) - Vector3d(is_low ? 0.01 : 0.0, 0, 0)).norm() < 1e-12);
    // Friction acts against the slip.
    CHECK((parts.col(i) - Vector3d(is_low ? -0.01 : 0.0, 0, 0)).norm() < 1e-12);
    CHECK((friction.col(i) - Vector3d(is_low ? -1.25 : 0.0, 0, 0)).norm() < 1e-3);
    CHECK((normal.col(i) - Vector3d(0, 0, is_low ? 2.5 : 0.0)).norm() < 1e-3);
  }
}
