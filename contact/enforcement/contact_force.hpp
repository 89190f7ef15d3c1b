// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/enforcement/contact_checkpoint.hpp"
#include "contact/enforcement/contact_detection.hpp"
#include "contact/enforcement/contact_mobility.hpp"
#include "contact/enforcement/contact_setup.hpp"
#include "contact/enforcement/contact_stabilization.hpp"
#include "contact/enforcement/contact_step_limit.hpp"
#include "contact/enforcement/contact_trial.hpp"
#include "contact/enforcement/momentum_balance.hpp"
#include "contact/enforcement/offset_moments.hpp"
#include "contact/enforcement/pair_histories.hpp"
#include "contact/enforcement/preload_forces.hpp"
#include "contact/formulations/penetration_depths.hpp"
#include "core/elements/force_term.hpp"
#include "core/statics/static_contact.hpp"

namespace contactsim {

/// The forces of contact: search when something has moved far enough, contact points, penalties, friction
/// and ties. Each contact point pushes both sides alike. The same bits for any number of threads.
class ContactForce final : public ForceTerm, public StaticContact {
 public:
  /// All that the setup refers to must outlive this.
  explicit ContactForce(const ContactSetup& setup);
  ContactForce(const ContactForce&) = delete;
  ContactForce& operator=(const ContactForce&) = delete;

  /// Throws SolveError when a node is nowhere.
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override;
  /// The forces of the pairs that are enforced by momentum balance.
  std::optional<ForceReport> balance(const State& state, Eigen::Matrix3Xd& forces) override;
  /// Of the forces on lofts about the nodes of the mesh that they hang on.
  void set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) override;

  // Of load steps.
  void begin_trials(const Motion& motion) override;
  void try_forces(const Motion& motion, Eigen::Matrix3Xd& forces, Eigen::Matrix3Xd* moments) override;
  bool hold_slip_limits(bool does) override;
  void visit_springs(const std::function<void(const ContactSpring&)>& take) const override;
  MultiplierChange update_multipliers(double tolerance) override;
  bool is_stabilized() const override { return stabilization_.is_on(); }
  void stabilize(const StabilizationLevel& level) override { stabilization_.set_level(level); }
  Stabilization stabilization() const override;
  double stabilizing_force() const override { return stabilization_.force(); }
  double longest_motion() const override;
  void give_up_trials() override;
  ForceReport accept_trial(const Motion& motion, Eigen::Matrix3Xd& forces) override;
  const ContactMultipliers& multipliers() const { return multipliers_; }

  /// Whether contact of a procedure before has the same surfaces and pairs, so that take_over() can be
  /// called.
  bool is_like(const ContactForce& earlier) const;
  /// Takes over what contact of a procedure before remembers, of load steps in load steps and of explicit
  /// dynamics in explicit dynamics all of it: touch, friction, ties, multipliers, sums. Else what is tied or
  /// glued stays so. Behind load steps it does with its forces; pairs whose momentum is balanced begin
  /// with those of contact, and what it has pressed counts as just touching as it is. Others begin anew. To
  /// be called before the first forces. Precondition: is_like(earlier).
  ///   ended   motion at the end of the procedure before, where nothing moves any more (dt 0)
  ///   motion  of the start
  ///   until   explicit contact lets go by then what it does not press with by itself: PreloadForces [time]
  void take_over(ContactForce& earlier, const Motion& ended, const Motion& motion, double until);
  /// Of explicit contact after the first forces.
  const PreloadForces& preload_forces() const { return preload_forces_; }

  /// Goes over to the surfaces that the setup's contact has now, after deaths of elements. What contact
  /// remembers of faces and nodes that are still there stays: touch, slip, ties, sums. What held a side that
  /// is removed is over; the energy that it stored is lost.
  ///   motion           of the last step
  ///   eroded_nodes     ascending, that stay though their elements are dead
  ///   makes_new_edges  whether sharp edges that were none before become edges of contact
  void rebuild_surfaces(const Motion& motion, std::span<const ErodedNode> eroded_nodes,
                        bool makes_new_edges = true);
  /// What rebuild_surfaces() changes, as it is between two load steps.
  ///   motion  of the step before
  ContactCheckpoint checkpoint(const Motion& motion);
  /// Goes back to that, once the setup's contact has the surfaces of then again.
  ///   motion  that of then
  void restore(const Motion& motion, const ContactCheckpoint& checkpoint);

  const ContactMesh& contact_mesh() const { return contact_mesh_; }
  /// As of the motion seen last.
  const ContactKinematics& kinematics() const { return kinematics_; }
  const PairRules& rules() const { return rules_; }
  const ContactSearch& search() const { return detection_.search(); }
  IndexedSpan<PairIndex, const PairHistory> histories() const { return histories_.all(); }
  const RecoveryEnergy& recovery_energy() const { return recovery_energy_; }
  IndexedSpan<PairIndex, const PairStep> pair_steps() const { return assembler_.pairs(); }
  IndexedSpan<ContactNodeIndex, const NodeFriction> node_friction() const { return assembler_.friction(); }
  /// What a contact node has slipped as its surface lies in the motion seen last [length].
  Eigen::Vector3d node_slip(ContactNodeIndex node) const {
    return assembler_.slip_now(kinematics_, turns_, node);
  }
  /// The largest share of its stable step that the run has lost to contact so far [1].
  double lost_step_share() const { return step_limit_.lost_share(); }
  /// What balancing the last step came to.
  const BalanceReport& balance_report() const { return balance_report_; }
  /// In the springs of all pairs, of the last step and of the first one, in the mesh's own overlaps [energy].
  double stored() const;
  double stored_at_start() const { return stored_at_start_; }
  std::size_t n_candidates() const { return detection_.n_candidates(); }
  /// The memory of the contact mesh, its motion, search, candidates and sums now [bytes].
  std::size_t bytes() const {
    return contact_mesh_.bytes() + kinematics_.bytes() + detection_.bytes() +
           assembler_.nodes().size_bytes() + assembler_.friction().size_bytes() + bytes_of(points_);
  }

  /// The contact points of the last step, in their order, and the interface constraints, as their forces were
  /// added: what is written is what acted.
  std::span<const ContactPoint> points() const { return points_; }
  std::span<const ConstraintForces> constraint_forces() const { return constraint_forces_; }

  /// Saves or restores all that contact remembers between two steps.
  ///   motion  of the step before
  void archive(const Motion& motion, StateArchive& saved);
  std::span<const Tie> ties() const { return detection_.ties(); }
  /// Calls do_one(constraint) for all interface constraints: ties first, then bonds, then what decays.
  template <class Do>
  void visit_constraints(const Do& do_one) const {
    detection_.visit_constraints(do_one);
  }
  /// How far contact nodes are from what they meet: find_node_gaps().
  ///   motion  of now
  IndexedVector<ContactNodeIndex, double> node_gaps(const Motion& motion) const;
  /// Where a contact node is, of the motion seen last [length].
  Eigen::Vector3d position(ContactNodeIndex node) const { return kinematics_.x(node); }

 private:
  ContactMesh make_faces(std::span<const ErodedNode> eroded_nodes) const;
  SurfaceTurns make_turns() const;
  void begin(const Motion& motion);
  void update_candidates(const Motion& motion);
  void begin_step(const Motion& motion);
  void add_penalty_points(const ContactStepContext& context);
  void add_to_sums(const ContactPoint& point);
  void add_constraints(const ContactStepContext& context, std::span<const ContactPoint> to_glue);
  void write_forces(const ContactAssembler& assembler, OffsetMoments& moments, Eigen::Matrix3Xd& forces);
  void move_to_trial(const Motion& motion);
  ContactStepContext static_context(double dt, bool is_trial) const;
  void hold_slips();
  void begin_preload_forces(const ContactStepContext& context, double time);
  LoftSpins make_spins() const;
  StepSprings step_springs() const {
    return {kinematics_, rules_, points_, constraint_forces_, assembler_.pairs()};
  }
  void note_element_stiffness();
  void limit_stiffness(const ContactKinematics& start);
  /// Returns the work of overlaps that are ramped [energy].
  double end_step(double time, double dt);
  void remap(const ContactRemap& remap);
  void leave_surfaces(const ContactMesh& before, const Motion& motion);
  bool goes_on_as(const ContactForce& earlier) const;
  std::uint64_t surfaces_digest() const;
  void archive_faces(StateArchive& saved);

  ContactSetup setup_;
  ContactMesh contact_mesh_;
  ActiveTimes times_;  // of all contact
  PairRules rules_;
  ConstrainedPairs constrained_;
  SurfaceTurns turns_;  // only with friction
  ContactKinematics kinematics_;
  ContactMobility mobility_;
  std::vector<double> element_stiffness_;  // of faces, surface nodes, edges before any limit [force/length^3]
  PenetrationDepths depths_;
  ContactDetection detection_;
  ContactAssembler assembler_;
  OffsetMoments offset_moments_;
  MomentumBalance balance_;
  bool balances_ = false, has_penalty_ = false;  // some pair is enforced so
  bool balances_pulls_ = false;                  // one of the former has a law that pulls
  ContactLoss last_loss_;
  BalanceReport balance_report_;
  std::vector<ContactPoint> points_;                 // of the step
  std::vector<ConstraintForces> constraint_forces_;  // of the step
  PairHistories histories_;
  RecoveryEnergy recovery_energy_;
  ContactMultipliers multipliers_;       // of load steps
  HeldSlips held_slips_;                 // of the last load step
  WeightedGaps weighted_gaps_;           // of the last trial of a load step
  ContactStabilization stabilization_;   // of load steps
  std::unique_ptr<ContactTrial> trial_;  // null before the first load step
  PreloadForces preload_forces_;
  ContactStepLimit step_limit_;
  double stored_at_start_ = 0.0;
  bool has_begun_ = false;
  double start_step_ = 0.0;      // stable step of the elements at the start [time]
  std::vector<NodeIndex> left_;  // nodes of the mesh that have just left contact
};

}  // namespace contactsim
