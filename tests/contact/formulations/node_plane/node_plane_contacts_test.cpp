// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_plane/node_plane_contacts.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string ground = "begin analytic object ground\nnormal direction = 0 0 2\nend\n";

std::string deck_with(const std::string& lines) {
  return ground +
         "begin contact definition\ncontact surface low contains bottom\n"
         "contact surface floor contains ground\nbegin interaction defaults\ngeneral contact = on\n"
         "penalty stiffness = 1000\n" +
         lines + "end\nend\n";
}

/// A block of 2 x 2 x 1 unit cells whose bottom is a contact surface; the floor is at z = 0.
struct BlockOnFloor : ContactBodies {
  explicit BlockOnFloor(const std::string& lines = "")
      : ContactBodies(make(), parse_region(deck_with(lines))) {}
  static MeshBuilder make() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
    b.add_side_set(1, "bottom", [](const CandidateSide& c) { return c.centroid.z() == 0.0; });
    return b;
  }
};

}  // namespace

TEST_CASE("a plane pushes every node that is behind it by its share of the area",
          "[contact][plane_contacts]") {
  BlockOnFloor bodies;
  bodies.shift(0, {0.3, 0.2, -0.01});
  bodies.ask();
  CHECK(bodies.force_on(0).z() == Approx(1000.0 * 4.0 * 0.01));
  CHECK(bodies.force_on(0).head<2>().norm() == 0.0);
  for (Eigen::Index i = 0; i < bodies.x.cols(); ++i) {
    const bool is_low = i < 9;
    const double share = i == 4 ? 1.0 : i % 2 == 0 ? 0.25 : 0.5;
    CHECK(bodies.forces(2, i) == Approx(is_low ? 10.0 * share : 0.0));
  }
  bodies.shift(0, {0, 0, 0.01 + 1e-9});
  bodies.ask();
  CHECK(bodies.forces.norm() == 0.0);
}

TEST_CASE("whatever is behind a plane comes out, however deep, and far from its origin",
          "[contact][plane_contacts]") {
  BlockOnFloor bodies;
  bodies.shift(0, {1e4, -1e4, -5.0});
  bodies.ask();
  CHECK(bodies.force_on(0).z() == Approx(1000.0 * 4.0 * 5.0));
}

TEST_CASE("a plane limits the step of what comes near it, before it touches", "[contact][plane_contacts]") {
  BlockOnFloor bodies;
  bodies.shift(0, {0, 0, 1.0});
  CHECK(std::isinf(bodies.ask().stable_step));
  bodies.set_velocity(0, {0, 0, -0.4});
  CHECK(bodies.step(1.0).stable_step < 0.2);  // 0.6 to go in steps of 0.4
  CHECK(bodies.forces.norm() == 0.0);
}

TEST_CASE("friction on a plane sticks, then slides at its limit", "[contact][plane_contacts]") {
  BlockOnFloor bodies(
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.5\n");
  bodies.shift(0, {0, 0, -0.01});
  bodies.ask();
  bodies.set_velocity(0, {0.003, 0.004, 0});
  for (int step = 1; step <= 3; ++step) {
    const ForceReport report = bodies.step(0.5);
    // The limit of 0.5 * 40 is reached after a slip of 0.005.
    const double slip = std::min(0.005, 0.0025 * step);
    CHECK((bodies.force_on(0).head<2>() + 4000.0 * slip * Eigen::Vector2d(0.6, 0.8)).norm() < 1e-9);
    CHECK(report.friction_work == Approx(step < 3 ? 0.0 : 20.0 * 0.0025).margin(1e-12));
  }
  // Lifted off and set down again it holds nothing.
  bodies.set_velocity(0, {0, 0, 0.02});
  bodies.step(1.0);
  bodies.set_velocity(0, {0, 0, -0.02});
  bodies.step(1.0);
  bodies.set_velocity(0, {0, 0, 0});
  bodies.step(1.0);
  CHECK(bodies.force_on(0).head<2>().norm() < 1e-12);
  CHECK(bodies.force_on(0).z() == Approx(40.0));
}

TEST_CASE("looking at a step on a plane changes nothing", "[contact][plane_contacts]") {
  const std::string lines =
      "contact damping fraction = 0.2\nfriction model = rough\nend\n"
      "begin constant friction model rough\nfriction coefficient = 0.5\n";
  BlockOnFloor quiet(lines), watched(lines);
  for (int step = 0; step < 10; ++step) {
    for (BlockOnFloor* bodies : {&quiet, &watched}) {
      bodies->set_velocity(0, {0.002, 0.001 * step, step % 2 == 0 ? -0.004 : 0.003});
      bodies->step(1.0);
    }
    CHECK(quiet.forces == watched.forces);
    CHECK(quiet.forces.norm() > 0.0);
    CHECK(watched.contact.points().size() == 9);
  }
}
