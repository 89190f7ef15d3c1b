// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "support/contact_bodies.hpp"

namespace contactsim::test {

/// Two unit cubes of eight nodes of mass 0.5, one above the other and apart by 1; contact nodes are numbered
/// as those of the mesh, along x first, then y, then z.
struct TwoCubes {
  ContactParts parts;
  Model model;

  explicit TwoCubes(const std::string& more = "") : parts(cubes(), general_contact(more)) {
    model.mesh = &parts.mesh;
    model.mass = Eigen::RowVectorXd::Constant(16, 0.5);
  }
  void hold(std::vector<NodeIndex> nodes, const Direction& direction) {
    PrescribedMotion held;
    held.nodes = std::move(nodes);
    held.direction = direction;
    model.kinematic_constraints = KinematicConstraints(parts.mesh, {held});
  }
  /// The second cube is a body of mass 8 and moments of inertia 4, 4 and 2.
  const Model& make_rigid() {
    RigidBody body;
    body.mass = 8;
    body.centre << 0.5, 0.5, 2.5;
    body.inertia = Eigen::Vector3d(4.0, 4.0, 2.0).asDiagonal();
    body.flexible = Eigen::Vector3d(0.25, 0.25, 0.5).asDiagonal();
    model.rigid.bodies = {body};
    model.rigid.nodes.body_of.assign(16, std::nullopt);
    std::fill(model.rigid.nodes.body_of.begin() + 8, model.rigid.nodes.body_of.end(), 0);
    return model;
  }
  /// At rest between two steps of the same size.
  State state(double dt) const {
    State state = make_state(parts.x, {}, 0.0);
    state.dt = state.next_dt = dt;
    for (const RigidBody& body : model.rigid.bodies) state.rigid.emplace_back().position = body.centre;
    return state;
  }
  static MeshBuilder cubes() {
    MeshBuilder b;
    b.add_hexes({.id = 1});
    b.add_hexes({.id = 2, .origin = {0, 0, 2}, .share_nodes = false});
    return b;
  }
  /// A node of the upper cube above the middle of the top of the lower one.
  static ContactPoint corner_over_face() {
    ContactPoint point;
    point.first.nodes.fill({8});
    point.first.weights = Eigen::Vector4d::UnitX();
    point.second.nodes = {{{4}, {5}, {7}, {6}}};
    point.second.weights.setConstant(0.25);
    point.normal = Eigen::Vector3d::UnitZ();
    point.area = 1.0;
    return point;
  }
};

}  // namespace contactsim::test
