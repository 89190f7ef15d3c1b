// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/enforcement/contact_mobility.hpp"
#include "contact/enforcement/interface_constraints.hpp"
#include "contact/enforcement/momentum_balance.hpp"
#include "contact/enforcement/pair_history.hpp"
#include "contact/formulations/edge_contacts.hpp"
#include "contact/formulations/face_face_contacts.hpp"
#include "contact/formulations/node_areas.hpp"
#include "contact/formulations/node_face_contacts.hpp"
#include "contact/formulations/penetration_depths.hpp"
#include "contact/formulations/plane_contacts.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/search/contact_search.hpp"
#include "core/definition/contact.hpp"
#include "core/force_term.hpp"
#include "core/model.hpp"

namespace contactsim {

/// What contact is made of in a run.
struct ContactSetup {
  const ContactDefinition& definition;
  const ContactModel& contact;
  const Model& model;
  std::span<const TimeSteppingBlock> time_stepping_blocks;  ///< the periods of the procedure
  std::span<const FunctionDefinition> functions = {};       ///< that friction models name
};

/// How much contact lowers the stable step.
struct ContactStep {
  double share = 0.0;  ///< of its stable step that the run loses, largest so far [1]
};

/// The forces of contact: search when something has moved far enough, contact points, penalties, friction
/// and ties. Each contact point pushes both sides alike. The same bits for any number of threads.
class ContactForce final : public ForceTerm {
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

  /// Goes over to the surfaces that the setup's contact has now, after deaths of elements. What contact
  /// remembers of faces and nodes that are still there stays: touch, slip, ties, sums. What held a side that
  /// is gone is over; the energy that it stored is lost.
  ///   motion           of the last step
  ///   eroded_nodes       ascending, that stay though their elements are dead
  ///   makes_new_edges  whether sharp edges that were none before become edges of contact
  void rebuild_surfaces(const Motion& motion, std::span<const ErodedNode> eroded_nodes,
                        bool makes_new_edges = true);

  const ContactMesh& contact_mesh() const { return contact_mesh_; }
  const PairRules& rules() const { return rules_; }
  const ContactSearch& search() const { return search_; }
  std::span<const PairHistory> histories() const { return histories_; }
  std::span<const PairStep> pair_steps() const { return assembler_.pairs(); }
  std::span<const NodeFriction> node_friction() const { return assembler_.friction(); }
  const ContactStep& step_share() const { return step_share_; }
  /// What balancing the last step came to.
  const BalanceReport& balance_report() const { return balance_report_; }
  /// In the springs of all pairs, of the last step and of the first one, in the mesh's own overlaps [energy].
  double stored() const;
  double stored_at_start() const { return stored_at_start_; }
  std::size_t n_candidates() const {
    return face_face_.candidates().partners.size() + node_face_.candidates().partners.size() +
           edges_.candidates().partners.size() + planes_.n_rows();
  }

  /// The contact points of the last step, in their order, and the interface constraints, as their forces were
  /// added: what is written is what acted.
  std::span<const ContactPoint> points() const { return points_; }
  std::span<const ConstraintForces> constraint_forces() const { return interface_constraints_.forces(); }

  /// Saves or restores all that contact remembers between two steps.
  ///   motion  of the step before
  void archive(const Motion& motion, StateArchive& saved);
  std::span<const Tie> ties() const { return interface_constraints_.ties(); }
  /// All interface constraints, in the order of their forces.
  const InterfaceConstraints& interface_constraints() const { return interface_constraints_; }
  /// Where a contact node is, of the motion seen last [length].
  Eigen::Vector3d position(std::uint32_t node) const { return kinematics_.x(node); }

 private:
  ContactMesh make_faces(std::span<const ErodedNode> eroded_nodes) const;
  void begin(const Motion& motion);
  void archive_faces(StateArchive& saved);
  void remap(const ContactRemap& remap);
  void forget_stored();
  void add_to_sums(const ContactPoint& contact_point);
  std::span<const double> available_energy();
  void find_candidates(const Motion& motion);
  std::vector<std::uint32_t> faces_with_candidates() const;
  template <class Contacts, class Take>
  void visit_contact_points(Contacts& contacts, const ContactStepContext& context, const Take& take);
  template <class Take>
  std::vector<ContactPoint> visit_points(const ContactStepContext& context, const Take& take);
  bool glues(const ContactPoint& contact_point) const;
  NearCandidates near_candidates() const;
  /// The contact points of nodes with faces.
  std::span<const ContactPoint> find_node_points(const ContactStepContext& context);
  void add_places(const ContactStepContext& context);
  void write_forces(Eigen::Matrix3Xd& forces);
  template <class Visit>
  void visit_moments(const Visit& visit) const;
  void spread_moments(Eigen::Matrix3Xd& forces);
  LoftSpins make_spins() const;
  double largest_eigenvalue();
  void limit_stiffness(const ContactKinematics& start);
  void end_step(double time, double dt);
  void note_histories(double dt);
  void foresee(const State& state);
  double thinner_side(const ContactPoint& contact_point) const;
  void note_lost(double time);

  ContactSetup setup_;
  ContactMesh contact_mesh_;
  ActiveTimes times_;  // of all contact
  PairRules rules_;
  ConstrainedPairs constrained_;
  ContactKinematics kinematics_;
  ContactMobility mobility_;
  std::vector<double> element_stiffness_;  // of faces, surface nodes, edges before any limit [force/length^3]
  std::vector<std::uint8_t> slips_;        // [n_pairs] has springs along the surface
  PenetrationDepths depths_;
  ContactSearch search_;
  FaceFaceContacts face_face_;
  NodeFaceContacts node_face_;
  EdgeContacts edges_;
  PlaneContacts planes_;
  InterfaceConstraints interface_constraints_;
  ContactAssembler assembler_;
  MomentumBalance balance_;
  bool balances_ = false, has_penalty_ = false;  // some pair is enforced so
  Eigen::Matrix3Xd free_velocity_,
      free_turning_;  // of contact nodes in the coming step, without these forces
  ContactLoss last_loss_;
  BalanceReport balance_report_;
  std::vector<std::vector<ContactPoint>> chunks_;  // scratch of each thread
  std::vector<ContactPoint> points_;               // of the step
  std::vector<Eigen::Vector3d> spin_moments_;      // scratch, about nodes of lofted shells [force length]
  NodeAreas node_areas_;
  std::vector<ContactPoint> node_points_;  // scratch
  std::vector<PairHistory> histories_;
  std::vector<double> available_;      // scratch, [n_pairs] [energy]
  std::vector<double> least_energy_;   // [n_pairs] that each had so far, <= 0 [energy]
  std::vector<double> stored_;         // [n_pairs] of the last step [energy]
  std::vector<double> surface_rates_;  // scratch, [n_surfaces]
  ContactStep step_share_;
  double stored_at_start_ = 0.0;
  bool has_begun_ = false;
  double start_step_ = 0.0;          // stable step of the elements at the start [time]
  bool has_new_surfaces_ = false;    // a search has to follow
  std::vector<std::uint32_t> left_;  // nodes of the mesh that have just left contact
};

}  // namespace contactsim
