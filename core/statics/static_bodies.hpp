// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// What an unknown of a rigid body, or of a node that belongs to none, moves a node by.
struct Carrier {
  std::uint32_t node = 0;  ///< whose unknowns they are
  bool turns = false;      ///< its rotation; else its displacement
  Eigen::Matrix3d share;   ///< [1], of rotations [length]
};

/// The rigid bodies of load steps. Each has two nodes of its own behind those of the mesh: the first is moved
/// as the centre, the displacement of the second is the rotation vector t of the step times the body's size
/// L, so that all unknowns are lengths and all residuals forces. The unknowns of the body's nodes in the mesh
/// say what they move besides their body, which is nothing but in probes of the stiffness. With arms r of
/// now, a small change of the unknowns moves a node by
///   dx = du + J(t) dt x r,  J(t) = I + (1 - cos|t|)/|t|^2 [t] + (|t| - sin|t|)/|t|^3 [t]^2,
/// and residuals are what does the same work: F = sum of f, J^T M / L with M = sum of r x f + m.
class StaticBodies {
 public:
  /// Of the largest stiffness of a node of the mesh: what bodies that nothing else holds get to the ground in
  /// preconditioners. A cube of modulus E resists with E times its edge, its nodes with E times theirs.
  static constexpr double ground_share = 1e-2;
  /// The same of bodies that are held: what turns about the only node that an element has of them, or about
  /// a row of such nodes, has no other stiffness.
  static constexpr double least_share = 1e-8;

  /// Both must outlive it.
  StaticBodies(const Model& model, State& state);

  bool empty() const { return model_.rigid.empty(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(model_.rigid.bodies.size()); }
  /// With those of bodies.
  std::uint32_t n_nodes() const { return n_mesh_ + 2 * size(); }
  bool is_of_mesh(std::uint32_t node) const { return node < n_mesh_; }
  std::uint32_t centre_node(std::uint32_t body) const { return n_mesh_ + 2 * body; }
  std::uint32_t turning_node(std::uint32_t body) const { return centre_node(body) + 1; }
  /// The body that has a node of its own. Precondition: it is none of the mesh.
  std::uint32_t owner(std::uint32_t node) const { return (node - n_mesh_) / 2; }
  const RigidBody& body(std::uint32_t i) const { return model_.rigid.bodies[i]; }
  /// Whether a node of the mesh moves with a body.
  bool moves(std::uint32_t node) const {
    return node < n_mesh_ && !model_.rigid.nodes.is_free(NodeIndex{node});
  }
  /// Precondition: moves(node).
  std::uint32_t body_of(std::uint32_t node) const { return *model_.rigid.nodes.body_of[node]; }
  /// L of a body [length].
  double length(std::uint32_t body) const { return lengths_[body]; }

  /// Whether conditions do not hold and prescribe all motions of all bodies all the time.
  bool are_free() const;

  /// Begins a step at the state.
  void begin_step();
  /// Brings back the bodies that the step began with.
  void restore() { state_.rigid = start_; }
  /// Adds the directions that conditions leave free to those of nodes.
  void add_free(std::vector<FreeDirections>& free) const;
  /// Sets what conditions move the bodies by. Throws SolveError when a condition has no finite value.
  void set_prescribed(double dt, Eigen::VectorXd& prescribed) const;
  /// Moves the bodies, and adds their motion to what their nodes have been moved by.
  ///   start  of the step [3 x n_mesh]
  void move(const Eigen::VectorXd& increment, double dt, const Eigen::Matrix3Xd& start);

  /// Takes forces off the nodes of bodies and adds them up where their bodies are now, or were at the start.
  void gather(Eigen::VectorXd& forces) const { gather(state_.rigid, turns_, forces); }
  void gather_at_start(Eigen::VectorXd& forces) const;
  /// Sets what outputs say of the bodies: the forces on them and what holds them.
  ///   free  as of add_free
  void note_forces(const std::vector<FreeDirections>& free);

  /// By what a node's displacement, or rotation, is moved.
  std::vector<Carrier> carriers(std::uint32_t node, bool turns) const;
  /// What the forces of now resist turning with, since arms turn: the negative derivative of J^T M,
  ///   sum of (f . r) I - (r f^T + f r^T) / 2, over L^2 [force/length].
  Eigen::Matrix3d turning_stiffness(std::uint32_t body) const;

 private:
  void gather(const std::vector<RigidBodyState>& bodies, const std::vector<Eigen::Matrix3d>& turns,
              Eigen::VectorXd& forces) const;

  const Model& model_;
  State& state_;
  std::uint32_t n_mesh_;
  std::vector<double> lengths_;         // [n_bodies] [length]
  std::vector<RigidBodyState> start_;   // of the step
  std::vector<Eigen::Matrix3d> turns_;  // [n_bodies] J / L, of now [1/length]
};

}  // namespace contactsim
