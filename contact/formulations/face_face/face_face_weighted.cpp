// SPDX-License-Identifier: BSD-3-Clause
// The contact points of two faces in a load step, which weighted gaps press and weighted slips drag.
#include <algorithm>

#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/face_face/weighted_gaps.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/geometry/common_plane.hpp"
#include "contact/geometry/smooth_step.hpp"
#include "contact/search/contact_search.hpp"
#include "contact/smoothing/smooth_overlap.hpp"

namespace contactsim {

namespace {

/// What is wider open than this, over the thickness of the thinner element, counts as half as wide and bears
/// nothing: whether the rest touches does not depend on it.
constexpr double open_share = 0.1;
/// And from here on to the reach of the search less and less.
constexpr double fading_share = 0.5 * load_step_reach;

/// The gap that a gap counts as, g - g^2 / (2 w) between 0 and w, and its derivative.
struct CountedGap {
  double gap, slope;
};
CountedGap counted(double gap, double open) {
  const double share = std::clamp(gap / open, 0.0, 1.0);
  return {std::min(gap, open) - 0.5 * share * share * open, 1.0 - share};
}

/// How much an overlap counts whose gap is so wide [1].
double weight_at(double gap, double thickness) {
  const double fading = (load_step_reach - fading_share) * thickness;
  return std::clamp((load_step_reach * thickness - gap) / fading, 0.0, 1.0);
}

/// How much an overlap of faces counts by the cosine of their normals: the less the more they lean, and
/// nothing where they begin to stand beside each other, so that none comes or goes with a force. The walls of
/// a sharp corner, which lean away from what it is pressed into, would keep apart what the corner presses;
/// but the flanks of a wedge are all that it is pressed in by.
///   facing  cosine up to which they face each other
double weight_of_lean(double cosine, double facing) {
  constexpr double upright = -0.8, beginning = -0.35, least = 0.25;
  const auto share = [&](double from, double to) {
    return smooth_step(std::clamp((from - cosine) / (from - to), 0.0, 1.0));
  };
  return least * share(facing, beginning) + (1.0 - least) * share(beginning, upright);
}

/// An overlap by its mean gap, without a force.
FaceFaceContact mean_of(const WeightedOverlap& overlap) {
  FaceFaceContact mean;
  for (std::size_t k = 0; k < overlap.shares.n; ++k) {
    const OverlapShare& share = overlap.shares.corners[k];
    mean.area += share.area;
    const double part = share.area / mean.area;
    mean.gap += part * (overlap.gaps[k] - mean.gap);
    mean.weights_1 += part * (share.weights_1 - mean.weights_1);
    mean.weights_2 += part * (share.weights_2 - mean.weights_2);
    mean.normal += share.area * share.normal;
  }
  mean.normal.normalize();
  return mean;
}

}  // namespace

bool FaceFaceContacts::is_weighted(const ContactStepContext& context, const Candidate& candidate) const {
  const PairRule& rule = candidate.rule;
  return context.weighted_gaps != nullptr && context.enforces(rule) && rule.law != ContactLaw::tied &&
         !(rule.pair->held_gap(thinner(candidate)) > 0.0);
}

void FaceFaceContacts::weigh(const ContactStepContext& context, CandidateRows rows,
                             std::vector<WeightedOverlap>& overlaps) const {
  for (const FaceIndex first : rows.indices<FaceIndex>()) {
    for (std::size_t k = candidates_.first_pair(first); k < candidates_.end_pair(first); ++k)
      weigh_one(context, make_candidate(context, first, k), overlaps);
  }
}

void FaceFaceContacts::weigh_one(const ContactStepContext& context, const Candidate& candidate,
                                 std::vector<WeightedOverlap>& overlaps) const {
  if (!is_weighted(context, candidate)) return;
  const PairRule& rule = candidate.rule;
  const double thickness = thinner(candidate);
  const double reach = load_step_reach * thickness + context.rules.gap_offsets().reach(candidate.pair) +
                       std::max(0.0, rule.begin_gap);
  if (!may_meet(context, candidate, reach)) return;
  if (rule.law != ContactLaw::sliding && context.constrained.holds_faces(candidate.first, candidate.second))
    return;

  const MeetingFaces faces = make_meeting_faces(context, candidate);
  WeightedOverlap overlap;
  overlap.first = candidate.first;
  overlap.second = candidate.second;
  overlap.pair = candidate.pair;
  overlap.rule = &rule;
  overlap.candidate = candidate.position;
  overlap.is_of_first =
      contact_mesh_.faces[candidate.first].surface == context.weighted_gaps->finer_surface(candidate.pair);
  if (faces.are_round()) {
    const SmoothPatch patch_1(faces.first, faces.round_first), patch_2(faces.second, faces.round_second);
    overlap.shares = find_smooth_corner_shares({patch_1, patch_2, faces.offset}, overlap.is_of_first);
  } else {
    overlap.shares = find_corner_shares(faces.first, faces.second, overlap.is_of_first);
  }
  if (overlap.shares.n == 0) return;
  for (std::size_t k = 0; k < overlap.shares.n; ++k)
    overlap.gaps[k] = gap_of(overlap.shares.corners[k], faces.first, faces.second);
  const FaceFaceContact mean = mean_of(overlap);
  const Eigen::Vector3d apart =
      faces.first.velocity_at(mean.weights_1) - faces.second.velocity_at(mean.weights_2);
  const double closed = -apart.dot(mean.normal) * context.dt;
  const double cosine = faces.first.look().area.normalized().dot(faces.second.look().area.normalized());
  const double facing = facing_limit(std::max(faces.first.sharpness, faces.second.sharpness));
  overlap.weight = weight_at(mean.gap, thickness) * weight_of_lean(cosine, facing);
  overlap.penalty = make_penalty(candidate, faces.did_touch, std::max(closed, 0.0));
  overlap.penalty.law = {};  // multipliers press what is deep, not a penalty that grows stiffer
  // Of the mesh: what an offset makes deeper is no other wall.
  overlap.penalty.depth += std::max(faces.offset, 0.0);
  if (!(overlap.weight > 0.0) || -mean.gap > overlap.penalty.depth) return;
  if (mean.gap < 0.0 && !faces.did_touch) {
    if (!met_in_front(context, candidate, mean, closed)) return;
    if (FlushStrips(context, candidate.first, candidate.second).hold(mean)) return;
  }
  for (std::size_t k = 0; k < overlap.shares.n; ++k) {
    const CountedGap gap = counted(overlap.gaps[k], open_share * thickness);
    overlap.gaps[k] = gap.gap;
    overlap.slopes[k] = gap.slope;
  }
  if (rule.friction > 0.0) find_slips(context, candidate, faces, overlap);
  overlaps.push_back(overlap);
}

void FaceFaceContacts::find_slips(const ContactStepContext& context, const Candidate& candidate,
                                  const MeetingFaces& faces, WeightedOverlap& overlap) const {
  const Eigen::Vector3d held = faces.did_touch ? history_.elastic_slip(candidate.position)
                                               : history_.mean_slip(candidate.first, candidate.second);
  for (std::size_t k = 0; k < overlap.shares.n; ++k) {
    const OverlapShare& share = overlap.shares.corners[k];
    overlap.slips[k] = overlap.sign() * context.dt *
                       (faces.first.velocity_at(share.weights_1) - faces.second.velocity_at(share.weights_2));
    overlap.held_slips[k] = overlap.sign() * held;
  }
}

void FaceFaceContacts::add_weighted_points(const ContactStepContext& context, const Candidate& candidate,
                                           std::vector<ContactPoint>& points) const {
  const WeightedOverlap* overlap = context.weighted_gaps->find(candidate.position);
  if (overlap == nullptr) return;
  const MeetingFaces faces = make_meeting_faces(context, candidate);
  for (std::size_t k = 0; k < overlap->shares.n; ++k) {
    const OverlapShare& share = overlap->shares.corners[k];
    const WeightedNode& node = context.weighted_gaps->node_of(*overlap, k);
    FaceFaceContact contact;
    contact.area = overlap->bearing_area(k);
    contact.force = contact.area * node.pressure;
    if (!(contact.force > 0.0)) continue;
    contact.stiffness = contact.area * node.slope;
    contact.normal = share.normal;
    contact.weights_1 = share.weights_1;
    contact.weights_2 = share.weights_2;
    contact.gap = -node.depth();
    contact.deepest = node.depth();
    if (faces.are_round()) {
      const Eigen::Vector3d place =
          0.5 * (faces.first.x * share.weights_1 + faces.second.x * share.weights_2);
      bring_onto_line(faces.first, faces.second, place, contact);
    }
    ContactPoint& point = points.emplace_back(make_contact_point(candidate, contact));
    point.part = share.part;
    point.begin_gap += node.multiplier;
    if (!node.has_friction()) continue;
    point.tangential = overlap->sign() * contact.area * node.friction.force;
    point.elastic_slip = overlap->sign() * node.friction.elastic_slip;
    point.slip = overlap->sign() * node.friction.slip;
    point.dissipated = contact.area * node.friction.dissipated;
  }
}

std::vector<WeightedGapMotion> FaceFaceContacts::node_motions(const ContactStepContext& context) const {
  std::vector<WeightedGapMotion> motions;
  const WeightedGaps& weighted = *context.weighted_gaps;
  for (const WeightedOverlap& overlap : weighted.overlaps()) {
    const Candidate candidate = make_candidate(context, overlap.first, overlap.candidate);
    const auto &first = contact_mesh_.faces[overlap.first].corners,
               &second = contact_mesh_.faces[overlap.second].corners;
    for (std::size_t k = 0; k < overlap.shares.n; ++k) {
      const WeightedNode& node = weighted.node_of(overlap, k);
      if (!(node.slope > 0.0) || !(overlap.slopes[k] > 0.0)) continue;
      const OverlapShare& share = overlap.shares.corners[k];
      Eigen::Vector4d of_first = share.weights_1, of_second = share.weights_2;
      if (!candidate.carry.is_zero())
        (candidate.carry.is_of_first ? of_first : of_second) += candidate.carry.weights;
      const double bearing = overlap.bearing_area(k);
      const Eigen::Vector3d opening = bearing / node.area * share.normal;
      const double slipping = node.has_friction() ? overlap.sign() * bearing / node.bearing : 0.0;
      const auto add = [&](ContactNodeIndex corner, double weight) {
        if (weight != 0.0) motions.push_back({overlap.nodes[k], corner, weight * opening, weight * slipping});
      };
      for (std::size_t c = 0; c < 4; ++c) {
        add(first[c], of_first[static_cast<Eigen::Index>(c)]);
        add(second[c], -of_second[static_cast<Eigen::Index>(c)]);
      }
    }
  }
  const auto key = [](const WeightedGapMotion& motion) { return std::pair(motion.number, motion.node); };
  std::ranges::stable_sort(motions, {}, key);
  std::vector<WeightedGapMotion> sums;
  for (const WeightedGapMotion& motion : motions) {
    if (!sums.empty() && key(sums.back()) == key(motion)) {
      sums.back().opens += motion.opens;
      sums.back().slips += motion.slips;
    } else {
      sums.push_back(motion);
    }
  }
  return sums;
}

}  // namespace contactsim
