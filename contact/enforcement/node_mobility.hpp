// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/enforcement/constraint_pass.hpp"
#include "contact/enforcement/light_carriers.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/free_directions.hpp"
#include "core/base/optional_index.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/elements/node_vector.hpp"

namespace contactsim {

/// A share of a contact point that one carrier has: a node of the mesh or a rigid body.
struct CarrierTerm {
  std::uint32_t carrier = 0;                      ///< among those of the step
  double weight = 0.0;                            ///< signed: < 0 on the second side [1]
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  ///< from the carrier to the point [length]
};

/// How the carriers of contact points answer to forces over the coming step: by lumped mass and rotary
/// inertia, along the directions that conditions leave free; rigid bodies by their six degrees of freedom.
/// About nodes of lofted shells the mid surface turns, and moments go to the nodes around. A carrier that is
/// held or driven does not answer at all. Carriers are numbered as contact points of the step
/// name them, so that a pass over the points works on what they need alone. Source: v(t + dt/2) = v* +
/// (dt_before + dt_after) / 2 M^-1 f, as the integrator moves them.
class NodeMobility {
 public:
  /// Begins a step without carriers.
  ///   state  between two steps, the size of the next one is known
  ///   free   where conditions leave nodes and bodies free
  void begin(const Model& model, const ModelFreeDirections& free, const ContactKinematics& kinematics,
             const State& state);
  /// To be called when the contact nodes or the conditions are others.
  void forget() { inverse_mass_.clear(); }

  /// Appends the terms of a contact node, those of one rigid body as one.
  ///   beside  from the contact node to the point [length]
  void add_terms(ContactNodeIndex node, double weight, const Eigen::Vector3d& beside,
                 std::vector<CarrierTerm>& terms);

  /// The carrier of a contact node that is a plain one, for which the node alone counts and no arm.
  std::optional<std::uint32_t> plain_carrier(ContactNodeIndex node);

  std::size_t n_carriers() const { return carriers_.size(); }
  /// How a carrier that is a node moved in the step before; the fourth number is 0 [length/time].
  NodeVector last_velocity(std::uint32_t carrier) const;
  /// The nodes of the mesh among the carriers.
  const std::vector<std::uint32_t>& mesh_nodes() const { return mesh_nodes_; }
  /// The largest change of velocity per force [time/mass].
  double translation_bound(std::uint32_t carrier) const { return carriers_[carrier].mobility; }
  bool has_bodies() const { return !state_->rigid.empty(); }
  /// Whether a carrier is a rigid body.
  bool is_body(std::uint32_t carrier) const {
    return carriers_[carrier].body >= kinematics_->contact_mesh().n_nodes();
  }
  /// How a carrier answers over the coming step.
  CarrierMobility mobility(std::uint32_t carrier) const;
  /// The square root of the change of angular velocity about a direction per moment, times its length.
  double turn_root(std::uint32_t carrier, const Eigen::Vector3d& turn) const;
  /// The same for all directions and unit length.
  double turn_bound(std::uint32_t carrier) const { return carriers_[carrier].turn_bound; }

  /// Of carriers that turn with the mid surface around them, whose turn sizes are lengths: gives the areas by
  /// rotation to the nodes around, and has them answer by how these move.
  void spread_areas(LeaningAreas& areas) const;

  /// Forces that were pushed before stay in all passes.
  void begin_passes();
  /// What has been pushed since the last pass, with what stays, is what change() and turning() answer with.
  void end_pass();
  /// The changes of velocity in the last pass [length/time], the fourth number is 0, and of angular velocity
  /// [1/time].
  const NodeVector& change(std::uint32_t carrier) const { return now_.changes[carrier]; }
  std::span<const NodeVector> changes() const { return now_.changes; }
  Eigen::Vector3d turning(std::uint32_t carrier) const { return now_.turnings[carrier].head<3>(); }
  /// Pushes a carrier over the coming step.
  ///   force, moment  [force] [force length]; the fourth number of a force is 0
  void push(std::uint32_t carrier, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);
  void push_plain(std::uint32_t carrier, const NodeVector& force) {
    next_.changes[carrier] += carriers_[carrier].mobility * force;
  }
  /// The change of velocity by what has pushed in the pass that runs [length/time].
  NodeVector& pushed(std::uint32_t carrier) { return next_.changes[carrier]; }
  /// The forces that plain carriers are pushed by besides in the pass that runs [n_carriers] [force].
  std::span<NodeVector> pressed() { return pressed_; }

 private:
  /// A body that turns, or that conditions hold along some directions.
  struct General {
    Eigen::Matrix3d translation = Eigen::Matrix3d::Zero();  // velocity per impulse [1/mass]
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();     // angular velocity per angular impulse
    double translation_bound = 0.0, rotation_bound = 0.0;   // their largest eigenvalues
  };
  /// A carrier of the step.
  struct Carrier {
    std::uint32_t body = 0;  // contact node, the first one with each node of the mesh, or rigid body
    OptionalIndex<std::uint32_t> general;  // position in generals_; none of a plain one
    double mobility = 0.0;    // the largest change of velocity per force, of a plain one any [time/mass]
    double turn_bound = 0.0;  // see turn_bound()
    OptionalIndex<std::uint32_t> ring;  // in rings_, of one that turns with the mid surface around it
  };
  /// A node of a lofted shell and the carriers around it.
  struct Ring {
    std::uint32_t carrier = 0, spin = 0, first = 0;  // position in LoftSpins, in ring_carriers_
  };
  /// Changes of velocities [n_carriers]. Fourth numbers are 0.
  struct Changes {
    std::vector<NodeVector> changes;   // [length/time]
    std::vector<NodeVector> turnings;  // [1/time]; of rings, while forces are pushed, moments [force length]
  };

  void set_nodes(const Model& model, const ModelFreeDirections& directions);
  void set_bodies(const Model& model, const ModelFreeDirections& directions);
  void turn_bodies(const Model& model, const ModelFreeDirections& directions, const State& state);
  General& make_general(std::uint32_t body);
  std::uint32_t use(std::uint32_t body);
  std::uint32_t use_node(ContactNodeIndex node);
  void use_ring(std::uint32_t carrier, NodeIndex mesh_node);
  void turn_rings(Changes& of) const;
  Eigen::Vector3d moved_by(std::uint32_t carrier, const Eigen::Vector3d& force) const;

  const ContactKinematics* kinematics_ = nullptr;
  const RigidNodes* rigid_ = nullptr;
  const State* state_ = nullptr;
  // Bodies: contact nodes, then rigid bodies.
  std::vector<OptionalIndex<std::uint32_t>> general_;  // [n_bodies] position in generals_
  std::vector<double> inverse_mass_;                   // [n_bodies] of plain ones, 0 of held ones [1/mass]
  std::vector<OptionalIndex<std::uint32_t>> carrier_;  // [n_bodies] among those of the step
  IndexedVector<ContactNodeIndex, OptionalIndex<std::uint32_t>> plain_;  // body of those that are plain
  std::vector<OptionalIndex<ContactNodeIndex>> contact_node_;  // [n_nodes of the mesh] first; of rings alone
  std::vector<General> generals_;
  std::vector<std::uint32_t> mesh_nodes_;  // of the step
  std::vector<Carrier> carriers_;          // of the step
  std::vector<Ring> rings_;                // of the step
  std::vector<std::uint32_t> ring_carriers_;
  Changes first_, now_, next_;       // before any pass, of the last one, of the one that runs
  std::vector<NodeVector> pressed_;  // [n_carriers] in the pass that runs [force]
  bool turns_ = false;               // some carrier of the passes does
  double half_steps_ = 0.0;          // a force acts for [time]
};

}  // namespace contactsim
