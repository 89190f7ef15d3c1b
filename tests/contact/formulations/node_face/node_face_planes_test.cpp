// SPDX-License-Identifier: BSD-3-Clause
// Nodes that slide infinitesimally meet the planes of the faces over which they stood at the start.
#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A floor of two unit cells along x, and a cube of 0.5 on it whose corners to the left stand over the edge
/// between both cells, the others over the second cell. Side B, whose nodes count, is the cube.
struct SlidingCube : ContactParts {
  SlidingCube()
      : ContactParts(make(), sliding), contacts(setup()), contact_search(contact_mesh, mesh, rules, {}, {}) {
    renew();
  }
  static MeshBuilder make() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
    return b.add_hexes({.id = 2, .origin = {1.0, 0.2, 1.0}, .size = {0.5, 0.5, 0.5}, .share_nodes = false});
  }
  inline static const std::string sliding =
      "skin all blocks = on\nbegin interaction\nside a = block_1\nside b = block_2\n"
      "interaction behavior = infinitesimal_sliding\nconstraint formulation = node_face\n"
      "penalty stiffness = 1000\nend\n";

  NodeFaceContacts contacts;
  ContactSearch contact_search;

  FaceIndex cell(std::uint32_t element) const { return face_of(*this, element, Vector3d::UnitZ()); }
  void move_cube(const Vector3d& way) {
    for (const NodeIndex node : mesh.blocks()[1].nodes) x.col(node.value) += way;
    renew();
  }
  void renew() {
    move();
    contact_search.find_face_pairs(kinematics, motion(), {}, face_partners);
    contacts.find_candidates(contact_search, kinematics, motion());
    contact_search.finish(kinematics);
  }
  std::vector<ContactPoint> find() {
    std::vector<ContactPoint> points;
    contacts.begin_detection(context());
    contacts.detect(context(), {0, contacts.n_rows()}, points);
    return points;
  }
  Vector3d under(const ContactPoint& point) const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      sum += point.second.weights[static_cast<Eigen::Index>(k)] * kinematics.x(point.second.nodes[k]);
    return sum;
  }
};

}  // namespace

TEST_CASE("a node off the edges of its face stands on the plane that goes on from it",
          "[contact][node_face_planes]") {
  const double way = GENERATE(0.3, 1.5, 20.0);
  SlidingCube cube;
  cube.move_cube({way, 0, -0.01});
  const auto points = cube.find();
  REQUIRE(points.size() == 4);  // those to the left stand nearer to the second cell
  for (const ContactPoint& point : points) {
    const Vector3d x = cube.kinematics.x(point.first.nodes[0]);
    CHECK(point.second_face() == cube.cell(1));
    CHECK(point.gap == Approx(-0.01));
    CHECK(point.force == Approx(1000.0 * 0.0625 * 0.01));
    CHECK((point.normal - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK(point.second.weights.sum() == Approx(1.0));
    CHECK((cube.under(point) - Vector3d(x.x(), x.y(), 1.0)).norm() < 1e-10);  // so that no moment is left
  }
}

TEST_CASE("of two planes a node meets the one whose face is nearer, of a face and a plane the face",
          "[contact][node_face_planes]") {
  SlidingCube cube;
  cube.move_cube({-0.3, 0, -0.01});  // to the left over the first cell, to the right over the second one
  for (const ContactPoint& point : cube.find()) {
    const bool is_left = cube.kinematics.x(point.first.nodes[0]).x() < 1.0;
    CHECK(point.second_face() == cube.cell(is_left ? 0 : 1));
  }
  CHECK(cube.find().size() == 4);
  cube.move_cube({-1.0, 0, 0});  // to the left at -0.3, beyond either; to the right at 0.2
  std::size_t n_left = 0;
  for (const ContactPoint& point : cube.find()) {
    const bool is_left = cube.kinematics.x(point.first.nodes[0]).x() < 0.0;
    n_left += is_left ? 1 : 0;
    // Those to the right stood over the second cell alone: its plane is theirs, not the cell below them.
    CHECK(point.second_face() == cube.cell(is_left ? 0 : 1));
  }
  CHECK(n_left == 2);
}

TEST_CASE("the plane of a face turns with it", "[contact][node_face_planes]") {
  SlidingCube cube;
  for (Eigen::Index i = 0; i < cube.x.cols(); ++i) {
    if (cube.x(0, i) == 2.0 && cube.x(2, i) == 1.0) cube.x(2, i) += 0.2;
  }
  cube.move_cube({2.0, 0, 0.39});  // at 3 and 3.5, where the plane is at 1.4 and 1.5; the nodes at 1.39
  const auto points = cube.find();
  REQUIRE(points.size() == 4);
  const double cosine = 1.0 / std::sqrt(1.04);
  for (const ContactPoint& point : points) {
    const bool is_left = cube.kinematics.x(point.first.nodes[0]).x() < 3.2;
    CHECK(point.gap == Approx(cosine * (is_left ? -0.01 : -0.11)));
    CHECK((point.normal - cosine * Vector3d(-0.2, 0, 1)).norm() < 1e-12);
  }
}
