// SPDX-License-Identifier: BSD-3-Clause
// Contact of lofted shells as a run has it: what touches, and what the nodes get of it.
#include <algorithm>
#include <array>
#include <numbers>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::string formulation(const std::string& name) { return "constraint formulation = " + name + "\n"; }

std::string self_contact(const std::string& more) { return general_contact("self contact = on\n" + more); }

const std::string rough =
    "skin all blocks = on\nbegin constant friction model rough\n"
    " friction coefficient = 0.5\nend\n";

/// Two plates of thickness 2 whose middles are 5 apart, as OptiStruct's guide has them.
MeshBuilder two_plates() {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {2, 2}, .u = {8, 0, 0}, .v = {0, 8, 0}}, 2.0);
  add_plate(b, {.id = 2, .cells = {3, 3}, .origin = {1, 1, 5}, .u = {5, 0, 0}, .v = {0, 5, 0}}, 2.0);
  return b;
}

/// A cube over the ridge of a roof, to one side.
MeshBuilder cube_on_roof() {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}, .origin = {-3, 0, -0.6}, .u = {3, 0, 0.6}, .v = {0, 3, 0}}, 0.4);
  add_plate(b, {.id = 2, .cells = {3, 3}, .u = {3, 0, -0.6}, .v = {0, 3, 0}}, 0.4);
  b.add_hexes({.id = 3, .cells = {2, 2, 1}, .origin = {-0.5, 0.3, 0.25}, .size = {1.2, 0.9, 0.6}});
  return b;
}

}  // namespace

TEST_CASE("plates 5 apart and 2 thick touch after 3 of travel", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  ContactBodies bodies(two_plates(), general_contact(formulation(name)));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(1.5);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(1.5 - 1e-6);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(2e-6);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  CHECK(bodies.moments.colwise().norm().maxCoeff() < 1e-12);  // the force goes through the middle
}

TEST_CASE("a push on a roof is in balance with what its nodes get", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  ContactBodies bodies(cube_on_roof(), general_contact(formulation(name)));
  bodies.ask();
  bodies.set_velocity(2, {0, 0, -1});
  for (int i = 0; i < 10; ++i) bodies.step(0.01);
  REQUIRE(bodies.force_on(2).z() > 1e-4);
  // At the ridge skins stand off along the mean of the two normals, and forces along the normal of one: their
  // moments go to the nodes around as forces.
  CHECK(bodies.moments.isZero(0.0));
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("a plate pinched between two blocks is in balance", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {4, 4}, .u = {4, 0, 0}, .v = {0, 4, 0}}, 0.5);
  b.add_hexes({.id = 2, .cells = {3, 3, 1}, .origin = {0.5, 0.5, 0.24}, .size = {3, 3, 1}});
  b.add_hexes({.id = 3, .cells = {3, 3, 1}, .origin = {0.5, 0.5, -1.24}, .size = {3, 3, 1}});
  ContactBodies bodies(b, general_contact(formulation(name)));
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 1e-3);
  CHECK(bodies.force_on(2).z() == Approx(-bodies.force_on(1).z()));
  CHECK(bodies.force_on(0).norm() < 1e-12);
}

TEST_CASE("shells that the mesh joins do not touch at rest, however thick and fine", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  const double thickness = GENERATE(0.02, 0.1, 0.35);  // elements are 0.1 long
  MeshBuilder b;
  const std::array<int, 2> cells{10, 10};
  SECTION("flat") { add_plate(b, {.id = 1, .cells = cells}, thickness); }
  SECTION("folded at a right angle") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {1, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}}, thickness);
  }
  SECTION("folded sharply") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {1, 0, 0}, .u = {0, 1, 0}, .v = {-0.6, 0, 0.8}},
              thickness);
  }
  SECTION("as a T") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {0.5, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}}, thickness);
  }
  SECTION("standing on a solid") {
    b.add_hexes({.id = 1, .cells = {10, 10, 2}, .size = {1, 1, 0.2}});
    add_plate(b, {.id = 2, .cells = cells, .origin = {0.5, 0, 0.2}, .u = {0, 1, 0}, .v = {0, 0, 1}},
              thickness);
  }
  SECTION("lying on a part of a solid") {
    b.add_hexes({.id = 1, .cells = {10, 10, 2}, .size = {1, 1, 0.2}});
    add_plate(b, {.id = 2, .cells = {5, 10}, .origin = {0, 0, 0.2}, .u = {0.5, 0, 0}, .v = {0, 1, 0}},
              thickness);
  }
  ContactBodies bodies(b, self_contact(formulation(name)));
  bodies.ask();
  CHECK(bodies.force_size() == 0.0);
  bodies.step(0.1);
  CHECK(bodies.force_size() == 0.0);
}

TEST_CASE("plates that turn carry their skins along", "[contact][lofted]") {
  ContactBodies bodies(two_plates(), general_contact());
  bodies.ask();
  bodies.turning.row(0).setConstant(0.25);
  ContactKinematics kinematics(bodies.contact.contact_mesh());
  kinematics.step(bodies.motion());
  const ContactNodeIndex first{static_cast<std::uint32_t>(bodies.contact.contact_mesh().n_mesh_points())};
  REQUIRE(kinematics.offsets().cols() == 2 * (9 + 16));
  CHECK(kinematics.offsets().colwise().norm().isApproxToConstant(1.0));
  // Turning about x, what stands up goes along -y.
  const double height = kinematics.offsets()(2, 0);
  CHECK((kinematics.v(first) - Eigen::Vector3d(0, -0.25 * height, 0)).norm() < 1e-12);
  bodies.dt = 2.0;
  kinematics.step(bodies.motion());
  const Eigen::Vector3d turned(0, -std::sin(0.5) * height, std::cos(0.5) * height);
  CHECK((kinematics.offsets().col(0) - turned).norm() < 1e-12);
  kinematics.move_nodes(bodies.motion());
  CHECK((kinematics.offsets().col(0) - turned).norm() < 1e-12);
}

TEST_CASE("crossed beams touch when their axes are as far apart as both radii", "[contact][lofted]") {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(b, {.id = 2, .cells = 3, .from = {0.1, -1, 1}, .to = {0.1, 1, 1}});
  ContactBodies bodies(b, general_contact("friction model = rough\n", rough));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(0.8 - 1e-9);
  CHECK(bodies.force_size() == 0.0);
  bodies.set_velocity(1, {0.3, 0.2, -1});
  for (int i = 0; i < 10; ++i) bodies.step(1e-3);
  bodies.set_velocity(1, {0.3, 0.2, 0});
  for (int i = 0; i < 20; ++i) bodies.step(1e-3);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.force_on(1).head<2>().norm() == Approx(0.5 * bodies.force_on(1).z()).epsilon(0.02));
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  // What is left is friction across the depth of the overlap.
  const double depth = 0.01;
  CHECK(bodies.net_moment().norm() < 1.01 * depth * bodies.force_on(1).head<2>().norm());
}

TEST_CASE("equal edges push alike, whichever comes first", "[contact][lofted]") {
  const auto forces = [](bool is_swapped) {
    MeshBuilder b;
    const Row low{.cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}};
    const Row high{.cells = 2, .from = {0.1, -1, 0.19}, .to = {0.1, 1, 0.19}};
    Row first = is_swapped ? high : low, second = is_swapped ? low : high;
    first.id = 1;
    second.id = 2;
    add_rod(b, first);
    add_rod(b, second);
    ContactBodies bodies(b, general_contact());
    bodies.ask();
    return is_swapped ? bodies.force_on(0) : bodies.force_on(1);
  };
  CHECK(forces(false).z() > 0.0);
  CHECK((forces(false) - forces(true)).norm() < 1e-12 * forces(false).norm());
}

TEST_CASE("beams that lie along each other touch along the part that they share", "[contact][lofted]") {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0, 0}, .to = {1, 0, 0}});
  add_rod(b, {.id = 2, .cells = 2, .from = {-0.5, 0, 0.19}, .to = {0.5, 0, 0.19}});
  ContactBodies bodies(b, general_contact());
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(std::abs(bodies.force_on(1).x()) < 1e-12 * bodies.force_size());
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("beams that the mesh joins do not touch at rest, however short their elements",
          "[contact][lofted]") {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 40, .from = {0, 0, 0}, .to = {1, 0, 0}});
  add_rod(b, {.id = 2, .cells = 40, .from = {1, 0, 0}, .to = {1, 1, 0}});
  SECTION("to each other") {}
  SECTION("to a solid") {
    b.add_hexes({.id = 3, .cells = {4, 4, 4}, .origin = {-0.4, -0.2, -0.2}, .size = {0.4, 0.4, 0.4}});
  }
  ContactBodies bodies(b, self_contact(""));
  bodies.ask();
  bodies.step(0.01);
  CHECK(bodies.force_size() == 0.0);
}

TEST_CASE("particles touch each other and faces at their radius", "[contact][lofted]") {
  const std::string name = GENERATE("node_face", "face_face");
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .origin = {-2, -2, -1}, .size = {4, 4, 1}});
  add_balls(b, 2, {{0.3, 0.2, 0.6}, {0.3, 0.2, 1.7}}, 0.5);
  ContactBodies bodies(b, self_contact(formulation(name)));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(0.1 - 1e-9);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(2e-9);
  CHECK(bodies.force_on(0).z() < 0.0);
  bodies.set_velocity(1, {0, 0, 0});
  bodies.v.col(bodies.v.cols() - 1) = Eigen::Vector3d(0, 0, -1);
  bodies.step(0.1 - 1e-9);
  const double on_low = bodies.forces.col(bodies.v.cols() - 2).z();
  CHECK(bodies.forces.col(bodies.v.cols() - 1).z() == 0.0);
  bodies.step(2e-9);
  CHECK(bodies.forces.col(bodies.v.cols() - 1).z() > 0.0);
  CHECK(bodies.forces.col(bodies.v.cols() - 2).z() < on_low);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("a particle beside a face touches its edge and its corner", "[contact][lofted]") {
  const Eigen::Vector3d from = GENERATE(Eigen::Vector3d(1.3, 0.2, 0.3), Eigen::Vector3d(1.25, 1.25, 0.25),
                                        Eigen::Vector3d(1.45, 0.3, -0.4));
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .origin = {-1, -1, -2}, .size = {2, 2, 2}});
  add_balls(b, 2, {from}, 0.5);
  ContactBodies bodies(b, general_contact());
  bodies.ask();
  const Eigen::Vector3d nearest = from.cwiseMin(Eigen::Vector3d(1, 1, 0));
  const Eigen::Vector3d force = bodies.force_on(1);
  REQUIRE(force.norm() > 0.0);
  CHECK((force.normalized() - (from - nearest).normalized()).norm() < 1e-9);
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("a particle touches faces where edges have no contact", "[contact][lofted]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .origin = {-1, -1, -2}, .size = {2, 2, 2}});
  add_balls(b, 2, {{0.3, 0.2, 0.4}}, 0.5);
  ContactBodies bodies(
      b, general_contact("constraint formulation = node_face\n",
                         "skin all blocks = on\nbegin surface options\nedge contact = off\nend\n"));
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("a ball in a fold, however narrow, touches both walls", "[contact][lofted]") {
  const double angle = GENERATE(10.0, 30.0, 60.0, 100.0) * std::numbers::pi / 360.0;  // from the middle
  constexpr double radius = 0.2, thickness = 0.02, depth = 1e-3;
  MeshBuilder b;
  const auto bottom = {b.add_node({0, -2, 0}).value, b.add_node({0, 2, 0}).value};
  std::vector<std::uint32_t> quads;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d up(4.0 * side * std::sin(angle), 0.0, 4.0 * std::cos(angle));
    const std::array<std::uint32_t, 4> corners{*bottom.begin(), *(bottom.begin() + 1),
                                               b.add_node(up + Eigen::Vector3d(0, 2, 0)).value,
                                               b.add_node(up - Eigen::Vector3d(0, 2, 0)).value};
    quads.insert(quads.end(), corners.begin(), corners.end());
  }
  b.add_block(1, "", Shape::shell4, quads);
  b.set_attributes(1, {"thickness"}, {thickness, thickness});
  const double height = (radius + 0.5 * thickness - depth) / std::sin(angle);
  add_balls(b, 2, {{0, 0, height}}, radius);
  ContactBodies bodies(b, general_contact(""));
  bodies.ask();
  const auto points = bodies.contact.points();
  const auto touches = [](const ContactPoint& point) { return point.touches(); };
  CHECK(std::ranges::count_if(points, touches) == 2);
  CHECK(std::abs(bodies.force_on(1).x()) < 1e-9 * bodies.force_size());
  CHECK(bodies.force_on(1).z() > 0.0);
}

TEST_CASE("sharp edges of solids meet unless the feature angle is larger or off", "[contact][lofted]") {
  const std::string options = GENERATE("", "begin surface options\nfeature angle = 100\nend\n",
                                       "begin surface options\nfeature angle = off\nend\n",
                                       "begin surface options\nfeature angle = 30\nend\n");
  const std::string surfaces = "skin all blocks = on\n" + options;
  ContactBodies bodies(crossed_bars(0.01), general_contact(formulation("node_face"), surfaces));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(0.0099);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(0.0002);
  const bool is_sharp = options.empty() || options.find("30") != std::string::npos;
  CHECK((bodies.force_on(1).z() > 0.0) == is_sharp);
  CHECK(bodies.net_moment().norm() <= 1e-12 * bodies.force_size());
  const Eigen::Vector3d force = bodies.force_on(1);
  CHECK(force.head<2>().norm() <= 1e-12 * force.norm());
  bodies.step(0.05);
  CHECK((bodies.force_on(1).z() > force.z()) == is_sharp);
}

TEST_CASE("without edge contact beams pass each other and meet faces all the same", "[contact][lofted]") {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(b, {.id = 2, .cells = 3, .from = {0.1, -1, 0.19}, .to = {0.1, 1, 0.19}});
  b.add_hexes({.id = 3, .origin = {-2, -2, -1.09}, .size = {4, 4, 1}});
  ContactBodies bodies(b, general_contact("",
                                          "skin all blocks = on\nbegin surface options\nsurface = block_2\n"
                                          "edge contact = off\nend\n"));
  bodies.ask();
  CHECK(bodies.force_on(1).norm() == 0.0);
  CHECK(bodies.force_on(0).z() > 0.0);
  CHECK(bodies.force_on(2).z() < 0.0);
}

TEST_CASE("rods and particles meet faces where no edge meets another", "[contact][lofted]") {
  MeshBuilder b;
  const bool is_rod = GENERATE(true, false);
  if (is_rod)
    add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  else
    add_balls(b, 1, {{-0.5, 0.05, 0}, {0.5, 0.05, 0}}, 0.1);
  b.add_hexes({.id = 3, .origin = {-2, -2, -1.09}, .size = {4, 4, 1}});
  ContactBodies bodies(b, general_contact("",
                                          "skin all blocks = on\nbegin surface options\n"
                                          "edge contact = off\nend\n"));
  bodies.ask();
  CHECK(bodies.force_on(0).z() > 0.0);
  CHECK(bodies.force_on(1).z() < 0.0);
}

TEST_CASE("a side set of a shell touches on its side only, and without thickness", "[contact][lofted]") {
  const int side = GENERATE(1, 2);
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {2, 2}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.5);
  const double z = side == 1 ? -0.001 : -0.599;
  b.add_hexes({.id = 2, .origin = {0.5, 0.6, z}, .size = {0.6, 0.6, 0.6}});
  b.add_side_set(1, "top", [&](const CandidateSide& c) { return c.block_id == 1 && c.side.side() == 1; });
  const std::string name = GENERATE("node_face", "face_face");
  ContactBodies bodies(
      b, general_contact(formulation(name),
                         "contact surface a contains top\ncontact surface b contains block_2\n"));
  bodies.ask();
  CHECK((bodies.force_on(1).z() > 0.0) == (side == 1));
  CHECK(bodies.net_moment().norm() <= 1e-12 * bodies.force_size());
}

TEST_CASE("rods that cross at nodes push as hard as between them", "[contact][lofted]") {
  const auto force = [](double x, double y, bool is_parallel) {
    MeshBuilder b;
    add_rod(b, {.id = 1, .cells = 8, .from = {-4, 0, 0}, .to = {4, 0, 0}});
    const Eigen::Vector3d way = is_parallel ? Eigen::Vector3d(4, 0, 0) : Eigen::Vector3d(0, 4, 0);
    const Eigen::Vector3d middle(x, y, 0.19);
    add_rod(b, {.id = 2, .cells = 8, .from = middle - way, .to = middle + way});
    ContactBodies bodies(b, general_contact());
    bodies.ask();
    return bodies.force_on(1).z();
  };
  const double between = force(0.5, 0.5, false);
  REQUIRE(between > 0.0);
  CHECK(force(0, 0.5, false) == Approx(between));
  CHECK(force(0.5, 1, false) == Approx(between));
  CHECK(force(0, 0, false) == Approx(between));
  CHECK(force(0.001, 0.001, false) == Approx(between));
  CHECK(force(-0.001, 0.001, false) == Approx(between));
  // Widths are 0.2. The elements at the ends have softer penalties: their last nodes have half the mass.
  const double along = force(0, 0, true);
  CHECK(along == Approx(8.0 / 0.2 * between).epsilon(0.15));
  CHECK(force(1e-12, 0, true) == Approx(along));
  CHECK(force(0.5, 0, true) == Approx(7.5 / 8.0 * along).epsilon(0.02));
}

TEST_CASE("a beam rests on the rims of a plate that is narrower than its elements", "[contact][lofted]") {
  MeshBuilder b;
  SECTION("of shells") {
    add_plate(b, {.id = 1, .cells = {2, 2}, .origin = {-0.5, -1, -0.1}, .v = {0, 2, 0}}, 0.2);
  }
  SECTION("of a solid") {
    b.add_hexes({.id = 1, .cells = {2, 2, 1}, .origin = {-0.5, -1, -1}, .size = {1, 2, 1}});
  }
  const double y = GENERATE(0.1, 0.0);  // 0: where the rim has a node
  add_rod(b, {.id = 2, .cells = 1, .from = {-2, y, 0.09}, .to = {2, y, 0.09}});
  ContactBodies bodies(b, general_contact());
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.force_on(1).head<2>().norm() < 1e-9 * bodies.force_on(1).z());
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}
