// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_face_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/formulations/cohesive_traction.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/formulations/start_gaps.hpp"
#include "contact/geometry/facets.hpp"
#include "contact/interface_laws/friction.hpp"

namespace contactsim {

namespace {

/// Faces that have touched something may be this share of a thickness deep in the next partner, at least.
constexpr double slide_depth = 0.1;

Eigen::Vector3d velocity_at(const MovingFace& face, const Eigen::Vector4d& weights) {
  return face.v * weights;
}

/// Takes an offset off the gap of two faces: the first goes by it along their common normal, which stays.
void take_off(double offset, const MovingFace& second, MovingFace& first) {
  if (offset == 0.0) return;
  const auto plane = make_common_plane(first.x, first.look(), second.look());
  if (plane) first.x.colwise() -= offset * plane->normal;
}

}  // namespace

void FaceFaceContacts::find_candidates(ContactSearch& search, const ContactKinematics& kinematics,
                                       const Motion& motion) {
  PairLists next;
  search.find_face_pairs(kinematics, motion, depths(), next);
  take_candidates(std::move(next));
}

void FaceFaceContacts::take_candidates(PairLists candidates) {
  history_.transfer(candidates_, candidates);
  candidates_ = std::move(candidates);
}

void FaceFaceContacts::watch(std::vector<std::uint8_t>& is_watched) const {
  for (std::size_t row = 0; row < candidates_.n_rows(); ++row) {
    if (!candidates_.of(row).empty()) is_watched[row] = 1;
    for (const std::uint32_t partner : candidates_.of(row)) is_watched[partner] = 1;
  }
}

void FaceFaceContacts::mark_close(const ContactStepContext& context, double size_share,
                                  PairRules& rules) const {
  for (const NearPair& near : find_near_pairs(context, candidates_, {}, size_share, is_hybrid)) {
    const MovingFace first = context.kinematics.face(near.first),
                     second = context.kinematics.face(near.second);
    if (!find_mean_overlap(first, second, near.tolerance)) continue;
    rules.mark_close_face(near.pair, near.first);
    rules.mark_close_face(near.pair, near.second);
  }
}

void FaceFaceContacts::add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const {
  for (std::uint32_t first = 0; first < candidates_.n_rows(); ++first) {
    for (const std::uint32_t second : candidates_.of(first)) {
      const PairIndex pair =
          *context.rules.find(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface);
      if (!context.rules.gap_offsets().needs_start(pair)) continue;
      auto gap = find_start_gap(context.kinematics, *context.rules[pair].pair, first, second);
      if (!gap) continue;
      gap->pair = pair;
      for (const std::uint32_t face : {first, second}) {
        gap->entity = face;
        gaps.faces.push_back(*gap);
      }
    }
  }
}

void FaceFaceContacts::remap(const ContactRemap& remap) {
  std::vector<std::size_t> before;
  candidates_ = transferred(candidates_, remap.faces, remap.faces, remap.n_faces_after, before);
  history_.remap(remap, before);
}

void FaceFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/face_pairs", candidates_, saved);
  history_.archive(saved);
}

void FaceFaceContacts::detect(const ContactStepContext& context, CandidateRows rows,
                              std::vector<ContactPoint>& points) const {
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const auto first = static_cast<std::uint32_t>(row);
    for (std::size_t k = candidates_.begin[row]; k < candidates_.begin[row + 1]; ++k) {
      const std::uint32_t second = candidates_.partners[k];
      const PairIndex pair =
          *context.rules.find(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface);
      const Candidate candidate{first, second, pair, k, context.rules.of_faces(pair, first, second)};
      detect_one(context, candidate, points);
      if (candidate.rule.acts_apart()) add_pull(context, candidate, points);
    }
  }
}

void FaceFaceContacts::detect_one(const ContactStepContext& context, const Candidate& candidate,
                                  std::vector<ContactPoint>& points) const {
  const FaceBound &a = context.kinematics.bound(candidate.first),
                  &b = context.kinematics.bound(candidate.second);
  const double closing = above_zero((b.velocity() - a.velocity()).dot(b.normal()));
  const double closed = closing * context.dt, activation_distance = closing * context.ahead();
  const PairRule& rule = candidate.rule;
  if (rule.is_balanced != context.balances) return;
  const bool did_touch = history_.has_touched(candidate.position);
  const double margin = context.balances ? closed_share * thinner(candidate) : 0.0;
  const GapOffsets& offsets = context.rules.gap_offsets();
  const double reach = std::max(activation_distance, margin) + offsets.reach(candidate.pair);
  if (!may_touch(a, b, reach) || !context.enforces(rule) || rule.law == ContactLaw::tied) return;
  if (rule.law != ContactLaw::sliding && context.constrained.holds_faces(candidate.first, candidate.second))
    return;

  PairPenalty penalty =
      make_pair_penalty(contact_mesh_.faces[candidate.first].penalty_properties,
                        &contact_mesh_.faces[candidate.second].penalty_properties, *rule.pair);
  // What came in by itself may be as deep as its speed brought it; what has touched has no depth at which it
  // ends; what slides on from another partner may be as deep as it was there.
  const double before = history_.depth_before(candidate.first, candidate.second);
  penalty.depth = did_touch      ? std::numeric_limits<double>::infinity()
                  : before > 0.0 ? std::max(penalty.depth, depth_of_known(0.0, before, closed))
                                 : std::max(penalty.depth, 1.5 * closed);
  MovingFace first = context.kinematics.face(candidate.first);
  const MovingFace second = context.kinematics.face(candidate.second);
  take_off(offsets.of_faces(candidate.pair, candidate.first, candidate.second), second, first);
  if (context.balances) {
    const double depth = penalty.depth + 1.5 * closing * context.coming_dt;
    return add_balanced_points(
        context, candidate, first, second,
        {context.coming_dt, margin, activation_distance, depth, flat_share * thinner(candidate)}, did_touch,
        points);
  }
  penalty.closing = closed;
  add_penalty_points(context, candidate, {first, second, penalty, activation_distance, did_touch}, points);
}

void FaceFaceContacts::add_penalty_points(const ContactStepContext& context, const Candidate& candidate,
                                          const PenaltyPush& push, std::vector<ContactPoint>& points) const {
  const double flat = flat_share * thinner(candidate);
  const bool is_split = (is_warped(push.first, flat) || is_warped(push.second, flat)) &&
                        !is_contact_uncut(push.first, push.second, push.penalty, push.activation_distance);
  if (is_split) {
    const Facets facets_1(push.first, flat), facets_2(push.second, flat);
    for (const Facet& a : facets_1.all()) {
      for (const Facet& b : facets_2.all()) {
        FaceFaceContact contact =
            find_face_face_contact(a.face, b.face, push.penalty, push.activation_distance);
        contact.weights_1 = a.to_face(contact.weights_1);
        contact.weights_2 = b.to_face(contact.weights_2);
        add_penalty_point(context, candidate, push, contact, points);
      }
    }
  } else {
    const auto contact =
        find_face_face_contact(push.first, push.second, push.penalty, push.activation_distance);
    add_penalty_point(context, candidate, push, contact, points);
  }
}

void FaceFaceContacts::add_penalty_point(const ContactStepContext& context, const Candidate& candidate,
                                         const PenaltyPush& push, const FaceFaceContact& contact,
                                         std::vector<ContactPoint>& points) const {
  if (!contact.overlaps) return;
  const Eigen::Vector3d apart =
      velocity_at(push.first, contact.weights_1) - velocity_at(push.second, contact.weights_2);
  if (contact.force > 0.0 && !push.did_touch) {
    const double closed = -apart.dot(contact.normal) * context.dt;
    if (!met_in_front(context, candidate, contact, closed)) return;
    if (is_at_flush_rim(context, candidate.first, candidate.second, contact)) return;
  }
  ContactPoint& contact_point = points.emplace_back(make_contact_point(candidate, contact));
  contact_point.damped = contact.damped_power * context.dt;
  if (!contact_point.touches()) return;
  const PairRule& rule = candidate.rule;
  if (!(rule.friction > 0.0)) return;
  contact_point.slip = apart * context.dt;
  contact_point.elastic_slip = push.did_touch ? history_.elastic_slip(candidate.position)
                                              : history_.mean_slip(candidate.first, candidate.second);
  add_friction(push.penalty.stiffness * contact.area, rule.slip_limit(contact_point, context.dt),
               contact_point);
}

double FaceFaceContacts::thinner(const Candidate& candidate) const {
  return std::min(contact_mesh_.faces[candidate.first].penalty_properties.thickness,
                  contact_mesh_.faces[candidate.second].penalty_properties.thickness);
}

void FaceFaceContacts::add_balanced_points(const ContactStepContext& context, const Candidate& candidate,
                                           const MovingFace& first, const MovingFace& second,
                                           const ConstraintActivation& activation, bool did_touch,
                                           std::vector<ContactPoint>& points) const {
  const FaceFaceConstraints found = find_face_face_constraints(first, second, activation);
  const Eigen::Vector3d origin = second.x.col(0);  // large coordinates would cost digits
  for (const OverlapShare& point : found.all()) {
    FaceFaceContact contact;
    contact.normal = point.normal;
    contact.weights_1 = point.weights_1;
    contact.weights_2 = point.weights_2;
    contact.area = point.area;
    contact.gap = point.normal.dot((first.x.colwise() - origin) * point.weights_1 -
                                   (second.x.colwise() - origin) * point.weights_2);
    const Eigen::Vector3d apart = velocity_at(first, point.weights_1) - velocity_at(second, point.weights_2);
    const double closing = -apart.dot(point.normal) * context.coming_dt;
    if (!did_touch && contact.gap < 0.0 && !met_in_front(context, candidate, contact, closing)) continue;
    if (contact.gap < closing && is_at_flush_rim(context, candidate.first, candidate.second, contact))
      continue;
    ContactPoint& contact_point = points.emplace_back(make_contact_point(candidate, contact));
    contact_point.stiffness = 0.0;
    contact_point.is_balanced = true;
    contact_point.part = point.part;
    contact_point.closing = closing;
  }
}

ContactPoint FaceFaceContacts::make_contact_point(const Candidate& candidate,
                                                  const FaceFaceContact& contact) const {
  const ContactFace &first = contact_mesh_.faces[candidate.first],
                    &second = contact_mesh_.faces[candidate.second];
  ContactPoint contact_point;
  contact_point.pair = candidate.pair;
  contact_point.is_swapped = first.surface != candidate.rule.pair->first;
  contact_point.first_entity = candidate.first;
  contact_point.second_entity = candidate.second;
  contact_point.first = {first.corners, contact.weights_1};
  contact_point.second = {second.corners, contact.weights_2};
  contact_point.normal = contact.normal;
  contact_point.force = contact.force;
  contact_point.area = contact.area;
  contact_point.gap = contact.gap;
  contact_point.deepest = contact.deepest;
  contact_point.beyond_spring = contact.beyond_spring;
  contact_point.stiffness = damped_stiffness(contact.stiffness, candidate.rule.pair->damping_fraction);
  return contact_point;
}

void FaceFaceContacts::add_pull(const ContactStepContext& context, const Candidate& candidate,
                                std::vector<ContactPoint>& points) const {
  const PairRule& rule = candidate.rule;
  const ContactFace &first = contact_mesh_.faces[candidate.first],
                    &second = contact_mesh_.faces[candidate.second];
  const FaceBound &a = context.kinematics.bound(candidate.first),
                  &b = context.kinematics.bound(candidate.second);
  const GapOffsets& offsets = context.rules.gap_offsets();
  const double reach = rule.activation_distance + offsets.reach(candidate.pair);
  if (!context.enforces(rule) || !may_touch(a, b, reach)) return;
  FacePenaltyInput push{
      context.kinematics.last_face(candidate.first), context.kinematics.last_face(candidate.second),
      make_pair_penalty(first.penalty_properties, &second.penalty_properties, *rule.pair), context.dt};
  take_off(offsets.of_faces(candidate.pair, candidate.first, candidate.second), push.second, push.first);
  ContactPoint contact_point;
  contact_point.elastic_slip = history_.elastic_slip(candidate.position);
  if (!add_face_traction(*rule.interface_law, push, contact_point)) return;
  contact_point.pair = candidate.pair;
  contact_point.is_swapped = first.surface != rule.pair->first;
  contact_point.first_entity = candidate.first;
  contact_point.second_entity = candidate.second;
  contact_point.first.nodes = first.corners;
  contact_point.second.nodes = second.corners;
  points.push_back(contact_point);
}

bool FaceFaceContacts::met_in_front(const ContactStepContext& context, const Candidate& candidate,
                                    const FaceFaceContact& contact, double closed) const {
  // Before the first step nobody knows: what is wider than deep is pushed out.
  if (context.dt == 0.0) return contact.gap * contact.gap <= contact.area;
  const double thickness = thinner(candidate);
  if (contact.gap + closed > -shallow_depth * thickness) return true;
  // One that slides on from another partner may be about as deep as it was there, but not behind a far wall.
  const double before = history_.depth_before(candidate.first, candidate.second);
  return before > 0.0 && -contact.gap < depth_of_known(slide_depth * thickness, before, closed);
}

}  // namespace contactsim
