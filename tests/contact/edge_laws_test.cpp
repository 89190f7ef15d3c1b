// SPDX-License-Identifier: BSD-3-Clause
// Friction models between edges: they push with friction, by the half of a HYBRID pair that they are of, and
// leave to ties what these hold.
#include <Eigen/Geometry>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string hybrid =
    "friction model = h\ncapture tolerance = 0.01\nend\n"
    "begin constant friction model rough\nfriction coefficient = 0.5\nend\n"
    "begin hybrid model h\ninitially close = rough\n";
const std::string glued = "friction model = sticky\nend\nbegin glued model sticky\n";

/// Two rods of radius 0.1 that cross, their surfaces so far apart.
MeshBuilder crossed_rods(double gap) {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(b, {.id = 2, .cells = 3, .from = {0.1, -1, 0.2 + gap}, .to = {0.1, 1, 0.2 + gap}});
  return b;
}

/// Two bars of square section whose upper and lower edges cross, so far apart.
MeshBuilder crossed_bars(double gap) {
  MeshBuilder b;
  const auto add_bar = [&](std::int64_t id, const Eigen::Vector3d& way, double up, double z) {
    const Eigen::Vector3d aside = Eigen::Vector3d::UnitZ().cross(way);
    std::vector<std::uint32_t> nodes;
    for (const double end : {-1.0, 1.0}) {
      for (const auto& [a, h] : {std::pair(0.0, -1.0), {0.5, -0.5}, {0.0, 0.0}, {-0.5, -0.5}})
        nodes.push_back(b.add_node(end * way + a * aside + Eigen::Vector3d(0, 0, z + up * h)).value);
    }
    if (up < 0.0) std::rotate(nodes.begin(), nodes.begin() + 4, nodes.end());
    b.add_block(id, "", Shape::hex8, nodes);
  };
  add_bar(1, Eigen::Vector3d::UnitX(), 1.0, 0.0);
  add_bar(2, Eigen::Vector3d(0.1, 1, 0).normalized(), -1.0, gap);
  return b;
}

/// A unit cube on another one, turned by 45 degrees about the vertical, so far apart: their rims cross.
MeshBuilder turned_cubes(double gap) {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  const Eigen::Vector3d middle(0.5, 0.5, 0.0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.25 * M_PI, Eigen::Vector3d::UnitZ()).matrix();
  std::vector<std::uint32_t> nodes;
  for (const double z : {1.0 + gap, 2.0 + gap}) {
    for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      nodes.push_back(
          b.add_node(middle + turn * Eigen::Vector3d(x, y, 0) + z * Eigen::Vector3d::UnitZ()).value);
  }
  return b.add_block(2, "", Shape::hex8, nodes);
}

std::size_t n_touching_edges(const ContactBodies& bodies) {
  return static_cast<std::size_t>(
      std::ranges::count_if(bodies.contact.points(),
                            [](const ContactRecord& point) { return point.is_of_edges && point.touches(); }));
}

}  // namespace

TEST_CASE("rods of a HYBRID pair have the friction of the half that they are of", "[contact][edges]") {
  const bool is_close = GENERATE(true, false);
  const double gap = is_close ? 0.005 : 0.05;
  ContactBodies bodies(crossed_rods(gap), general_contact(hybrid));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(gap + 0.005);
  bodies.set_velocity(1, {0.3, 0.2, 0});
  for (int i = 0; i < 20; ++i) bodies.step(1e-3);
  const Eigen::Vector3d force = bodies.force_on(1);
  REQUIRE(force.z() > 0.0);
  CHECK(force.head<2>().norm() == Approx(is_close ? 0.5 * force.z() : 0.0).epsilon(0.02).margin(1e-12));
}

TEST_CASE("sharp edges push under a GLUED model as long as nothing is glued", "[contact][edges]") {
  ContactBodies bodies(crossed_bars(0.01), general_contact(glued));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(0.0099);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(0.0002);
  CHECK(n_touching_edges(bodies) == 1);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("sharp edges of faces that ties hold do not push, the others do", "[contact][edges]") {
  // No node stands over a face of the other cube: nodes on faces glue nothing, and the rims hold the cubes
  // apart.
  const std::string formulation = GENERATE("face_face", "node_face");
  ContactBodies bodies(turned_cubes(0.001),
                       general_contact("constraint formulation = " + formulation + "\n" + glued));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -0.002});
  bodies.step(1.0);
  bodies.step(0.1);
  const bool is_glued = formulation == "face_face";
  CHECK(bodies.contact.ties().empty() != is_glued);
  CHECK(n_touching_edges(bodies) == (is_glued ? 0 : 8));
  CHECK(bodies.force_on(1).z() > 0.0);
}
