// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/surface_turns.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cells, a shell beside them and a node of a set.
MeshBuilder bodies() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  add_plate(b, {.id = 2, .cells = {2, 2}, .origin = {5, 0, 0}, .u = {2, 0, 0.5}, .v = {0, 2, 0}}, 0.2);
  b.add_hexes({.id = 3, .origin = {9, 0, 0}, .share_nodes = false});
  b.add_node_set(1, "lone", [](const Eigen::Vector3d& x) { return x.x() > 8.5; });
  return b;
}

const std::string two_surfaces =
    "contact node set lone contains nodelist_1\ncontact surface s contains block_1 block_2\n"
    "begin interaction defaults\ngeneral contact = on\nend\n";

struct Turned : ContactParts {
  Turned() : ContactParts(bodies(), two_surfaces), turns(kinematics_of_mesh(contact_mesh, mesh)) {}
  SurfaceTurns turns;
};

}  // namespace

TEST_CASE("surfaces of a body that turns as a whole turn with it, at every node",
          "[contact][surface_turns]") {
  Turned parts;
  const double angle = GENERATE(0.0, 0.3, 1.5707963267948966, 3.0);
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 2) / 3.0).toRotationMatrix();
  parts.x = rotation * parts.x;
  parts.x.colwise() += Eigen::Vector3d(3, 4, 5);
  parts.move();
  std::size_t n_without = 0;
  for (const ContactNodeIndex i : parts.contact_mesh.nodes()) {
    if (!parts.contact_mesh.is_mesh_point(i)) continue;
    const Eigen::Matrix3d turn = parts.turns.turn(parts.kinematics, i);
    if (!parts.turns.has_faces(i)) {
      ++n_without;
      CHECK(turn == Eigen::Matrix3d::Identity());
    } else {
      CHECK((turn - rotation).norm() < 1e-12);
    }
  }
  CHECK(n_without == 8);
}

TEST_CASE("a surface that grows turns nowhere, one that is sheared by about half",
          "[contact][surface_turns]") {
  Turned parts;
  const double shear = 1e-4;
  const bool is_sheared = GENERATE(false, true);
  Eigen::Matrix3d gradient = 1.3 * Eigen::Matrix3d::Identity();
  if (is_sheared) gradient(0, 1) = shear;
  const ContactNodeIndex node = parts.contact_mesh.find_node({6});
  parts.x = gradient * parts.x;
  parts.move();
  const Eigen::Matrix3d turn = parts.turns.turn(parts.kinematics, node);
  CHECK((turn.transpose() * turn - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  if (is_sheared) {
    CHECK((turn(0, 1) > 0.0 && turn(0, 1) < shear));
  } else {
    CHECK((turn - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  }
  CHECK(SurfaceTurns().turn(parts.kinematics, node) == Eigen::Matrix3d::Identity());
}
