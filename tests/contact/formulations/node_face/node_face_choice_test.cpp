// SPDX-License-Identifier: BSD-3-Clause
// Which of the faces near it a node touches: one, those of the edge behind which it stands, the walls of a
// hollow.
#include <cmath>

#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/tip_on_floor.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// The points of a ball among bodies at rest, before the first step.
std::vector<ContactPoint> points_of_ball(const MeshBuilder& builder) {
  ContactParts parts(builder, general_contact("penalty stiffness = 1000\n"));
  NodeFaceContacts contacts(parts.setup());
  parts.search();
  contacts.take_candidates(parts.node_faces);
  std::vector<ContactPoint> points;
  contacts.begin_detection(parts.context());
  contacts.detect(parts.context(), {0, contacts.n_rows()}, points);
  std::erase_if(points, [](const ContactPoint& point) { return !point.touches(); });
  return points;
}

/// A block 4 wide and 2 high whose middle lies at some distance from the origin along x or y; its near side
/// is `distance` away.
void add_wall(MeshBuilder& b, std::int64_t id, const Vector3d& way, double distance) {
  const Vector3d size = Vector3d(way.x() != 0.0 ? 1.0 : 4.0, way.y() != 0.0 ? 1.0 : 4.0, 2.0);
  const Vector3d middle = (distance + 0.5) * way;
  b.add_hexes({.id = id, .origin = middle - 0.5 * size, .size = size, .share_nodes = false});
}

}  // namespace

TEST_CASE("a node gets one force over a face, an edge and a corner, always the same",
          "[contact][node_face_contacts]") {
  for (const Vector3d& entity : {Vector3d(0.6, 0.7, 0), Vector3d(1.0, 0.7, 0), Vector3d(0.6, 1.0, 0),
                                 Vector3d(1.0, 1.0, 0), Vector3d(1.0 + 1e-12, 1.0 - 1e-12, 0)}) {
    TipOnFloor parts;
    const auto points = parts.put(entity - Vector3d(0, 0, 0.01));
    REQUIRE(points.size() == 1);
    CHECK(points[0].force == Approx(tip_stiffness * tip_area * 0.01).epsilon(1e-12));
    CHECK((points[0].normal - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK(points[0].gap == Approx(-0.01));
    CHECK(points[0].first.nodes[0] == points[0].first.nodes[3]);
    // The face's share stands under the node.
    Vector3d under = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      under += points[0].second.weights[static_cast<int>(k)] * parts.kinematics.x(points[0].second.nodes[k]);
    CHECK((under - entity).norm() < 1e-12);
  }
}

TEST_CASE("the faces of a ridge share a node behind it, and none pushes it aside",
          "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({1.0, 1.0, 0.02});
  // The middle of the top is lifted: a ridge with slopes of 0.1.
  for (Eigen::Index i = 12; i < parts.x.cols(); ++i) {
    if (parts.x(0, i) == 1.0 && parts.x(2, i) == 0.0) parts.x(2, i) = 0.1;
  }
  const auto points = parts.put({1.0, 0.7, 0.09});
  REQUIRE(points.size() == 2);
  const Vector3d force = points[0].force_on_first() + points[1].force_on_first();
  CHECK(std::abs(force[0]) < 1e-12 * force[2]);
  CHECK(points[0].force == Approx(points[1].force).epsilon(1e-12));
  const double depth = 0.01 / std::sqrt(1.01);
  CHECK(points[0].gap == Approx(-depth).epsilon(1e-9));
  CHECK(force.norm() < tip_stiffness * 1.1 * tip_area * depth);
}

TEST_CASE("a node comes out where it went in", "[contact][node_face_contacts]") {
  TipOnFloor parts;
  parts.put({1.9, 0.7, 0.02});
  // It ends up nearer to the side at x = 2 than to the top.
  for (int step = 0; step < 10; ++step) {
    const auto points = parts.put({1.9, 0.7, -0.02 * step}, true);
    if (step == 0) continue;
    REQUIRE(points.size() == 1);
    CHECK((points[0].normal - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK(points[0].gap == Approx(-0.02 * step));
  }
}

TEST_CASE("in a hollow a node touches both walls", "[contact][node_face_contacts]") {
  TipOnFloor parts("", true);
  const auto points = parts.put({2.02, 0.7, -0.01});
  REQUIRE(points.size() == 2);
  double along_x = 0.0, along_z = 0.0;
  for (const ContactPoint& point : points) {
    along_x += point.force * point.normal.x();
    along_z += point.force * point.normal.z();
  }
  CHECK(along_z == Approx(tip_stiffness * tip_area * 0.01));
  CHECK(along_x < -1.0);
}

TEST_CASE("faces in one plane share a node at their edge where they push unlike",
          "[contact][node_face_contacts]") {
  // Without a stiffness of the pair the springs of both sides stand in series.
  ContactParts bare(TipOnFloor::make(false), general_contact("",
                                                             "contact surface floor contains block_1\n"
                                                             "contact node set tip contains tip\n"));
  for (ContactFace& face : bare.contact_mesh.faces)
    face.penalty_properties.stiffness =
        bare.kinematics.x(face.corners[0]).x() + bare.kinematics.x(face.corners[2]).x() < 2.0 ? 1000.0
                                                                                              : 3000.0;
  for (SurfaceNode& node : bare.contact_mesh.surface_nodes) node.penalty_properties.stiffness = 1000.0;
  NodeFaceContacts contacts(bare.setup());
  for (Eigen::Index i = 8; i < 12; ++i) bare.x.col(i) += Vector3d(1.0, 0.7, -0.01);
  bare.search();
  contacts.take_candidates(bare.node_faces);
  std::vector<ContactPoint> points;
  contacts.begin_detection(bare.context());
  contacts.detect(bare.context(), {0, contacts.n_rows()}, points);
  REQUIRE(points.size() == 2);
  CHECK(points[0].second_entity != points[1].second_entity);
  // k1 k2 / (k1 + k2) is 500 and 750 per area, each of half the node.
  CHECK(points[0].stiffness + points[1].stiffness == Approx(0.5 * tip_area * (500.0 + 750.0)));
  CHECK(points[0].area == Approx(0.5 * tip_area));
  CHECK(points[1].area == Approx(0.5 * tip_area));
}

TEST_CASE("a ball fills a slot that is narrower than it is", "[contact][node_face_contacts]") {
  MeshBuilder b;
  add_wall(b, 1, Vector3d::UnitX(), 0.095);
  add_wall(b, 2, -Vector3d::UnitX(), 0.097);
  add_balls(b, 3, {{0, 0, 0}}, 0.1);
  const auto points = points_of_ball(b);
  REQUIRE(points.size() == 2);
  CHECK(points[0].normal.dot(points[1].normal) == Approx(-1.0));
  CHECK(points[0].gap == Approx(-0.005));  // the nearest first
  CHECK(points[1].gap == Approx(-0.003));
  CHECK(points[0].area == Approx(points[1].area));
}

TEST_CASE("a ball touches the three nearest walls of a shaft, not the fourth",
          "[contact][node_face_contacts]") {
  MeshBuilder b;
  add_wall(b, 1, Vector3d::UnitX(), 0.091);
  add_wall(b, 2, -Vector3d::UnitY(), 0.092);
  add_wall(b, 3, Vector3d::UnitY(), 0.093);
  add_wall(b, 4, -Vector3d::UnitX(), 0.094);
  add_balls(b, 5, {{0, 0, 0}}, 0.1);
  const auto points = points_of_ball(b);
  REQUIRE(points.size() == 3);
  CHECK((points[0].normal + Vector3d::UnitX()).norm() < 1e-12);
  CHECK((points[1].normal - Vector3d::UnitY()).norm() < 1e-12);
  CHECK((points[2].normal + Vector3d::UnitY()).norm() < 1e-12);
}
