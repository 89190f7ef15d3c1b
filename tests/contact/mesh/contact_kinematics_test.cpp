// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_kinematics.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A cube of edge 2 and a tetrahedron, both with all their faces.
MeshBuilder cube_and_tet() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .size = {2, 2, 2}});
  const std::uint32_t first = b.add_node({9, 0, 0}).value;
  b.add_node({12, 0, 0});
  b.add_node({9, 3, 0});
  b.add_node({9, 0, 3});
  b.add_block(2, "", Shape::tet4, {first, first + 1, first + 2, first + 3});
  return b;
}

}  // namespace

TEST_CASE("bounds of faces tell centre, normal, velocity and radius", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  const Vector3d speed(1, 2, 3);
  parts.v.colwise() = speed;
  parts.v.col(0) += Vector3d(4, 0, 0);
  parts.move();
  REQUIRE(parts.contact_mesh.faces.size() == 10);
  for (const FaceIndex f : IndexRange(FaceIndex{0}, FaceIndex{10})) {
    const FaceBound& bound = parts.kinematics.bound(f);
    const Vector3d body = f.value < 6 ? Vector3d(1, 1, 1) : Vector3d(9.75, 0.75, 0.75);
    CHECK((bound.centre() - body).dot(bound.normal().cast<double>()) ==
          Approx(f.value < 6 ? 1.0 : (bound.centre() - body).norm()).epsilon(0.5));
    CHECK(bound.normal().cast<double>().norm() == Approx(1.0));
    if (f.value >= 6) continue;
    CHECK(bound.radius() == Approx(std::sqrt(2.0)));
    const auto& corners = parts.contact_mesh.faces[f].corners;
    const bool has_first = std::ranges::count(corners, ContactNodeIndex{0}) > 0;
    CHECK((bound.velocity().cast<double>() - speed - Vector3d(has_first ? 1.0 : 0.0, 0, 0)).norm() < 1e-14);
  }
}

TEST_CASE("the corners of a triangle count once in its bounds", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  parts.v.col(9) = Vector3d(3, 0, 0);
  parts.move();
  int n_floors = 0;
  for (const FaceIndex f : IndexRange(FaceIndex{6}, FaceIndex{10})) {
    const FaceBound& bound = parts.kinematics.bound(f);
    if (std::abs(bound.normal().cast<double>().z() + 1.0) > 1e-12) continue;
    ++n_floors;
    CHECK((bound.centre() - Vector3d(10, 1, 0)).norm() < 1e-14);
    CHECK((bound.velocity().cast<double>() - Vector3d(1, 0, 0)).norm() < 1e-14);
    CHECK(bound.radius() == Approx(std::sqrt(5.0)));
    CHECK(parts.kinematics.face(f).is_triangle);
  }
  CHECK(n_floors == 1);
}

TEST_CASE("only watched faces are followed until all are asked for", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  const Vector3d before = parts.kinematics.bound({0}).centre(), other = parts.kinematics.bound({1}).centre(),
                 way(0, 0, 5);
  parts.x.colwise() += way;
  parts.kinematics.watch({FaceIndex{1}});
  parts.kinematics.move_nodes(parts.motion());
  parts.kinematics.bound_watched();
  CHECK(parts.kinematics.bound({0}).centre() == before);
  CHECK((parts.kinematics.bound({1}).centre() - other - way).norm() < 1e-14);
  parts.kinematics.bound_all();
  CHECK((parts.kinematics.bound({0}).centre() - before - way).norm() < 1e-14);
}

TEST_CASE("close faces are followed alone, and say so", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  CHECK(parts.kinematics.n_bounded() == parts.contact_mesh.faces.size());
  const Vector3d before = parts.kinematics.bound({0}).centre();
  parts.kinematics.watch({FaceIndex{0}, FaceIndex{1}, FaceIndex{3}});
  parts.kinematics.watch_close({FaceIndex{3}});
  parts.x.colwise() += Vector3d(1, 0, 0);
  parts.kinematics.move_nodes(parts.motion());
  parts.kinematics.bound_close();
  CHECK(parts.kinematics.bound({0}).centre() == before);
  REQUIRE(parts.kinematics.n_bounded() == 1);
  CHECK(parts.kinematics.bounded(0) == FaceIndex{3});
  parts.kinematics.bound_watched();
  REQUIRE(parts.kinematics.n_bounded() == 3);
  CHECK(parts.kinematics.bounded(2) == FaceIndex{3});
  CHECK((parts.kinematics.bound({0}).centre() - before - Vector3d(1, 0, 0)).norm() < 1e-14);
}

TEST_CASE("the path is as long as the largest motions together", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  const double before = parts.kinematics.path();
  parts.x.col(2) += Vector3d(3, 0, 4);
  parts.x.col(5) += Vector3d(0, 1, 0);
  parts.move();
  CHECK(parts.kinematics.path() - before == Approx(5.0));
  parts.x.col(5) -= Vector3d(0, 1, 0);
  parts.move();
  CHECK(parts.kinematics.path() - before == Approx(6.0));
  parts.v.col(1) = Vector3d(1, 2, 2);
  CHECK(parts.kinematics.largest_speed() == Approx(3.0));
  parts.x(0, 0) = std::numeric_limits<double>::quiet_NaN();
  parts.move();
  CHECK(std::isinf(parts.kinematics.path()));
}

TEST_CASE("a face is handed out with its corners as they move", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  parts.x.colwise() += Vector3d(0.5, 0, 0);
  for (Eigen::Index i = 0; i < parts.v.cols(); ++i) parts.v(1, i) = double(i);
  parts.move();
  for (const FaceIndex f : IndexRange(FaceIndex{0}, FaceIndex{10})) {
    const MovingFace face = parts.kinematics.face(f);
    const ContactFace& of = parts.contact_mesh.faces[f];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto node = static_cast<Eigen::Index>(parts.contact_mesh.mesh_nodes[of.corners[k]].value);
      CHECK(face.x.col(static_cast<int>(k)) == parts.x.col(node));
      CHECK(face.v.col(static_cast<int>(k)) == parts.v.col(node));
    }
    CHECK(face.is_triangle == (f.value >= 6));
    CHECK((face.normal() - parts.kinematics.bound(f).normal().cast<double>()).norm() < 1e-6);
  }
}

TEST_CASE("the sides of an edge do not count for what its top touches", "[contact][contact_kinematics]") {
  // A corner of a cube of edge 2 has a quarter of three faces, 1 each.
  ContactParts parts(cube_and_tet(), general_contact());
  const SurfaceNode& corner = parts.contact_mesh.surface_nodes[{0}];
  REQUIRE(parts.x.col(0) == Vector3d::Zero());
  REQUIRE(corner.area == Approx(3.0));
  CHECK(parts.kinematics.area_against(corner, Vector3d::UnitZ()) == Approx(1.0));
  CHECK(parts.kinematics.area_against(corner, Vector3d(0, 0.6, 0.8)) == Approx(1.4));
  CHECK(parts.kinematics.area_against(corner, -Vector3d::UnitZ()) == Approx(0.03));
  parts.x *= 2.0;
  parts.move();
  CHECK(parts.kinematics.area_against(corner, Vector3d::UnitZ()) == Approx(4.0));
}

TEST_CASE("corners of quadrilaterals share their area by four, of triangles by three",
          "[contact][contact_kinematics]") {
  const ContactParts parts(cube_and_tet(), general_contact());
  for (const FaceIndex f : IndexRange(FaceIndex{0}, FaceIndex{10})) {
    const Vector3d normal = parts.kinematics.face(f).normal();
    const double area = f.value < 6 ? 4.0 : normal.minCoeff() < -0.9 ? 4.5 : 4.5 * std::sqrt(3.0);
    CHECK((parts.kinematics.corner_area(f) - area / (f.value < 6 ? 4.0 : 3.0) * normal).norm() < 1e-14);
  }
}

TEST_CASE("nodes of a set without faces of their own have their area at the start all round",
          "[contact][contact_kinematics]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .size = {2, 2, 2}});
  b.add_node_set(5, "tip", [](const Vector3d& x) { return x.norm() < 0.1; });
  const ContactParts parts(b, "contact node set tip_nodes contains tip\n");
  REQUIRE(parts.contact_mesh.surface_nodes.size() == 1);
  const SurfaceNode& tip = parts.contact_mesh.surface_nodes[{0}];
  CHECK(tip.area > 0.0);
  CHECK(parts.kinematics.area_against(tip, Vector3d::UnitX()) == tip.area);
}

TEST_CASE("contact nodes are foreseen to move by the accelerations of now", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  for (Eigen::Index i = 0; i < parts.v.cols(); ++i) parts.v.col(i).setConstant(double(i));
  parts.move();
  State state = make_state(parts.x, {}, 0.0, parts.v);
  state.acceleration.setConstant(4.0);
  state.dt = 0.25;
  state.next_dt = 0.75;
  parts.kinematics.foresee(state);
  for (const ContactNodeIndex i : parts.contact_mesh.nodes()) {
    const double before = parts.contact_mesh.mesh_nodes[i].value;
    CHECK(parts.kinematics.v(i) == Vector3d::Constant(before + 0.5 * 4.0));
    CHECK(parts.kinematics.last_v(i) == Vector3d::Constant(before));
  }
  // Until they move again.
  parts.move();
  CHECK(parts.kinematics.v({1}) == Vector3d::Ones());
}

TEST_CASE("contact nodes at another moment are others, with no bounds", "[contact][contact_kinematics]") {
  ContactParts parts(cube_and_tet(), general_contact());
  parts.move();
  const Eigen::Matrix3Xd later = parts.x.array() + 1.0, velocity = parts.v.array() + 2.0;
  const ContactKinematics moved = parts.kinematics.at({1.0, 0.5, later, velocity});
  CHECK(moved.x({3}) == later.col(3));
  CHECK(moved.v({3}) == Vector3d::Constant(2.0));
  CHECK(parts.kinematics.x({3}) == parts.x.col(3));
  CHECK(moved.bytes() < parts.kinematics.bytes());
}
