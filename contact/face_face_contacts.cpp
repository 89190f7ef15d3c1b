// SPDX-License-Identifier: BSD-3-Clause
#include "contact/face_face_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/contact_place.hpp"
#include "contact/facets.hpp"
#include "contact/flush_rims.hpp"
#include "contact/friction.hpp"
#include "contact/gap_pull.hpp"
#include "contact/penalty.hpp"
#include "core/state_archive.hpp"

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
  touched_ = carry_over<std::uint8_t>(candidates_, touched_, next_, 0);
  if (has_friction_)
    elastic_ = carry_over<Eigen::Vector3d>(candidates_, elastic_, next_, Eigen::Vector3d::Zero());
  candidates_ = std::exchange(next_, {});
}

void FaceFaceContacts::renumber(const ContactRenumbering& places) {
  std::vector<std::size_t> before;
  candidates_ = carried(candidates_, places.faces, places.faces, places.n_faces_after, before);
  std::vector<std::uint8_t> touched;
  std::vector<Eigen::Vector3d> elastic;
  for (const std::size_t old : before) {
    touched.push_back(touched_[old]);
    if (has_friction_) elastic.push_back(elastic_[old]);
  }
  touched_ = std::move(touched);
  elastic_ = std::move(elastic);
  const Eigen::Vector4d no_slip = Eigen::Vector4d::Zero();
  carry(places.faces, places.n_faces_after, no_slip, means_);
  carry(places.faces, places.n_faces_after, no_slip, next_means_);
  carry(places.faces, places.n_faces_after, 0.0f, depth_before_);
  carry(places.faces, places.n_faces_after, 0.0f, depth_now_);
  // Contacts that deaths end are not lost.
  for (std::vector<std::uint32_t>* partners : {&partner_before_, &partner_now_})
    partners->assign(depth_now_.size(), no_partner);
}

void FaceFaceContacts::begin_step() {
  std::swap(depth_before_, depth_now_);
  std::swap(partner_before_, partner_now_);
  depth_before_.resize(faces_.faces.size(), 0.0f);
  partner_before_.resize(faces_.faces.size(), no_partner);
  depth_now_.assign(faces_.faces.size(), 0.0f);
  partner_now_.assign(faces_.faces.size(), no_partner);
  if (!has_friction_) return;
  std::swap(means_, next_means_);
  means_.resize(faces_.faces.size(), Eigen::Vector4d::Zero());
  next_means_.assign(faces_.faces.size(), Eigen::Vector4d::Zero());
}

void FaceFaceContacts::note(const ContactRecord& record) {
  if (!record.is_met() || record.is_held_apart) return;
  const auto deepen = [&](std::uint32_t face, std::uint32_t partner) {
    const float depth = std::max(static_cast<float>(-record.gap), std::numeric_limits<float>::min());
    if (!(depth > depth_now_[face])) return;
    depth_now_[face] = depth;
    partner_now_[face] = partner;
  };
  deepen(record.first_place, record.second_place);
  deepen(record.second_place, record.first_place);
  if (!has_friction_ || record.is_balanced) return;
  Eigen::Vector4d share;
  share << record.area * record.elastic, 0.0;
  const Eigen::Vector4d area(0.0, 0.0, 0.0, record.area);
  next_means_[record.first_place] += share + area;
  next_means_[record.second_place] += area - share;
}

void FaceFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/face_pairs", candidates_, saved);
  saved.list("contact/face_pairs/touched", touched_);
  saved.list("contact/face_pairs/elastic_slip", elastic_);
  // What is known of faces between steps; begin_step() makes it that of the last one.
  saved.list("contact/faces/mean_slip", next_means_);
  saved.list("contact/faces/depth", depth_now_);
  saved.list("contact/faces/partner", partner_now_);
}

void FaceFaceContacts::find(const ContactScene& scene, std::size_t begin, std::size_t end,
                            std::vector<ContactRecord>& records) {
  for (std::size_t row = begin; row < end; ++row) {
    const auto first = static_cast<std::uint32_t>(row);
    for (std::size_t k = candidates_.begin[row]; k < candidates_.begin[row + 1]; ++k) {
      const std::uint32_t second = candidates_.partners[k];
      const std::uint32_t pair = scene.rules.find(faces_.faces[first].surface, faces_.faces[second].surface);
      const Candidate candidate{first, second, pair, k, scene.rules.of_faces(pair, first, second)};
      find_one(scene, candidate, records);
      if (candidate.rule.acts_apart()) pull_one(scene, candidate, records);
    }
  }
}

void FaceFaceContacts::find_one(const ContactScene& scene, const Candidate& candidate,
                                std::vector<ContactRecord>& records) {
  const FaceBound &a = scene.surface.bound(candidate.first), &b = scene.surface.bound(candidate.second);
  const double closing = above_zero((b.velocity() - a.velocity()).dot(b.normal()));
  const double closed = closing * scene.dt, reach = closing * scene.ahead();
  const PairRule& rule = candidate.rule;
  if (rule.is_balanced != scene.balances) return;
  const bool did_touch = touched_[candidate.place] != 0;
  touched_[candidate.place] = 0;
  const double margin = scene.balances ? closed_share * thinner(candidate) : 0.0;
  if (!may_touch(a, b, std::max(reach, margin)) || !scene.looks_at(rule) || rule.law == ContactLaw::tied)
    return;
  if (rule.law != ContactLaw::sliding && scene.glued.holds_faces(candidate.first, candidate.second)) return;

  PairPenalty penalty = make_pair_penalty(faces_.faces[candidate.first].backing,
                                          &faces_.faces[candidate.second].backing, *rule.pair);
  // What came in by itself may be as deep as its speed brought it; what has touched has no depth at which it
  // ends; what slides on from another partner may be as deep as it was there.
  const double before = depth_before(candidate);
  penalty.depth = did_touch      ? std::numeric_limits<double>::infinity()
                  : before > 0.0 ? std::max(penalty.depth, depth_of_known(0.0, before, closed))
                                 : std::max(penalty.depth, 1.5 * closed);
  const MovingFace first = scene.surface.face(candidate.first), second = scene.surface.face(candidate.second);
  if (scene.balances) {
    const double depth = penalty.depth + 1.5 * closing * scene.coming_dt;
    return find_constraints(scene, candidate, first, second,
                            {scene.coming_dt, margin, reach, depth, flat_share * thinner(candidate)},
                            did_touch, records);
  }
  penalty.closing = closed;
  find_penalty(scene, candidate, {first, second, penalty, reach, did_touch}, records);
}

void FaceFaceContacts::find_penalty(const ContactScene& scene, const Candidate& candidate,
                                    const PenaltyPush& push, std::vector<ContactRecord>& records) {
  const std::size_t n_before = records.size();
  const double flat = flat_share * thinner(candidate);
  const bool is_split = (is_warped(push.first, flat) || is_warped(push.second, flat)) &&
                        !is_contact_uncut(push.first, push.second, push.penalty, push.reach);
  if (is_split) {
    const Facets facets_1(push.first, flat), facets_2(push.second, flat);
    for (const Facet& a : facets_1.all()) {
      for (const Facet& b : facets_2.all()) {
        FaceFaceContact contact = find_face_face_contact(a.face, b.face, push.penalty, push.reach);
        contact.weights_1 = a.to_face(contact.weights_1);
        contact.weights_2 = b.to_face(contact.weights_2);
        add_penalty(scene, candidate, push, contact, records);
      }
    }
  } else {
    const auto contact = find_face_face_contact(push.first, push.second, push.penalty, push.reach);
    add_penalty(scene, candidate, push, contact, records);
  }
  if (!(candidate.rule.friction > 0.0)) return;
  // Facets share the slip that is held: the mean by area.
  double area = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ContactRecord& record : std::span(records).subspan(n_before)) {
    if (!record.touches()) continue;
    area += record.area;
    mean += record.area / area * (record.elastic - mean);
  }
  if (area > 0.0) elastic_[candidate.place] = mean;
}

void FaceFaceContacts::add_penalty(const ContactScene& scene, const Candidate& candidate,
                                   const PenaltyPush& push, const FaceFaceContact& contact,
                                   std::vector<ContactRecord>& records) {
  if (!contact.overlaps) return;
  const Eigen::Vector3d apart =
      velocity_at(push.first, contact.weights_1) - velocity_at(push.second, contact.weights_2);
  if (contact.force > 0.0 && !push.did_touch) {
    const double closed = -apart.dot(contact.normal) * scene.dt;
    if (!met_in_front(scene, candidate, contact, closed)) return;
    if (is_at_flush_rim(scene, candidate.first, candidate.second, contact)) return;
  }
  ContactRecord& record = records.emplace_back(make_record(candidate, contact));
  record.damped = contact.damped_power * scene.dt;
  if (!record.touches()) return;
  touched_[candidate.place] = 1;
  const PairRule& rule = candidate.rule;
  if (!(rule.friction > 0.0)) return;
  record.slip = apart * scene.dt;
  record.elastic = push.did_touch ? elastic_[candidate.place] : mean_slip(candidate);
  add_friction(push.penalty.stiffness * contact.area, rule.slip_limit(record, scene.dt), record);
}

double FaceFaceContacts::thinner(const Candidate& candidate) const {
  return std::min(faces_.faces[candidate.first].backing.thickness,
                  faces_.faces[candidate.second].backing.thickness);
}

void FaceFaceContacts::find_constraints(const ContactScene& scene, const Candidate& candidate,
                                        const MovingFace& first, const MovingFace& second,
                                        const ConstraintReach& reach, bool did_touch,
                                        std::vector<ContactRecord>& records) {
  const FaceFaceConstraints found = find_face_face_constraints(first, second, reach);
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
    const double closing = -apart.dot(point.normal) * scene.coming_dt;
    if (!did_touch && contact.gap < 0.0 && !met_in_front(scene, candidate, contact, closing)) continue;
    if (contact.gap < closing && is_at_flush_rim(scene, candidate.first, candidate.second, contact)) continue;
    ContactRecord& record = records.emplace_back(make_record(candidate, contact));
    record.stiffness = 0.0;
    record.is_balanced = true;
    record.part = point.part;
    record.closing = closing;
    if (record.is_met()) touched_[candidate.place] = 1;
  }
}

ContactRecord FaceFaceContacts::make_record(const Candidate& candidate,
                                            const FaceFaceContact& contact) const {
  const ContactFace &first = faces_.faces[candidate.first], &second = faces_.faces[candidate.second];
  ContactRecord record;
  record.pair = candidate.pair;
  record.is_swapped = first.surface != candidate.rule.pair->first;
  record.first_place = candidate.first;
  record.second_place = candidate.second;
  record.first = {first.corners, contact.weights_1};
  record.second = {second.corners, contact.weights_2};
  record.normal = contact.normal;
  record.force = contact.force;
  record.area = contact.area;
  record.gap = contact.gap;
  record.deepest = contact.deepest;
  record.beyond_spring = contact.beyond_spring;
  record.stiffness = damped_stiffness(contact.stiffness, candidate.rule.pair->damping_fraction);
  return record;
}

void FaceFaceContacts::pull_one(const ContactScene& scene, const Candidate& candidate,
                                std::vector<ContactRecord>& records) {
  const PairRule& rule = candidate.rule;
  const ContactFace &first = faces_.faces[candidate.first], &second = faces_.faces[candidate.second];
  const FaceBound &a = scene.surface.bound(candidate.first), &b = scene.surface.bound(candidate.second);
  ContactRecord record;
  if (has_friction_) record.elastic = elastic_[candidate.place];
  const auto feels = [&] {
    if (!scene.looks_at(rule) || !may_touch(a, b, rule.reach)) return false;
    const FacePush push{scene.surface.last_face(candidate.first), scene.surface.last_face(candidate.second),
                        make_pair_penalty(first.backing, &second.backing, *rule.pair), scene.dt};
    return pull_faces(*rule.place, push, record);
  };
  const bool is_held = feels();
  // A junction's spring is its own: what only touches has none.
  if (rule.place->rate_limit) elastic_[candidate.place] = is_held ? record.elastic : Eigen::Vector3d::Zero();
  if (!is_held) return;
  record.pair = candidate.pair;
  record.is_swapped = first.surface != rule.pair->first;
  record.first_place = candidate.first;
  record.second_place = candidate.second;
  record.first.nodes = first.corners;
  record.second.nodes = second.corners;
  records.push_back(record);
}

bool FaceFaceContacts::met_in_front(const ContactScene& scene, const Candidate& candidate,
                                    const FaceFaceContact& contact, double closed) const {
  // Before the first step nobody knows: what is wider than deep is pushed out.
  if (scene.dt == 0.0) return contact.gap * contact.gap <= contact.area;
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
    const ContactFace &a = faces_.faces[face], &b = faces_.faces[partner];
    const double depth = depth_before_[face];
    if (depth < deep_share * std::min(a.backing.thickness, b.backing.thickness)) continue;
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
