// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_lists.hpp"
#include "contact/mesh/pair_set.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

class StateArchive;

/// Position of a corner among those of all faces, four of each.
using FaceCornerIndex = Index<struct FaceCornerKind>;

/// What contact of faces remembers from step to step: of pairs whether they touched and the slip that their
/// tangential spring holds, of faces the mean slip and how deep they were in which other face.
class FaceFaceHistory {
 public:
  ///   may_hold  what has touched may not part in some pair
  FaceFaceHistory(bool has_friction, bool may_hold) : has_friction_(has_friction), may_hold_(may_hold) {}

  /// What is known of a pair of faces, by its position among the candidates.
  bool has_touched(std::size_t candidate) const { return touched_before_[candidate] != 0; }
  /// [length]
  Eigen::Vector3d elastic_slip(std::size_t candidate) const;
  /// Whether the place of a contact point touched in the last step, by this pair of faces or another one that
  /// one of its faces has slid from. A place is what of a face is nearest to a corner.
  bool is_held(const ContactPoint& point) const;
  /// The mean slip of the first face against what it touched, else that of the second, as the first sees it
  /// [length].
  Eigen::Vector3d mean_slip(FaceIndex first, FaceIndex second) const;
  /// How deep one of two faces was in the last step, in whatever it touched; 0 if they touched nothing
  /// [length].
  double depth_before(FaceIndex first, FaceIndex second) const;
  /// How deep each face is in the step that has been updated [n_faces], 0 where it does not touch; nothing
  /// before the first [length].
  std::span<const float> depths() const { return depth_now_; }

  /// Goes over to other candidates.
  void transfer(const FacePairLists& before, const FacePairLists& after);
  void begin_step(const FacePairLists& candidates, std::size_t n_faces);
  /// What was remembered before is so again. Precondition: no update() since.
  void undo_begin_step() { swap_steps(); }
  /// Takes contact points over, those of one pair of faces together.
  void update(const ContactStepContext& context, const FacePairLists& candidates,
              std::span<const ContactPoint> points);
  /// Appends the contacts that ended though they were deep.
  void find_lost(const ContactMesh& contact_mesh, const PairRules& rules,
                 std::vector<LostContact>& lost) const;
  /// Goes over to other faces.
  ///   before  position of each candidate before [n_candidates]
  void remap(const ContactRemap& remap, std::span<const std::size_t> before);
  void archive(StateArchive& saved);
  std::size_t bytes() const {
    return bytes_of(touched_before_) + bytes_of(touched_now_) + bytes_of(elastic_slips_) + bytes_of(means_) +
           bytes_of(next_means_) + bytes_of(depth_before_) + bytes_of(depth_now_) +
           bytes_of(partner_before_) + bytes_of(partner_now_);
  }

 private:
  /// What detect() says of a pair that touched, or that a law held across a gap.
  enum Touch : std::uint8_t { touched = 1, held_apart = 2 };

  void update_pair(const ContactStepContext& context, std::size_t candidate,
                   std::span<const ContactPoint> points);
  void update_faces(const ContactPoint& point);

  void hold(const ContactPoint& point);
  void swap_steps();

  bool has_friction_, may_hold_;
  std::vector<std::uint8_t> touched_before_, touched_now_;  // [n_candidates] in the last step, in this one
  std::vector<Eigen::Vector3d> elastic_slips_;              // [n_candidates] [length]; empty without friction
  /// Of the last step and of this one: slip times area, as the face sees it, and area; empty
  /// without friction.
  IndexedVector<FaceIndex, Eigen::Vector4d> means_, next_means_;
  // Penetration, 0 where nothing touches, in the last step and in this one [length]
  IndexedVector<FaceIndex, float> depth_before_, depth_now_;
  NewPositions<FaceIndex> partner_before_, partner_now_;  // by which each is deepest
  // Pairs of surfaces with corners of faces, of those that may not part.
  PairSet<PairIndex, FaceCornerIndex> held_before_, held_now_;
};

}  // namespace contactsim
