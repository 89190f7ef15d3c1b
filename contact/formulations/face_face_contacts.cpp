// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/formulations/cohesive_traction.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/geometry/facets.hpp"
#include "contact/interface_laws/friction.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

constexpr std::uint32_t no_partner = 0xffffffff;

/// Faces that have touched something may be this share of a thickness deep in the next partner, at least.
constexpr double slide_depth = 0.1;

Eigen::Vector3d velocity_at(const MovingFace& face, const Eigen::Vector4d& weights) {
  return face.v * weights;
}

}  // namespace

void FaceFaceContacts::take_candidates() {
  touched_ = transfer_pairs<std::uint8_t>(candidates_, touched_, next_, 0);
  if (has_friction_)
    elastic_slips_ =
        transfer_pairs<Eigen::Vector3d>(candidates_, elastic_slips_, next_, Eigen::Vector3d::Zero());
  candidates_ = std::exchange(next_, {});
}

void FaceFaceContacts::remap(const ContactRemap& remap) {
  std::vector<std::size_t> before;
  candidates_ = transferred(candidates_, remap.faces, remap.faces, remap.n_faces_after, before);
  std::vector<std::uint8_t> touched;
  std::vector<Eigen::Vector3d> elastic_slip;
  for (const std::size_t old : before) {
    touched.push_back(touched_[old]);
    if (has_friction_) elastic_slip.push_back(elastic_slips_[old]);
  }
  touched_ = std::move(touched);
  elastic_slips_ = std::move(elastic_slip);
  const Eigen::Vector4d no_slip = Eigen::Vector4d::Zero();
  transfer(remap.faces, remap.n_faces_after, no_slip, means_);
  transfer(remap.faces, remap.n_faces_after, no_slip, next_means_);
  transfer(remap.faces, remap.n_faces_after, 0.0f, depth_before_);
  transfer(remap.faces, remap.n_faces_after, 0.0f, depth_now_);
  // Contacts that deaths end are not lost.
  for (std::vector<std::uint32_t>* partners : {&partner_before_, &partner_now_})
    partners->assign(depth_now_.size(), no_partner);
}

void FaceFaceContacts::begin_step() {
  std::swap(depth_before_, depth_now_);
  std::swap(partner_before_, partner_now_);
  depth_before_.resize(contact_mesh_.faces.size(), 0.0f);
  partner_before_.resize(contact_mesh_.faces.size(), no_partner);
  depth_now_.assign(contact_mesh_.faces.size(), 0.0f);
  partner_now_.assign(contact_mesh_.faces.size(), no_partner);
  if (!has_friction_) return;
  std::swap(means_, next_means_);
  means_.resize(contact_mesh_.faces.size(), Eigen::Vector4d::Zero());
  next_means_.assign(contact_mesh_.faces.size(), Eigen::Vector4d::Zero());
}

void FaceFaceContacts::note(const ContactPoint& contact_point) {
  if (!contact_point.is_met() || contact_point.is_held_apart) return;
  const auto deepen = [&](std::uint32_t face, std::uint32_t partner) {
    const float depth = std::max(static_cast<float>(-contact_point.gap), std::numeric_limits<float>::min());
    if (!(depth > depth_now_[face])) return;
    depth_now_[face] = depth;
    partner_now_[face] = partner;
  };
  deepen(contact_point.first_entity, contact_point.second_entity);
  deepen(contact_point.second_entity, contact_point.first_entity);
  if (!has_friction_ || contact_point.is_balanced) return;
  Eigen::Vector4d share;
  share << contact_point.area * contact_point.elastic_slip, 0.0;
  const Eigen::Vector4d area(0.0, 0.0, 0.0, contact_point.area);
  next_means_[contact_point.first_entity] += share + area;
  next_means_[contact_point.second_entity] += area - share;
}

void FaceFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/face_pairs", candidates_, saved);
  saved.list("contact/face_pairs/touched", touched_);
  saved.list("contact/face_pairs/elastic_slip", elastic_slips_);
  // What is known of faces between steps; begin_step() makes it that of the last one.
  saved.list("contact/faces/mean_slip", next_means_);
  saved.list("contact/faces/depth", depth_now_);
  saved.list("contact/faces/partner", partner_now_);
}

void FaceFaceContacts::find(const ContactStepContext& context, std::size_t begin, std::size_t end,
                            std::vector<ContactPoint>& contact_points) {
  for (std::size_t row = begin; row < end; ++row) {
    const auto first = static_cast<std::uint32_t>(row);
    for (std::size_t k = candidates_.begin[row]; k < candidates_.begin[row + 1]; ++k) {
      const std::uint32_t second = candidates_.partners[k];
      const std::uint32_t pair =
          context.rules.find(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface);
      const Candidate candidate{first, second, pair, k, context.rules.of_faces(pair, first, second)};
      find_one(context, candidate, contact_points);
      if (candidate.rule.acts_apart()) pull_one(context, candidate, contact_points);
    }
  }
}

void FaceFaceContacts::find_one(const ContactStepContext& context, const Candidate& candidate,
                                std::vector<ContactPoint>& contact_points) {
  const FaceBound &a = context.kinematics.bound(candidate.first),
                  &b = context.kinematics.bound(candidate.second);
  const double closing = above_zero((b.velocity() - a.velocity()).dot(b.normal()));
  const double closed = closing * context.dt, activation_distance = closing * context.ahead();
  const PairRule& rule = candidate.rule;
  if (rule.is_balanced != context.balances) return;
  const bool did_touch = touched_[candidate.position] != 0;
  touched_[candidate.position] = 0;
  const double margin = context.balances ? closed_share * thinner(candidate) : 0.0;
  if (!may_touch(a, b, std::max(activation_distance, margin)) || !context.enforces(rule) ||
      rule.law == ContactLaw::tied)
    return;
  if (rule.law != ContactLaw::sliding && context.constrained.holds_faces(candidate.first, candidate.second))
    return;

  PairPenalty penalty =
      make_pair_penalty(contact_mesh_.faces[candidate.first].penalty_properties,
                        &contact_mesh_.faces[candidate.second].penalty_properties, *rule.pair);
  // What came in by itself may be as deep as its speed brought it; what has touched has no depth at which it
  // ends; what slides on from another partner may be as deep as it was there.
  const double before = depth_before(candidate);
  penalty.depth = did_touch      ? std::numeric_limits<double>::infinity()
                  : before > 0.0 ? std::max(penalty.depth, depth_of_known(0.0, before, closed))
                                 : std::max(penalty.depth, 1.5 * closed);
  const MovingFace first = context.kinematics.face(candidate.first),
                   second = context.kinematics.face(candidate.second);
  if (context.balances) {
    const double depth = penalty.depth + 1.5 * closing * context.coming_dt;
    return find_constraints(
        context, candidate, first, second,
        {context.coming_dt, margin, activation_distance, depth, flat_share * thinner(candidate)}, did_touch,
        contact_points);
  }
  penalty.closing = closed;
  find_penalty(context, candidate, {first, second, penalty, activation_distance, did_touch}, contact_points);
}

void FaceFaceContacts::find_penalty(const ContactStepContext& context, const Candidate& candidate,
                                    const PenaltyPush& push, std::vector<ContactPoint>& contact_points) {
  const std::size_t n_before = contact_points.size();
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
        add_penalty(context, candidate, push, contact, contact_points);
      }
    }
  } else {
    const auto contact =
        find_face_face_contact(push.first, push.second, push.penalty, push.activation_distance);
    add_penalty(context, candidate, push, contact, contact_points);
  }
  if (!(candidate.rule.friction > 0.0)) return;
  // Facets share the slip that is held: the mean by area.
  double area = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ContactPoint& contact_point : std::span(contact_points).subspan(n_before)) {
    if (!contact_point.touches()) continue;
    area += contact_point.area;
    mean += contact_point.area / area * (contact_point.elastic_slip - mean);
  }
  if (area > 0.0) elastic_slips_[candidate.position] = mean;
}

void FaceFaceContacts::add_penalty(const ContactStepContext& context, const Candidate& candidate,
                                   const PenaltyPush& push, const FaceFaceContact& contact,
                                   std::vector<ContactPoint>& contact_points) {
  if (!contact.overlaps) return;
  const Eigen::Vector3d apart =
      velocity_at(push.first, contact.weights_1) - velocity_at(push.second, contact.weights_2);
  if (contact.force > 0.0 && !push.did_touch) {
    const double closed = -apart.dot(contact.normal) * context.dt;
    if (!met_in_front(context, candidate, contact, closed)) return;
    if (is_at_flush_rim(context, candidate.first, candidate.second, contact)) return;
  }
  ContactPoint& contact_point = contact_points.emplace_back(make_contact_point(candidate, contact));
  contact_point.damped = contact.damped_power * context.dt;
  if (!contact_point.touches()) return;
  touched_[candidate.position] = 1;
  const PairRule& rule = candidate.rule;
  if (!(rule.friction > 0.0)) return;
  contact_point.slip = apart * context.dt;
  contact_point.elastic_slip = push.did_touch ? elastic_slips_[candidate.position] : mean_slip(candidate);
  add_friction(push.penalty.stiffness * contact.area, rule.slip_limit(contact_point, context.dt),
               contact_point);
}

double FaceFaceContacts::thinner(const Candidate& candidate) const {
  return std::min(contact_mesh_.faces[candidate.first].penalty_properties.thickness,
                  contact_mesh_.faces[candidate.second].penalty_properties.thickness);
}

void FaceFaceContacts::find_constraints(const ContactStepContext& context, const Candidate& candidate,
                                        const MovingFace& first, const MovingFace& second,
                                        const ConstraintActivation& activation, bool did_touch,
                                        std::vector<ContactPoint>& contact_points) {
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
    ContactPoint& contact_point = contact_points.emplace_back(make_contact_point(candidate, contact));
    contact_point.stiffness = 0.0;
    contact_point.is_balanced = true;
    contact_point.part = point.part;
    contact_point.closing = closing;
    if (contact_point.is_met()) touched_[candidate.position] = 1;
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

void FaceFaceContacts::pull_one(const ContactStepContext& context, const Candidate& candidate,
                                std::vector<ContactPoint>& contact_points) {
  const PairRule& rule = candidate.rule;
  const ContactFace &first = contact_mesh_.faces[candidate.first],
                    &second = contact_mesh_.faces[candidate.second];
  const FaceBound &a = context.kinematics.bound(candidate.first),
                  &b = context.kinematics.bound(candidate.second);
  ContactPoint contact_point;
  if (has_friction_) contact_point.elastic_slip = elastic_slips_[candidate.position];
  const auto feels = [&] {
    if (!context.enforces(rule) || !may_touch(a, b, rule.activation_distance)) return false;
    const FacePenaltyInput push{
        context.kinematics.last_face(candidate.first), context.kinematics.last_face(candidate.second),
        make_pair_penalty(first.penalty_properties, &second.penalty_properties, *rule.pair), context.dt};
    return add_face_traction(*rule.interface_law, push, contact_point);
  };
  const bool is_held = feels();
  // A junction's spring is its own: what only touches has none.
  if (rule.interface_law->rate_limit)
    elastic_slips_[candidate.position] = is_held ? contact_point.elastic_slip : Eigen::Vector3d::Zero();
  if (!is_held) return;
  contact_point.pair = candidate.pair;
  contact_point.is_swapped = first.surface != rule.pair->first;
  contact_point.first_entity = candidate.first;
  contact_point.second_entity = candidate.second;
  contact_point.first.nodes = first.corners;
  contact_point.second.nodes = second.corners;
  contact_points.push_back(contact_point);
}

bool FaceFaceContacts::met_in_front(const ContactStepContext& context, const Candidate& candidate,
                                    const FaceFaceContact& contact, double closed) const {
  // Before the first step nobody knows: what is wider than deep is pushed out.
  if (context.dt == 0.0) return contact.gap * contact.gap <= contact.area;
  const double thickness = thinner(candidate);
  if (contact.gap + closed > -shallow_depth * thickness) return true;
  // One that slides on from another partner may be about as deep as it was there, but not behind a far wall.
  const double before = depth_before(candidate);
  return before > 0.0 && -contact.gap < depth_of_known(slide_depth * thickness, before, closed);
}

double FaceFaceContacts::depth_before(const Candidate& candidate) const {
  if (depth_before_.empty()) return 0.0;
  return std::max(depth_before_[candidate.first], depth_before_[candidate.second]);
}

void FaceFaceContacts::find_lost(const PairRules& rules, std::vector<LostContact>& lost) const {
  for (std::uint32_t face = 0; face < partner_before_.size(); ++face) {
    const std::uint32_t partner = partner_before_[face];
    if (partner == no_partner || partner < face) continue;
    const bool is_over = partner_now_[face] == no_partner && partner_now_[partner] == no_partner;
    if (!is_over) continue;
    const ContactFace &a = contact_mesh_.faces[face], &b = contact_mesh_.faces[partner];
    const double depth = depth_before_[face];
    if (depth < deep_share * std::min(a.penalty_properties.thickness, b.penalty_properties.thickness))
      continue;
    lost.push_back({rules.find(a.surface, b.surface), a.corners[0], depth});
  }
}

Eigen::Vector3d FaceFaceContacts::mean_slip(const Candidate& candidate) const {
  const Eigen::Vector4d &first = means_[candidate.first], &second = means_[candidate.second];
  if (first[3] > 0.0) return first.head<3>() / first[3];
  if (second[3] > 0.0) return -second.head<3>() / second[3];
  return Eigen::Vector3d::Zero();
}

}  // namespace contactsim
