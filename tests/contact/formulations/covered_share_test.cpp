// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/covered_share.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A unit cube on a plate of 3 x 3 cells.
MeshBuilder cube_on_plate(double x, double y) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  return b.add_hexes({.id = 2, .origin = {x, y, 1.0}, .share_nodes = false});
}

}  // namespace

TEST_CASE("what of a node's area lies before the other surface", "[contact][node_face]") {
  ContactParts parts(cube_on_plate(1.0, 1.0), general_contact(""));
  parts.move();
  const ContactMesh& contact_mesh = parts.contact_mesh;
  const ContactKinematics& kinematics = parts.kinematics;
  const auto face_that_looks = [&](SurfaceIndex surface, double z) {
    for (const FaceIndex face : indices(contact_mesh.faces)) {
      const Eigen::Vector3d area = kinematics.area(contact_mesh.faces[face]);
      if (contact_mesh.faces[face].surface == surface && area.normalized().z() * z > 0.9) return face;
    }
    FAIL("no such face");
    return FaceIndex{};
  };
  const FaceIndex under_cube = face_that_looks(SurfaceIndex{1}, -1.0);
  const FaceIndex on_plate = face_that_looks(SurfaceIndex{0}, 1.0);
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    const Eigen::Vector3d x = kinematics.x(node.node);
    if (node.surface == SurfaceIndex{1}) {
      if (x.z() == 1.0) CHECK(covered_share(kinematics, node, on_plate) == 1.0);
    } else if (x.z() == 1.0 && x.x() > 0.5 && x.x() < 2.5 && x.y() > 0.5 && x.y() < 2.5) {
      CHECK(covered_share(kinematics, node, under_cube) == Approx(0.25));  // one of four faces
    }
  }
}
