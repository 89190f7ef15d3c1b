// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/pair_work.hpp"
#include "contact/formulations/interface_constraint.hpp"
#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/surface_turns.hpp"
#include "core/base/optional_index.hpp"
#include "core/elements/node_vector.hpp"

namespace contactsim {

class StateArchive;

/// What a pair of surfaces does in a step.
struct PairStep {
  Eigen::Vector3d force =
      Eigen::Vector3d::Zero();  ///< on the pair's first surface; of self contact on the first sides [force]
  double area = 0.0;            ///< that touches [length^2]
  double stored = 0.0;          ///< in the springs of the penalty and of friction now [energy]
  double dissipated = 0.0;      ///< by friction in the step [energy]
  double damped = 0.0;          ///< by contact damping in the step [energy]
  double impact = 0.0;          ///< lost in the step where sides met without rebound [energy]
  double ramp_energy = 0.0;  ///< work of the ramps of overlaps, if they came in whole at this force [energy]
  double penetration = 0.0;  ///< deepest of what touches [length]
  double penetration_share = 0.0;  ///< the same over the thickness of the thinner side [1]
  bool touches = false;
  bool is_near = false;  ///< some contact point touches or is about to
};

/// What friction has done at a contact node since the start.
struct NodeFriction {
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();  ///< along the other side, added up as vectors that turn
                                                   ///< with the surface, as it lay at the start [length]
  double slip_length = 0.0;                        ///< the same added up by length [length]
  double energy = 0.0;                             ///< the node's share of what was lost [energy]
  Eigen::Vector3d last_slip = Eigen::Vector3d::Zero();  ///< of the last step [length]
};

/// Adds contact points up at nodes and pairs. They come in one order, whatever the number of threads,
/// so that the sums have the same bits.
class ContactAssembler {
 public:
  ///   has_moments  some contact points stand off their nodes
  ContactAssembler(std::size_t n_nodes, std::size_t n_pairs, bool has_friction, bool has_moments = false);

  /// Goes over to other nodes. What friction did at nodes that are gone is forgotten.
  void remap(const ContactRemap& remap);
  void begin_step();
  /// From now on the work of the forces is counted, too.
  ///   kinematics  must outlive the step
  ///   dt          of the step [time]
  void begin_work(const ContactKinematics& kinematics, double dt) {
    kinematics_ = &kinematics;
    work_.begin_step(kinematics, dt);
  }
  void add(const ContactPoint& point);
  /// Adds the forces of a point at nodes, and to no pair.
  void add_forces(const ContactPoint& point);
  /// Adds a force and a moment about it at a node, and to no pair.
  void add_node(ContactNodeIndex node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);
  /// Takes note that the overlap at a contact point of the step comes in by a ramp.
  ///   depth  of all of it [length]
  void note_ramp(const ContactPoint& point, double depth) {
    pairs_[point.pair].ramp_energy += point.force * depth;
  }
  /// Notes how deep a contact point that touches is.
  ///   thickness  of the thinner side [length]
  void note_penetration(const ContactPoint& point, double thickness);
  void add(const InterfaceConstraint& constraint, const CornerForces& forces);
  /// Ends a step: slips of the nodes are added up.
  ///   turns  of the surfaces since the start, which the slips follow
  void end_step(const SurfaceTurns& turns = {});

  /// [n_contact_nodes] x y z of the force [force], and the stiffness that moves with the node [force/length]
  IndexedSpan<ContactNodeIndex, const NodeVector> nodes() const { return nodes_; }
  /// [n_contact_nodes] of the forces about the nodes, empty without moments [force length]
  IndexedSpan<ContactNodeIndex, const Eigen::Vector3d> moments() const { return moments_; }
  IndexedSpan<PairIndex, const PairStep> pairs() const { return pairs_; }
  /// [n_contact_nodes], empty without friction
  IndexedSpan<ContactNodeIndex, const NodeFriction> friction() const { return friction_; }
  /// The slip of a node as its surface lies now [length].
  Eigen::Vector3d slip_now(const ContactKinematics& now, const SurfaceTurns& turns,
                           ContactNodeIndex node) const;
  /// The work that forces have taken from the bodies since the start [energy]
  IndexedSpan<PairIndex, const double> taken() const { return work_.taken(); }
  const PairWork& work() const { return work_; }
  double dissipated() const { return dissipated_; }
  double damped() const { return damped_; }

  /// Saves or restores what has been added up since the start.
  void archive(StateArchive& saved);

 private:
  void add_moment(const ContactPointSide& side, const Eigen::Vector3d& arm, const Eigen::Vector3d& force);
  void follow_partner(ContactNodeIndex node, const SurfaceTurns& turns);
  void add_slip(const ContactPointSide& side, const ContactPointSide& other, const Eigen::Vector3d& slip,
                const ContactPoint& point);

  bool has_friction_, has_moments_;
  IndexedVector<ContactNodeIndex, NodeVector> nodes_;
  IndexedVector<ContactNodeIndex, Eigen::Vector3d> moments_;
  IndexedVector<PairIndex, PairStep> pairs_;
  IndexedVector<ContactNodeIndex, NodeFriction> friction_;
  IndexedVector<ContactNodeIndex, NodeVector> slips_;  // of the step, times area, and area
  IndexedVector<ContactNodeIndex, OptionalIndex<ContactNodeIndex>>
      met_;  // of the step: a node of the other side that a node met
  IndexedVector<ContactNodeIndex, OptionalIndex<ContactNodeIndex>>
      partners_;  // the last of them, whose surface turns slips of nodes without faces
  double dissipated_ = 0.0, damped_ = 0.0;
  const ContactKinematics* kinematics_ = nullptr;  // null where work is not counted
  PairWork work_;
};

}  // namespace contactsim
