// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/close_window.hpp"
#include "contact/enforcement/contact_setup.hpp"
#include "contact/enforcement/narrow_phase.hpp"
#include "contact/formulations/contact_formulations.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

/// Contact detection: the broad phase finds candidates when something has moved far enough, the narrow phase
/// of each formulation finds contact points and forces of constraints in every step. The same points in the
/// same order for any number of threads.
class ContactDetection {
 public:
  /// All must outlive this.
  ContactDetection(const ContactSetup& setup, const ContactMesh& contact_mesh, const PairRules& rules);

  /// Whether the candidates may no longer be all.
  bool is_due(const ContactKinematics& kinematics) { return has_new_surfaces_ || search_.is_due(kinematics); }
  /// The broad phase. Bounds of faces without candidates are not kept up to date until the next one.
  void find_candidates(const Motion& motion, ContactKinematics& kinematics);
  /// Faces of which something has to be known until the next search.
  std::vector<FaceIndex> faces_with_candidates() const;

  /// Begins a step: what is known of the last one is kept, and gathered anew.
  void begin_step();
  /// What is known of the last step may change with candidates again. Precondition: none was remembered
  /// since.
  void undo_begin_step();
  /// Has bounds of faces follow for the narrow phase of a context, and says which candidates it looks at.
  void begin_narrow_phase(ContactStepContext& context, ContactKinematics& kinematics);
  /// The narrow phase: takes all contact points of the pairs that the context enforces, in their order.
  /// Returns those that touch under a GLUED MODEL.
  template <class Take>
  std::vector<ContactPoint> visit_points(const ContactStepContext& context, const Take& take);
  /// Finds the weighted gaps of faces in a load step, which visit_points() presses by then.
  void weigh_gaps(const ContactStepContext& context, WeightedGaps& gaps) const;
  /// FaceFaceContacts::node_motions().
  std::vector<WeightedGapMotion> node_motions(const ContactStepContext& context) const {
    return formulations_.get<FaceFaceContacts>().node_motions(context);
  }
  /// Appends the contacts that ended in the last step though they were deep.
  void find_lost(std::vector<LostContact>& lost) const;

  /// Marks what of HYBRID pairs is close to the other side.
  void mark_close(const ContactStepContext& context, PairRules& rules) const;
  /// The gaps of pairs that have to know them, before the first step.
  FoundStartGaps find_start_gaps(const ContactStepContext& context) const;
  /// Takes notice of other reaches of the pairs. A search has to follow.
  void renew_reaches() { search_.renew_reaches(); }
  /// The broad phase as find_candidates(), which reaches for what may be held at the start or from now on.
  void find_start_candidates(const Motion& motion, ContactKinematics& kinematics);
  /// Ends that, with a search where it makes a difference.
  void end_start(const Motion& motion, ContactKinematics& kinematics);
  /// A state that is restored has begun.
  void resume() { search_.reach_for_start(false); }
  std::size_t n_candidates() const;

  /// TiedContacts::begin_with().
  void begin_with_ties(std::span<const Tie> ties);
  /// Has ties and bonds hold what is near: of all pairs, or of those whose model has just changed, which lose
  /// what they had.
  void find_constraints(const ContactStepContext& context, bool only_changed, ConstrainedPairs& constrained);
  /// Appends the forces of constraints in a step: of what decays, then of what the context enforces.
  void detect_constraints(const ContactStepContext& context, ConstrainedPairs& constrained,
                          std::vector<ConstraintForces>& found);
  /// Holds what has touched under a GLUED MODEL, from the next step on.
  void glue(const ContactStepContext& context, std::span<const ContactPoint> points,
            ConstrainedPairs& constrained);
  /// Calls take(tie) for those whose forces momentum balance has to find, before detect_constraints().
  template <class Take>
  void visit_balanced(const ContactStepContext& context, const Take& take);
  /// Calls do_one(constraint) for all: ties first, then bonds, then what decays.
  template <class Do>
  void visit_constraints(const Do& do_one) const;
  std::span<const Tie> ties() const { return formulations_.get<TiedContacts>().constraints(); }

  const ContactSearch& search() const { return search_; }
  /// The memory of search, candidates and what is known of them [bytes].
  std::size_t bytes() const {
    return search_.bytes() + formulations_.get<FaceFaceContacts>().bytes() +
           formulations_.get<NodeFaceContacts>().bytes();
  }

  /// Goes over to other faces and nodes, which stand where those of the constructor stood already. A search
  /// has to follow.
  void remap(const ContactRemap& remap);
  /// The faces and surface nodes that the last remap() has released from their partners of the start.
  std::span<const ReleasedPartner<FaceIndex>> released_faces() const {
    return formulations_.get<FaceFaceContacts>().released();
  }
  std::span<const ReleasedPartner<SurfaceNodeIndex>> released_nodes() const {
    return formulations_.get<NodeFaceContacts>().released();
  }
  void archive(StateArchive& saved);

 private:
  template <class Mark>
  std::vector<FaceIndex> faces_that(const Mark& mark) const;
  void take_close(ContactKinematics& kinematics);
  void forget_close() {
    close_window_.forget();
    has_new_close_ = false;
  }

  ContactSetup setup_;
  const ContactMesh& contact_mesh_;
  const PairRules& rules_;
  ContactSearch search_;
  ContactFormulations formulations_;
  std::vector<NarrowPhase> narrow_phases_;  // of each that finds contact points
  DecayingConstraints decaying_;
  CloseWindow close_window_;
  bool has_new_close_ = false;     // since the last narrow phase
  bool has_new_surfaces_ = false;  // a search has to follow
};

template <class Take>
std::vector<ContactPoint> ContactDetection::visit_points(const ContactStepContext& context,
                                                         const Take& take) {
  std::vector<ContactPoint> to_glue;
  const auto take_one = [&](const ContactPoint& point) {
    take(point);
    const bool may_glue = point.is_met() && !point.is_of_edges;
    if (may_glue && rules_.of(point).law == ContactLaw::glued) to_glue.push_back(point);
  };
  auto narrow_phase = narrow_phases_.begin();
  for_each_of_points(formulations_, [&](auto& formulation) {
    narrow_phase++->visit_points(formulation, context, take_one);
  });
  return to_glue;
}

template <class Take>
void ContactDetection::visit_balanced(const ContactStepContext& context, const Take& take) {
  for_each_of_constraints(formulations_, [&](auto& formulation) {
    if constexpr (requires { formulation.visit_balanced(context, take); })
      formulation.visit_balanced(context, take);
  });
}

template <class Do>
void ContactDetection::visit_constraints(const Do& do_one) const {
  for_each_of_constraints(formulations_, [&](const auto& formulation) {
    for (const InterfaceConstraint& constraint : formulation.constraints()) do_one(constraint);
  });
  for (const InterfaceConstraint& constraint : decaying_.constraints()) do_one(constraint);
}

}  // namespace contactsim
