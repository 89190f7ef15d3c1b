// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/formulations/close_candidates.hpp"
#include "contact/formulations/contact_formulation.hpp"
#include "contact/formulations/face_face/face_face_history.hpp"
#include "contact/formulations/face_face/face_pair_bounds.hpp"
#include "contact/formulations/face_face/meeting_faces.hpp"
#include "contact/formulations/face_face/weighted_gaps.hpp"
#include "contact/formulations/start_partners.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// The pairs of faces that may touch: FACE_FACE. A pair that touches stays in contact however deep it gets,
/// until the faces part or no longer overlap. A pair that starts to touch takes over the mean slip of its
/// first face, else of its second, so that friction is not lost when a face slides from one partner to the
/// next. Of pairs that slide infinitesimally one face is carried along with the other, in its own plane. A
/// PointFormulation.
class FaceFaceContacts {
 public:
  explicit FaceFaceContacts(const FormulationSetup& setup);

  void find_candidates(ContactSearch& search, const ContactKinematics& kinematics, const Motion& motion);
  /// Goes over to candidates, with what is remembered of pairs that were candidates before.
  ///   candidates  rows of first faces with their second ones, greater than the first
  void take_candidates(FacePairLists candidates);
  std::size_t n_rows() const { return candidates_.n_rows(); }
  std::size_t n_candidates() const { return candidates_.partners.size(); }
  const FacePairLists& candidates() const { return candidates_; }
  /// Those that renew_close has found, or all where faces are carried along.
  std::size_t n_close() const { return start_partners_.empty() ? close_.size() : n_candidates(); }
  void forget_close() { close_.forget(); }
  std::size_t bytes() const {
    return candidates_.bytes() + history_.bytes() + bounds_.bytes() + close_.bytes();
  }
  void watch(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const;
  void watch_close(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const;

  void begin_step() { history_.begin_step(candidates_, contact_mesh_.faces.size()); }
  void undo_begin_step() { history_.undo_begin_step(); }
  void begin_detection(const ContactStepContext& context);
  void detect(const ContactStepContext& context, CandidateRows rows, std::vector<ContactPoint>& points) const;
  void update(const ContactStepContext& context, CandidateRows rows, std::span<const ContactPoint> points) {
    if (rows.begin < rows.end) history_.update(context, candidates_, points);
  }
  void find_lost(const PairRules& rules, std::vector<LostContact>& lost) const {
    history_.find_lost(contact_mesh_, rules, lost);
  }
  /// Appends the overlaps by whose weighted gaps detect() presses faces in load steps.
  void weigh(const ContactStepContext& context, CandidateRows rows,
             std::vector<WeightedOverlap>& overlaps) const;
  /// Of all weighted gaps that press, by their numbers; that normals and areas change is left out.
  std::vector<WeightedGapMotion> node_motions(const ContactStepContext& context) const;
  /// How deep each face was in the last step [n_faces], 0 where it did not touch; nothing before the first
  /// [length].
  std::span<const float> depths() const { return history_.depths(); }
  /// Marks the faces of HYBRID pairs that are close to the other side.
  void mark_close(const ContactStepContext& context, double size_share, PairRules& rules) const;
  /// Appends the gaps before the first step of faces of pairs that have to know them.
  void add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const;

  void remap(const ContactRemap& remap);
  /// Those that the last remap() has released from their partners of the start.
  std::span<const ReleasedPartner<FaceIndex>> released() const { return released_; }
  void archive(StateArchive& saved);

 private:
  struct Candidate {
    FaceIndex first, second;
    PairIndex pair;
    std::size_t position;  ///< in candidates_
    const PairRule& rule;
    PartnerCarry carry = {};
  };
  /// Whether bounds say beforehand which candidates have nothing to do with each other. No more often than
  /// detect_one() and add_pull().
  bool culls(const ContactStepContext& context) const {
    return !context.is_static && start_partners_.empty() && n_candidates() > 0;
  }
  Candidate make_candidate(const ContactStepContext& context, FaceIndex first, std::size_t position) const;
  /// Taken off the gap of the mesh [length].
  static double offset_of(const ContactStepContext& context, const Candidate& candidate);
  MeetingFaces make_meeting_faces(const ContactStepContext& context, const Candidate& candidate) const;
  /// Two faces that may touch, before their overlap is known.
  struct Meeting {
    Candidate candidate;
    MeetingFaces faces;
    PairPenalty penalty;
    ConstraintActivation activation;  ///< of the elastic penalty what is near and what is flat
  };
  /// Those of flat faces, in the order of candidates: the overlaps of eight of them are found together.
  struct Meetings {
    std::vector<Meeting> all;
    // Scratch.
    std::vector<PushedFaces> pushed;
    std::vector<PushedContact> contacts;
    std::vector<ConstrainedFaces> constrained;
  };
  ///   closed  by which their gap has shrunk in the step [length]
  PairPenalty make_penalty(const Candidate& candidate, bool did_touch, double closed) const;
  /// Adds the meeting of two faces, or the contact points of those whose overlap is found alone.
  void detect_one(const ContactStepContext& context, const Candidate& candidate, Meetings& meetings,
                  std::vector<ContactPoint>& points) const;
  /// Adds the contact points of all meetings, which are over then.
  void end_meetings(const ContactStepContext& context, Meetings& meetings,
                    std::vector<ContactPoint>& points) const;
  /// Whether weighted gaps press a pair of faces, and not the gap of each of its points.
  bool is_weighted(const ContactStepContext& context, const Candidate& candidate) const;
  void weigh_one(const ContactStepContext& context, const Candidate& candidate,
                 std::vector<WeightedOverlap>& overlaps) const;
  void find_slips(const ContactStepContext& context, const Candidate& candidate, const MeetingFaces& faces,
                  WeightedOverlap& overlap) const;
  void add_weighted_points(const ContactStepContext& context, const Candidate& candidate,
                           std::vector<ContactPoint>& points) const;
  /// The contact points of round faces, and of the elastic penalty's springs that hold.
  void add_points_alone(const ContactStepContext& context, const Meeting& meeting,
                        std::vector<ContactPoint>& points) const;
  void add_penalty_points(const ContactStepContext& context, Meetings& meetings,
                          std::vector<ContactPoint>& points) const;
  void add_penalty_point(const ContactStepContext& context, const Meeting& meeting,
                         const FaceFaceContact& contact, std::vector<ContactPoint>& points) const;
  /// The same where what has touched may not part, each by the mean gap of its part of the overlap.
  void add_spring_points(const ContactStepContext& context, const Meeting& meeting,
                         std::vector<ContactPoint>& points) const;
  void add_balanced_points(const ContactStepContext& context, Meetings& meetings,
                           std::vector<ContactPoint>& points) const;
  void add_balanced_points(const ContactStepContext& context, const Meeting& meeting,
                           const FaceFaceConstraints& found, std::vector<ContactPoint>& points) const;
  /// Adds what a law does across the gap, or beside the penalty.
  void add_pull(const ContactStepContext& context, const Candidate& candidate,
                std::vector<ContactPoint>& points) const;
  ContactPoint make_contact_point(const Candidate& candidate, const FaceFaceContact& contact) const;
  bool may_meet(const ContactStepContext& context, const Candidate& candidate, double reach) const;
  /// Thickness of the thinner element behind the faces [length].
  double thinner(const Candidate& candidate) const;
  /// Whether faces that overlap got there through their fronts: they were in front of each other, or hardly
  /// behind, one step ago, or one of them has touched something already. The sides of two bodies that
  /// lie on each other at an edge overlap too, by a sliver that is far deeper than wide, and do not touch.
  ///   closed  by which the gap has shrunk in the step [length]
  bool met_in_front(const ContactStepContext& context, const Candidate& candidate,
                    const FaceFaceContact& contact, double closed) const;
  /// Adds the friction of a penalty's contact point.
  ///   apart  velocity of the first side against the second [length/time]
  void add_friction_to(const ContactStepContext& context, const Meeting& meeting,
                       const Eigen::Vector3d& apart, ContactPoint& point) const;

  const ContactMesh& contact_mesh_;
  const PairRules& rules_;
  FacePairLists candidates_;
  StartPartners<FaceIndex> start_partners_;
  std::vector<ReleasedPartner<FaceIndex>> released_;
  FaceFaceHistory history_;
  CloseCandidates<FaceIndex, FaceIndex> close_;
  FacePairBounds bounds_;  // of the step
  double widest_reach_;    // of all pairs, but for what closes and what is taken off gaps [length]
};

}  // namespace contactsim
