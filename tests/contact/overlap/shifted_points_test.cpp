// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/shifted_points.hpp"

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// The contact node above or below a node of a lofted plate.
ContactNodeIndex loft_point(const test::OverlappingBodies& bodies, std::uint32_t mesh_node, double up) {
  const ContactMesh& contact_mesh = bodies.parts.contact_mesh;
  for (const ContactNodeIndex i : contact_mesh.nodes()) {
    const double offset = bodies.points.at(i).z() - bodies.mesh.coordinates()(2, mesh_node);
    if (contact_mesh.mesh_nodes[i].value == mesh_node && offset * up > 0.0) return i;
  }
  return {};
}

}  // namespace

TEST_CASE("shifted nodes are where they have gone, and a side by the shares of its nodes",
          "[contact][overlap]") {
  test::OverlappingBodies bodies(test::OverlappingBodies::cubes(0.1));
  ShiftedPoints& points = bodies.points;
  CHECK(points.at({8}) == Vector3d(0.25, 0.25, 0.9));
  points.shift(ContactNodeIndex{8}, {0, 0, 0.5});
  points.shift(NodeIndex{8}, {1, 0, 0});
  CHECK(points.at({8}).isApprox(Vector3d(1.25, 0.25, 1.4)));
  CHECK(points.coordinates().col(8).isApprox(Vector3d(1.25, 0.25, 1.4)));
  const ContactPointSide side{{8, 9, 11, 10}, {0.5, 0.25, 0.25, 0.0}};
  CHECK(points.way_of(side).isApprox(Vector3d(0.5, 0, 0.25)));
  CHECK(points.renewed().x({8}).isApprox(Vector3d(0.25, 0.25, 0.9)));
  points.renew();
  CHECK(points.way_of(side).isZero(0.0));
  CHECK(points.renewed().x({8}).isApprox(Vector3d(1.25, 0.25, 1.4)));
  for (const ContactFace& face : bodies.parts.contact_mesh.faces) {
    const FaceCorners x = points.corners(face);
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(x.col(static_cast<Eigen::Index>(k)) == points.at(face.corners[k]));
  }
  CHECK(points.take().col(8).isApprox(Vector3d(1.25, 0.25, 1.4)));
}

TEST_CASE("points of lofts go with their node, and turn to the normal once renewed", "[contact][overlap]") {
  test::MeshBuilder b;
  test::add_plate(b, {.id = 1, .u = {1, 0, 0}, .v = {0, 1, 0}}, 0.2);
  test::OverlappingBodies bodies(b);
  ShiftedPoints& points = bodies.points;
  const ContactNodeIndex above = loft_point(bodies, 1, 1.0), below = loft_point(bodies, 1, -1.0);
  CHECK(points.at(above).isApprox(Vector3d(1, 0, 0.1)));
  CHECK(points.at(below).isApprox(Vector3d(1, 0, -0.1)));
  points.shift(above, {0, 0, 1});
  CHECK(points.at(above).isApprox(Vector3d(1, 0, 1.1)));
  CHECK(points.at(below).isApprox(Vector3d(1, 0, 0.9)));  // both hang on one node
  points.shift(NodeIndex{3}, {0, 0, 1});                  // the plate rises by 45 degrees
  points.renew();
  const double half = 0.1 / std::sqrt(2.0);
  CHECK(points.at(above).isApprox(Vector3d(1 - half, 0, 1 + half)));
  CHECK(points.at(below).isApprox(Vector3d(1 + half, 0, 1 - half)));
}
