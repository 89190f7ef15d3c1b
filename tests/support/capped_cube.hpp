// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "core/dynamics/rigid_motion.hpp"
#include "core/statics/node_graph.hpp"
#include "support/static_cube.hpp"

namespace contactsim::test {

/// A force on the first node of the top that keeps its direction.
class DeadLoad final : public ForceTerm {
 public:
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override {
    forces = Eigen::Matrix3Xd::Zero(3, motion.coordinates.cols());
    forces.col(node) = force;
    return {};
  }
  Eigen::Index node = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

/// An elastic cube of edge 2 on held nodes, whose nodes at z = 2 are those of a rigid body.
struct CappedCube {
  Mesh mesh = MeshBuilder().add_hexes({.cells = {2, 2, 2}, .size = {2, 2, 2}}).build();
  Model model;
  State state;
  DeadLoad load;
  std::optional<InternalForce> internal;
  std::optional<StaticProblem> problem;

  explicit CappedCube(bool drives = false) {
    model.mesh = &mesh;
    ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
    properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = 0.0;
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_selective_deviatoric, properties));
    model.mass = lumped_mass(mesh, model.blocks);
    PrescribedMotion fixed;
    fixed.direction = Components{{true, true, true}};
    for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
      if (mesh.coordinates()(2, i) == 0.0) fixed.nodes.push_back({i});
    }
    model.kinematic_constraints = KinematicConstraints(mesh, {fixed});
    add_cap();
    if (drives) drive();
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    start_rigid_bodies(model, state);
    internal.emplace(model, state);
    problem.emplace(model, ForceTerms{*internal, load}, nullptr, ResidualReference::internal, state);
    problem->begin_step(1.0);
  }

  void add_cap() {
    RigidBody cap;
    cap.name = "cap";
    cap.mass = 1.0;
    cap.inertia.setIdentity();
    cap.centre = {0.8, 1.1, 2.5};
    model.rigid.nodes.body_of.assign(mesh.n_nodes(), std::nullopt);
    for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
      if (mesh.coordinates()(2, i) != 2.0) continue;
      cap.nodes.push_back({i});
      model.rigid.nodes.body_of[i] = 0;
    }
    cap.arms.resize(3, static_cast<Eigen::Index>(cap.nodes.size()));
    for (std::size_t k = 0; k < cap.nodes.size(); ++k)
      cap.arms.col(static_cast<Eigen::Index>(k)) = mesh.coordinates().col(cap.nodes[k].value) - cap.centre;
    load.node = cap.nodes.front().value;
    model.rigid.bodies.push_back(cap);
    MeshParts centres;
    centres.coordinates = cap.centre;
    model.rigid.nodes.references = std::make_shared<const Mesh>(std::move(centres));
  }

  /// Fixes the cap but for x, along which it goes with a velocity of 1e-4.
  void drive() {
    const Mesh& centres = *model.rigid.nodes.references;
    PrescribedMotion fixed, moved;
    fixed.direction = Components{{false, true, true}};
    moved.direction = Components{{true, false, false}};
    moved.type = MotionType::velocity;
    moved.value = ConditionFunction{1e-4};
    fixed.nodes = moved.nodes = {NodeIndex{0}};
    model.rigid.kinematic_constraints = KinematicConstraints(centres, {fixed, moved});
    fixed.direction = Components{{true, true, true}};
    model.rigid.rotation_constraints = KinematicConstraints(centres, {fixed});
  }

  Eigen::Index centre() const { return 3 * Eigen::Index{problem->bodies().centre_node(0)}; }
  Eigen::VectorXd still() const { return Eigen::VectorXd::Zero(problem->size()); }
  /// The cap turned by an angle and moved, all other nodes at rest.
  Eigen::VectorXd turned(double angle) const {
    Eigen::VectorXd increment = still();
    increment.segment<6>(centre()) << 0.01, -0.02, 0.03, 0.5 * angle, -0.3 * angle, 0.8 * angle;
    return increment;
  }
  NodeGraph graph() const { return {mesh.n_nodes(), mesh, model.blocks, 1}; }
};

}  // namespace contactsim::test
