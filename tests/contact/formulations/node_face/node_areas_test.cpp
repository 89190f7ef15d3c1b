// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_areas.hpp"

#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Contact points of the nodes of two cubes that lie on each other, both ways, each with half of its area.
struct SharedFaces {
  ContactParts parts;
  std::vector<ContactPoint> points;

  explicit SharedFaces(double width = 1.0, double aside = 0.0, const std::string& more = "")
      : parts(cube_over_cube(0.0, width, aside),
              general_contact("constraint formulation = node_face\n" + more)) {}
  /// Adds the point of a node over a face of the other cube.
  ///   area  that the node stands for
  void add(std::uint32_t node, double area) {
    const bool is_upper = node >= 8;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const FaceIndex face = face_of(parts, is_upper ? 0 : 1, is_upper ? up : Eigen::Vector3d(-up));
    ContactPoint& point = points.emplace_back();
    point.first_entity = row_of_node(parts, node).value;
    point.second_entity = face.value;
    point.first.nodes.fill({node});
    point.first.weights = Eigen::Vector4d::UnitX();
    point.second.nodes = parts.contact_mesh.faces[face].corners;
    const FaceCorners x = parts.kinematics.face_corners(face);
    const auto at = project_onto_face(x, false, parts.kinematics.x({node}));
    point.second.weights = corner_weights(at->xi, at->eta, false);
    point.normal = is_upper ? up : Eigen::Vector3d(-up);
    point.gap = -0.01;
    point.area = 0.5 * area;
    point.force = 10.0 * point.area;
    point.stiffness = 100.0 * point.area;
    point.damped = point.dissipated = point.area;
  }
  void share_out() {
    NodeAreas areas;
    areas.share_out(parts.context(0.1), points);
  }
  /// What all points give a node of the mesh.
  double area_at(std::uint32_t node) const {
    double sum = 0.0;
    for (const ContactPoint& point : points) {
      for (const ContactPointSide* side : {&point.first, &point.second}) {
        for (std::size_t k = 0; k < 4; ++k) {
          if (side->nodes[k].value == node) sum += side->weights[static_cast<Eigen::Index>(k)] * point.area;
        }
      }
    }
    return sum;
  }
};

}  // namespace

TEST_CASE("nodes that match get their area from both ways together", "[contact][node_areas]") {
  SharedFaces faces;
  for (std::uint32_t node = 4; node < 12; ++node) faces.add(node, 0.25);
  faces.share_out();
  for (std::uint32_t node = 4; node < 12; ++node) CHECK(faces.area_at(node) == Approx(0.25));
  for (const ContactPoint& point : faces.points) CHECK(point.area == Approx(0.125));
}

TEST_CASE("nodes that nothing meets the other way have all of their area", "[contact][node_areas]") {
  SharedFaces faces(0.5, 0.25);
  for (std::uint32_t node = 8; node < 12; ++node) faces.add(node, 0.0625);
  faces.share_out();
  for (const ContactPoint& point : faces.points) {
    CHECK(point.area == Approx(0.0625).epsilon(0.01));  // as far as three corrections come
    // What goes with the area grows along with it.
    CHECK(point.force == Approx(10.0 * point.area));
    CHECK(point.stiffness == Approx(100.0 * point.area));
    CHECK(point.dissipated == Approx(point.area));
    CHECK(point.damped == Approx(point.area));
  }
}

TEST_CASE("points that go one way, or have a law across gaps, keep their area", "[contact][node_areas]") {
  SharedFaces faces(0.5, 0.25);
  for (std::uint32_t node = 8; node < 12; ++node) faces.add(node, 0.0625);
  faces.points[0].is_held_apart = true;
  faces.points[1].first.radius = 0.1;
  faces.points[2].area = 0.0;
  faces.points[3].is_balanced = true;
  faces.points[3].force = 0.0;
  faces.points[3].gap = 0.1;  // and does not meet in the coming step
  faces.share_out();
  CHECK(faces.points[0].area == 0.03125);
  CHECK(faces.points[1].area == 0.03125);
  CHECK(faces.points[2].area == 0.0);
  CHECK(faces.points[3].area == 0.03125);
}

TEST_CASE("a finer side stands for most of an interface, and the patch test holds", "[contact][node_areas]") {
  // The upper side's nodes stand for a quarter each of what the lower ones do: both are covered, so that
  // each gets what it stands for.
  SharedFaces faces;
  for (std::uint32_t node = 4; node < 8; ++node) faces.add(node, 0.25);
  for (std::uint32_t node = 8; node < 12; ++node) faces.add(node, 0.24);
  faces.share_out();
  for (std::uint32_t node = 4; node < 8; ++node) CHECK(faces.area_at(node) == Approx(0.25).epsilon(0.03));
  for (std::uint32_t node = 8; node < 12; ++node) CHECK(faces.area_at(node) == Approx(0.24).epsilon(0.03));
  CHECK(faces.points[4].area > 0.0);
}

TEST_CASE("without points there is nothing to share", "[contact][node_areas]") {
  SharedFaces faces;
  faces.share_out();
  CHECK(faces.points.empty());
}
