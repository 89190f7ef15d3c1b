// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// The pairs of faces that may touch, and what contact remembers of each: whether it touched, and the slip
/// that its tangential spring holds. A pair that touches goes on however deep it gets, until the faces part
/// or no longer overlap. A pair that starts to touch takes over the mean slip of its first face, else of its
/// second, so that friction is not lost when a face slides from one partner to the next.
class FaceFaceContacts {
 public:
  /// The faces must outlive this.
  FaceFaceContacts(const ContactMesh& contact_mesh, bool has_friction)
      : contact_mesh_(contact_mesh), has_friction_(has_friction) {}

  /// Room for the next candidates: rows of first faces with their second ones, greater than the first.
  /// take_candidates() follows.
  PairLists& next_candidates() { return next_; }
  /// Goes over to the next candidates, with what is remembered of pairs that are in both.
  void take_candidates();

  /// Goes over to other faces, which stand where those of the constructor stood already.
  void remap(const ContactRemap& remap);

  std::size_t n_rows() const { return candidates_.n_rows(); }
  const PairLists& candidates() const { return candidates_; }

  /// Appends the contact points of rows [begin, end). Rows may be shared among threads.
  void find(const ContactStepContext& context, std::size_t begin, std::size_t end,
            std::vector<ContactPoint>& contact_points);

  /// Begins a step: what is known of faces is gathered anew.
  void begin_step();
  /// Adds a contact point to what is known of its faces. Contact points come in order.
  void note(const ContactPoint& contact_point);

  /// How deep each face was in the last step [n_faces], 0 where it did not touch; nothing before the first.
  std::span<const float> depths() const { return depth_now_; }
  /// Appends the contacts of the step before the last one that ended though they were deep. To be called
  /// after the last note() of a step.
  void find_lost(const PairRules& rules, std::vector<LostContact>& lost) const;

  void archive(StateArchive& saved);

 private:
  struct Candidate {
    std::uint32_t first, second, pair;
    std::size_t position;  ///< in candidates_
    const PairRule& rule;
  };
  /// Two faces that the elastic penalty parts.
  struct PenaltyPush {
    const MovingFace &first, &second;
    const PairPenalty& penalty;
    double activation_distance;  ///< gaps up to it count as near [length]
    bool did_touch;              ///< in the last step
  };
  void find_one(const ContactStepContext& context, const Candidate& candidate,
                std::vector<ContactPoint>& contact_points);
  /// The contact points of a pair that is enforced by the elastic penalty.
  void find_penalty(const ContactStepContext& context, const Candidate& candidate, const PenaltyPush& push,
                    std::vector<ContactPoint>& contact_points);
  void add_penalty(const ContactStepContext& context, const Candidate& candidate, const PenaltyPush& push,
                   const FaceFaceContact& contact, std::vector<ContactPoint>& contact_points);
  /// The contact points of a pair that is enforced by momentum balance.
  void find_constraints(const ContactStepContext& context, const Candidate& candidate,
                        const MovingFace& first, const MovingFace& second,
                        const ConstraintActivation& activation, bool did_touch,
                        std::vector<ContactPoint>& contact_points);
  /// Thickness of the thinner element behind the faces [length].
  double thinner(const Candidate& candidate) const;
  ContactPoint make_contact_point(const Candidate& candidate, const FaceFaceContact& contact) const;
  /// Adds what a law does across the gap, or beside the penalty.
  void pull_one(const ContactStepContext& context, const Candidate& candidate,
                std::vector<ContactPoint>& contact_points);
  Eigen::Vector3d mean_slip(const Candidate& candidate) const;
  /// How deep one of the two faces was in the last step, in whatever it touched; 0 if they touched nothing.
  double depth_before(const Candidate& candidate) const;
  /// Whether faces that overlap got there through their fronts: they were in front of each other, or hardly
  /// behind, one step ago, or one of them has touched something already. The sides of two bodies that
  /// lie on each other at an edge overlap too, by a sliver that is far deeper than wide, and do not touch.
  ///   closed  by which the gap has shrunk in the step [length]
  bool met_in_front(const ContactStepContext& context, const Candidate& candidate,
                    const FaceFaceContact& contact, double closed) const;

  const ContactMesh& contact_mesh_;
  bool has_friction_;
  PairLists candidates_, next_;
  std::vector<std::uint8_t> touched_;           // [n_candidates] in the last step
  std::vector<Eigen::Vector3d> elastic_slips_;  // [n_candidates] [length]; empty without friction
  /// [n_faces] of the last step and of this one: slip times area, as the face sees it, and area; empty
  /// without friction.
  std::vector<Eigen::Vector4d> means_, next_means_;
  // [n_faces] penetration, 0 where nothing touches, in the last step and in this one [length]
  std::vector<float> depth_before_, depth_now_;
  std::vector<std::uint32_t> partner_before_, partner_now_;  // [n_faces] by which each is deepest
};

}  // namespace contactsim
