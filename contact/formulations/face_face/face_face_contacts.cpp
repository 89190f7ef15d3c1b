// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_face_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/formulations/cohesive_traction.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/formulations/prefetch.hpp"
#include "contact/geometry/facets.hpp"
#include "contact/smoothing/smooth_overlap.hpp"

namespace contactsim {

namespace {

/// Faces that have touched something may be this share of a thickness deep in the next partner, at least.
constexpr double slide_depth = 0.1;

}  // namespace

void FaceFaceContacts::begin_detection(const ContactStepContext& context) {
  if (!culls(context)) return;
  bounds_.update(context.kinematics);
  if (context.candidates != CandidateUse::renew_close) return;
  bounds_.find_turns(context.kinematics, context.close_range.motion);
  const double reach = widest_reach_ + context.close_range.reach;
  close_.renew_pairs<FacePairBounds::Pairs>(
      candidates_, [&](const auto& pairs) { return bounds_.may_meet(pairs, context.close_range, reach); });
}

/// Sixteen candidates are culled, and what is known of those that are left fetched, before those that were
/// left of the sixteen before are looked at.
void FaceFaceContacts::detect(const ContactStepContext& context, CandidateRows rows,
                              std::vector<ContactPoint>& points) const {
  const bool does_cull = culls(context);
  const double reach = widest_reach_ + context.rules.largest_reach();
  FacePairBounds::Pairs pairs{}, before{};
  std::uint32_t near_before = 0;
  Meetings meetings;
  const auto detect_before = [&] {
    for (std::uint32_t left = near_before; left != 0; left &= left - 1) {
      const FaceIndex second = before.second[first_lane(left)];
      for (const ContactNodeIndex node : contact_mesh_.faces[second].corners)
        prefetch(context.kinematics, node);
    }
    for (std::uint32_t left = near_before; left != 0; left &= left - 1) {
      const std::size_t lane = first_lane(left);
      const Candidate candidate = make_candidate(context, before.first[lane], before.position[lane]);
      detect_one(context, candidate, meetings, points);
      if (!candidate.rule.acts_apart()) continue;
      end_meetings(context, meetings, points);
      add_pull(context, candidate, points);
    }
  };
  const auto cull_pairs = [&] {
    const std::uint32_t near = does_cull ? bounds_.may_touch(pairs, context.ahead(), reach) : pairs.all();
    for (std::uint32_t left = near; left != 0; left &= left - 1) {
      const FaceIndex second = pairs.second[first_lane(left)];
      prefetch(contact_mesh_.faces[second]);
      prefetch(context.kinematics.bound(second));
    }
    detect_before();
    before = pairs;
    near_before = near;
    pairs.n = 0;
  };
  const auto prefetch_bound = [&](FaceIndex second) {
    if (does_cull) bounds_.prefetch(second);
  };
  close_.visit(candidates_, rows, does_cull ? context.candidates : CandidateUse::all, prefetch_bound,
               [&](FaceIndex first, std::size_t k) {
                 pairs.add(first, candidates_.partner(k), k);
                 if (pairs.are_full()) cull_pairs();
               });
  cull_pairs();
  detect_before();
  end_meetings(context, meetings, points);
}

void FaceFaceContacts::end_meetings(const ContactStepContext& context, Meetings& meetings,
                                    std::vector<ContactPoint>& points) const {
  if (meetings.all.empty()) return;
  if (context.balances) {
    add_balanced_points(context, meetings, points);
  } else {
    add_penalty_points(context, meetings, points);
  }
  meetings.all.clear();
}

void FaceFaceContacts::detect_one(const ContactStepContext& context, const Candidate& candidate,
                                  Meetings& meetings, std::vector<ContactPoint>& points) const {
  const FaceBound &a = context.kinematics.bound(candidate.first),
                  &b = context.kinematics.bound(candidate.second);
  const double closing = above_zero((b.velocity() - a.velocity()).dot(b.normal()));
  const double closed = closing * context.dt, activation_distance = closing * context.ahead();
  const PairRule& rule = candidate.rule;
  if (is_weighted(context, candidate)) {
    end_meetings(context, meetings, points);
    return add_weighted_points(context, candidate, points);
  }
  if (rule.is_balanced != context.balances) return;
  const double margin = context.balances ? closed_share * thinner(candidate) : 0.0;
  const double held = rule.pair->held_gap(thinner(candidate));
  const GapOffsets& offsets = context.rules.gap_offsets();
  const double reach = std::max({activation_distance, margin, held}) + offsets.reach(candidate.pair) +
                       std::max(0.0, rule.begin_gap);
  if (!may_meet(context, candidate, reach) || !context.enforces(rule) || rule.law == ContactLaw::tied) return;
  if (rule.law != ContactLaw::sliding && context.constrained.holds_faces(candidate.first, candidate.second))
    return;

  Meeting& meeting =
      meetings.all.emplace_back(Meeting{candidate, make_meeting_faces(context, candidate), {}, {}});
  PairPenalty& penalty = meeting.penalty;
  penalty = make_penalty(candidate, meeting.faces.did_touch, closed);
  // Of the mesh: what an offset makes deeper is no other wall.
  penalty.depth += std::max(meeting.faces.offset, 0.0);
  const double flat = flat_share * thinner(candidate);
  if (context.balances) {
    const double depth = penalty.depth + 1.5 * closing * context.coming_dt;
    meeting.activation = {context.coming_dt, std::max(margin, held), std::max(activation_distance, held),
                          depth, flat};
  } else {
    penalty.closing = context.is_static ? 0.0 : closed;
    meeting.activation = {0.0, 0.0, activation_distance, penalty.depth, flat};
  }
  if (meeting.faces.are_round() || (!context.balances && held > 0.0)) {
    const Meeting alone = meeting;
    meetings.all.pop_back();
    end_meetings(context, meetings, points);
    return add_points_alone(context, alone, points);
  }
  if (meetings.all.size() == n_lanes) end_meetings(context, meetings, points);
}

void FaceFaceContacts::add_points_alone(const ContactStepContext& context, const Meeting& meeting,
                                        std::vector<ContactPoint>& points) const {
  const auto& [candidate, faces, penalty, activation] = meeting;
  if (context.balances)
    return add_balanced_points(context, meeting, faces.find_constraints(activation), points);
  if (candidate.rule.pair->held_gap(thinner(candidate)) > 0.0)
    return add_spring_points(context, meeting, points);
  const SmoothPatch patch_1(faces.first, faces.round_first), patch_2(faces.second, faces.round_second);
  const auto contact = find_smooth_contact({patch_1, patch_2, faces.offset}, penalty, activation.near);
  add_penalty_point(context, meeting, contact, points);
}

PairPenalty FaceFaceContacts::make_penalty(const Candidate& candidate, bool did_touch, double closed) const {
  PairPenalty penalty =
      make_pair_penalty(contact_mesh_.faces[candidate.first].penalty_properties,
                        &contact_mesh_.faces[candidate.second].penalty_properties, candidate.rule);
  // What came in by itself may be as deep as its speed brought it; what has touched has no depth at which it
  // ends; what slides on from another partner may be as deep as it was there.
  const double before = history_.depth_before(candidate.first, candidate.second);
  penalty.depth = did_touch      ? std::numeric_limits<double>::infinity()
                  : before > 0.0 ? std::max(penalty.depth, depth_of_known(0.0, before, closed))
                                 : std::max(penalty.depth, 1.5 * closed);
  return penalty;
}

double FaceFaceContacts::offset_of(const ContactStepContext& context, const Candidate& candidate) {
  return context.rules.gap_offsets().of_faces(candidate.pair, candidate.first, candidate.second) +
         candidate.rule.begin_gap;
}

MeetingFaces FaceFaceContacts::make_meeting_faces(const ContactStepContext& context,
                                                  const Candidate& candidate) const {
  const OptionalIndex<std::uint32_t> smoothing = candidate.rule.pair->smoothing;
  MeetingFaces faces{context.kinematics.face(candidate.first),
                     context.kinematics.face(candidate.second),
                     contact_mesh_.smooth_faces.find(smoothing, candidate.first),
                     contact_mesh_.smooth_faces.find(smoothing, candidate.second),
                     offset_of(context, candidate),
                     history_.has_touched(candidate.position)};
  carry_along(candidate.carry, faces.first, faces.second);
  if (!faces.are_round()) take_off_gap(faces.offset, faces.second, faces.first);
  return faces;
}

/// Says yes rather too often. Of a face that is carried only the plane stays where it is.
bool FaceFaceContacts::may_meet(const ContactStepContext& context, const Candidate& candidate,
                                double reach) const {
  const FaceBound &a = context.kinematics.bound(candidate.first),
                  &b = context.kinematics.bound(candidate.second);
  if (candidate.carry.is_zero()) return may_touch(a, b, reach);
  const FaceBound &still = candidate.carry.is_of_first ? a : b, &slides = candidate.carry.is_of_first ? b : a;
  const double rough = 2.0 * static_cast<double>(a.radius() + b.radius());
  return static_cast<double>(still.height_of(slides.centre())) <= reach + rough;
}

double FaceFaceContacts::thinner(const Candidate& candidate) const {
  return std::min(contact_mesh_.faces[candidate.first].penalty_properties.thickness,
                  contact_mesh_.faces[candidate.second].penalty_properties.thickness);
}

ContactPoint FaceFaceContacts::make_contact_point(const Candidate& candidate,
                                                  const FaceFaceContact& contact) const {
  const ContactFace &first = contact_mesh_.faces[candidate.first],
                    &second = contact_mesh_.faces[candidate.second];
  ContactPoint contact_point;
  contact_point.pair = candidate.pair;
  contact_point.is_swapped = first.surface != candidate.rule.pair->first;
  contact_point.first_entity = candidate.first.value;
  contact_point.second_entity = candidate.second.value;
  contact_point.first = {first.corners, contact.weights_1};
  contact_point.second = {second.corners, contact.weights_2};
  carry_along(candidate.carry, contact_point);
  contact_point.normal = contact.normal;
  contact_point.force = contact.force;
  contact_point.area = contact.area;
  contact_point.gap = contact.gap;
  contact_point.begin_gap = candidate.rule.begin_gap;
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
  const GapOffsets& offsets = context.rules.gap_offsets();
  const double reach = rule.activation_distance + offsets.reach(candidate.pair);
  if (!context.enforces(rule) || !may_meet(context, candidate, reach)) return;
  FacePenaltyInput push{
      context.kinematics.last_face(candidate.first), context.kinematics.last_face(candidate.second),
      make_pair_penalty(first.penalty_properties, &second.penalty_properties, *rule.pair), context.dt};
  carry_along(candidate.carry, push.first, push.second);
  take_off_gap(offsets.of_faces(candidate.pair, candidate.first, candidate.second), push.second, push.first);
  ContactPoint contact_point;
  contact_point.elastic_slip = history_.elastic_slip(candidate.position);
  if (!add_face_traction(*rule.interface_law, push, contact_point)) return;
  contact_point.pair = candidate.pair;
  contact_point.is_swapped = first.surface != rule.pair->first;
  contact_point.first_entity = candidate.first.value;
  contact_point.second_entity = candidate.second.value;
  contact_point.first.nodes = first.corners;
  contact_point.second.nodes = second.corners;
  carry_along(candidate.carry, contact_point);
  points.push_back(contact_point);
}

bool FaceFaceContacts::met_in_front(const ContactStepContext& context, const Candidate& candidate,
                                    const FaceFaceContact& contact, double closed) const {
  // Before the first step there is no motion to decide by: what is wider than deep in the mesh is pushed out.
  if (context.dt == 0.0) {
    const double gap = contact.gap + std::max(offset_of(context, candidate), 0.0);
    return gap * gap <= contact.area;
  }
  // What a ramp brings in comes from in front, in a load step by any depth.
  if (context.is_static && candidate.rule.pair->gap.overlap_ramp_time) return true;
  const double thickness = thinner(candidate);
  // What comes up behind the one side of a shell that takes part leaves through it.
  const bool may_leave = candidate.rule.pair->is_polar() && !(closed > 0.0);
  if (contact.gap + closed > -shallow_depth * thickness && !may_leave) return true;
  // One that slides on from another partner may be about as deep as it was there, but not behind a far wall.
  const double before = history_.depth_before(candidate.first, candidate.second);
  return before > 0.0 && -contact.gap < depth_of_known(slide_depth * thickness, before, closed);
}

}  // namespace contactsim
