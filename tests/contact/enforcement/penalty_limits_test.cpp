// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/penalty_limits.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;

TEST_CASE("light nodes lower the stiffness alike in the middle and at the edges of a face",
          "[contact][penalty_limits]") {
  // 2 x 2 x 1 elements of density 1, 1 x 1 x 3: behind the top 1.5 of mass per area, behind the sides 0.5.
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 3}});
  test::ContactParts parts(b, test::general_contact());
  for (const NodeIndex node : parts.contact_mesh.mesh_nodes) {
    const Eigen::Vector3d x = parts.x.col(node.value);
    parts.contact_mesh.mass.push_back(0.375 * (x[0] == 1.0 ? 2.0 : 1.0) * (x[1] == 1.0 ? 2.0 : 1.0));
  }
  for (ContactFace& face : parts.contact_mesh.faces) face.penalty_properties.stiffness = 1e9;
  for (SurfaceNode& node : parts.contact_mesh.surface_nodes) node.penalty_properties.stiffness = 1e9;
  parts.contact_mesh.faces[{0}].penalty_properties.stiffness = 1e-3;
  Model model;
  model.mesh = &parts.mesh;
  limit_stiffness(parts.kinematics, ContactMobility(model), 0.1, parts.contact_mesh);
  CHECK(parts.contact_mesh.faces[{0}].penalty_properties.stiffness == 1e-3);
  for (const FaceIndex f : IndexRange(FaceIndex{1}, parts.contact_mesh.faces.next())) {
    const bool is_side = std::abs(parts.kinematics.bound(f).normal().cast<double>()[2]) < 0.5;
    CHECK(parts.contact_mesh.faces[f].penalty_properties.stiffness ==
          Approx(4.0 * penalty_share * (is_side ? 0.5 : 1.5) * 100.0));
  }
  for (const SurfaceNode& node : parts.contact_mesh.surface_nodes) {
    const Eigen::Vector3d x = parts.x.col(parts.contact_mesh.mesh_nodes[node.node].value);
    const bool is_inner = x[0] == 1.0 && x[1] == 1.0;
    CHECK(node.penalty_properties.stiffness == Approx(4.0 * penalty_share * (is_inner ? 1.5 : 0.5) * 100.0));
  }
}

TEST_CASE("faces that are held along their normal, or rigid, have no limit and are rigid",
          "[contact][penalty_limits]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1});
  test::ContactParts parts(b, test::general_contact());
  parts.contact_mesh.mass.assign(8, 1e-3);
  for (ContactFace& face : parts.contact_mesh.faces) face.penalty_properties.stiffness = 1e9;
  Model model;
  model.mesh = &parts.mesh;
  model.mass = Eigen::RowVectorXd::Constant(8, 1e-3);
  PrescribedMotion held;
  held.direction = Components{{false, false, true}};
  for (std::uint32_t node = 0; node < 8; ++node) held.nodes.push_back({node});
  const bool is_rigid = GENERATE(false, true);
  if (is_rigid) {
    model.rigid.nodes.body_of.assign(8, 0);
  } else {
    model.kinematic_constraints = KinematicConstraints(parts.mesh, {held});
  }
  ContactMobility mobility(model);
  mobility.update(0.0);
  limit_stiffness(parts.kinematics, mobility, 0.1, parts.contact_mesh);
  for (const FaceIndex f : indices(parts.contact_mesh.faces)) {
    const bool is_side = std::abs(parts.kinematics.bound(f).normal().cast<double>()[2]) < 0.5;
    CHECK(parts.contact_mesh.faces[f].penalty_properties.is_rigid == (is_rigid || !is_side));
    if (!is_rigid && !is_side) CHECK(parts.contact_mesh.faces[f].penalty_properties.stiffness == 1e9);
  }
}

TEST_CASE("edges and nodes without faces have the limit of a mass against a wall",
          "[contact][penalty_limits]") {
  test::MeshBuilder b;
  b.add_bars({.id = 1, .cells = 1}).set_attributes(1, {"area"}, {0.04});
  b.add_spheres(2, "", {{0, 0, 3}}).set_attributes(2, {"radius"}, {0.5});
  test::ContactParts parts(b, test::general_contact());
  ContactMesh& contact_mesh = parts.contact_mesh;
  contact_mesh.mass.assign(3, 0.5);
  contact_mesh.mass[{1}] = 0.1;
  for (SurfaceNode& node : contact_mesh.surface_nodes) node.penalty_properties.stiffness = 1e9;
  for (ContactEdge& edge : contact_mesh.edges) edge.penalty_properties.stiffness = 1e9;
  Model model;
  model.mesh = &parts.mesh;
  limit_stiffness(parts.kinematics, ContactMobility(model), 0.1, contact_mesh);
  REQUIRE(contact_mesh.edges.size() == 2);
  for (const ContactEdge& edge : contact_mesh.edges) {
    // The lighter end counts.
    const double mass = edge.is_particle() ? 0.5 : 0.1;
    CHECK(edge.penalty_properties.stiffness ==
          Approx(4.0 * penalty_share * mass / (edge.width * edge.width) * 100.0));
    CHECK_FALSE(edge.penalty_properties.is_rigid);
  }
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    CHECK(node.penalty_properties.stiffness ==
          Approx(4.0 * penalty_share * contact_mesh.mass[node.node] / node.area * 100.0));
  }
}
