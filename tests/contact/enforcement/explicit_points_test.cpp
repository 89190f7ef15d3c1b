// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/explicit_points.hpp"

#include "support/catch.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The faces of two cubes on top of each other that touch.
struct TouchingFaces {
  FaceIndex top, bottom;
};

TouchingFaces find_touching(const ContactBodies& bodies) {
  TouchingFaces found{};
  const ContactKinematics& now = bodies.contact.kinematics();
  for (const FaceIndex i : indices(now.contact_mesh().faces)) {
    const ContactFace& face = now.contact_mesh().faces[i];
    const double up = now.area(face).z();
    if (face.surface == SurfaceIndex{0} && up > 0.5) found.top = i;
    if (face.surface == SurfaceIndex{1} && up < -0.5) found.bottom = i;
  }
  return found;
}

/// A point of load steps in the middle of both, that presses with 8 over an area of 1 and holds 2 along x.
ContactPoint middle_point(const ContactBodies& bodies, const TouchingFaces& faces) {
  const ContactMesh& contact_mesh = bodies.contact.contact_mesh();
  ContactPoint point;
  point.pair = {0};
  point.first_entity = faces.bottom.value;
  point.second_entity = faces.top.value;
  point.first.nodes = contact_mesh.faces[faces.bottom].corners;
  point.second.nodes = contact_mesh.faces[faces.top].corners;
  point.first.weights.setConstant(0.25);
  point.second.weights.setConstant(0.25);
  point.normal = Eigen::Vector3d::UnitZ();
  point.area = 1.0;
  point.force = 8.0;
  point.tangential = {2.0, 0.0, 0.0};
  return point;
}

}  // namespace

TEST_CASE("points of faces stay as they are where faces meet faces", "[contact][enforcement]") {
  ContactBodies bodies(stacked_cubes(0.0), general_contact());
  bodies.ask();
  const ContactPoint point = middle_point(bodies, find_touching(bodies));
  const auto points = explicit_points_of({&point, 1}, bodies.definition.pairs, bodies.contact.contact_mesh());
  REQUIRE(points.size() == 1);
  CHECK(points[0].force == 8.0);
  CHECK(points[0].first_entity == point.first_entity);
}

TEST_CASE("points of faces go to the nodes of both sides where nodes meet faces", "[contact][enforcement]") {
  ContactBodies bodies(stacked_cubes(0.0), general_contact(node_face));
  bodies.ask();
  const TouchingFaces faces = find_touching(bodies);
  const ContactPoint point = middle_point(bodies, faces);
  const auto points = explicit_points_of({&point, 1}, bodies.definition.pairs, bodies.contact.contact_mesh());
  REQUIRE(points.size() == 8);
  Eigen::Vector3d on_upper = Eigen::Vector3d::Zero();
  for (const ContactPoint& one : points) {
    const bool is_of_upper = one.second_face() == faces.top;
    CHECK((is_of_upper || one.second_face() == faces.bottom));
    CHECK(one.area == Approx(0.125));
    CHECK(one.force == Approx(1.0));
    CHECK(one.normal.z() == Approx(is_of_upper ? 1.0 : -1.0));
    on_upper += (is_of_upper ? 1.0 : -1.0) * one.force_on_first();
  }
  CHECK(on_upper.isApprox(Eigen::Vector3d(2.0, 0.0, 8.0)));
}
