// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/offset_moments.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A lofted plate in a plane, and a force on one of its contact nodes.
struct PushedPlate {
  test::ContactParts parts{plate(), test::general_contact()};
  const ContactMesh& contact_mesh = parts.contact_mesh;
  ContactAssembler sums{contact_mesh.n_nodes(), 1, false, true};
  Model model;
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, 9), moments = forces;

  PushedPlate() { model.inertia = Eigen::RowVectorXd::Constant(9, 0.02); }
  static test::MeshBuilder plate() {
    test::MeshBuilder b;
    test::add_plate(b, {.id = 1, .cells = {2, 2}, .u = {2, 0, 0}, .v = {0, 2, 0}}, 0.2);
    return b;
  }
  void turn_with_mid_surface() {
    parts.kinematics.turn_by(LoftSpins(contact_mesh.loft, 9, RigidNodes{}));
    parts.move();
  }
  /// The contact node above a node of the mesh.
  ContactNodeIndex above(NodeIndex mesh_node) const {
    for (auto i = static_cast<std::uint32_t>(contact_mesh.n_mesh_points()); i < contact_mesh.n_nodes(); ++i) {
      if (contact_mesh.mesh_nodes[{i}] == mesh_node && parts.kinematics.x({i}).z() > 0.0) return {i};
    }
    return {};
  }
  void push(ContactNodeIndex node, const Vector3d& force) {
    sums.begin_step();
    sums.add_node(node, force, Vector3d::Zero());
    forces.col(contact_mesh.mesh_nodes[node].value) = force;
  }
  void find() {
    OffsetMoments offsets(contact_mesh, parts.kinematics, sums);
    offsets.add_forces(forces);
    moments.setConstant(7.0);  // whatever it held is gone
    offsets.set(model, moments);
  }
  Vector3d moment() const {
    Vector3d sum = moments.rowwise().sum();
    for (Eigen::Index i = 0; i < 9; ++i) sum += Vector3d(parts.x.col(i)).cross(Vector3d(forces.col(i)));
    return sum;
  }
};

}  // namespace

TEST_CASE("a force on a loft turns the node that it hangs on where nothing else does",
          "[contact][offset_moments]") {
  PushedPlate plate;
  plate.push(plate.above({4}), {3, 0, 5});
  plate.find();
  CHECK(plate.moments.col(4).isApprox(Vector3d(0, 0, 0.1).cross(Vector3d(3, 0, 5))));
  plate.moments.col(4).setZero();
  CHECK(plate.moments.isZero(0.0));
  CHECK(plate.forces.col(4) == Vector3d(3, 0, 5));
}

TEST_CASE("a moment on a mid surface goes to the nodes around as forces without a sum",
          "[contact][offset_moments]") {
  PushedPlate plate;
  plate.turn_with_mid_surface();
  const std::uint32_t node = GENERATE(0, 1, 4);  // a corner, an edge, the middle
  const ContactNodeIndex point = plate.above({node});
  const Vector3d force(3, -2, 5);
  plate.push(point, force);
  plate.find();
  CHECK(plate.moments.isZero(0.0));
  CHECK((plate.forces.rowwise().sum() - force).norm() < 1e-14);
  CHECK((plate.moment() - Vector3d(plate.parts.kinematics.x(point)).cross(force)).norm() < 1e-14);
  CHECK((plate.forces.colwise().norm().array() > 1e-3).count() > 2);
}

TEST_CASE("moments of spheres turn their nodes, those of nodes that do not turn are lost",
          "[contact][offset_moments]") {
  PushedPlate plate;
  plate.sums.begin_step();
  plate.sums.add_node({0}, Vector3d::Zero(), {1, 2, 3});
  plate.model.inertia(4) = 0.0;
  plate.sums.add_node(plate.above({4}), {3, 0, 5}, {1, 1, 1});
  plate.find();
  const std::uint32_t node = plate.contact_mesh.mesh_nodes[{0}].value;
  CHECK(plate.moments.col(node) == Vector3d(1, 2, 3));
  plate.moments.col(node).setZero();
  CHECK(plate.moments.isZero(0.0));
}
