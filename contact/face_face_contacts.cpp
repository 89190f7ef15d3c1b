// SPDX-License-Identifier: BSD-3-Clause
#include "contact/face_face_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/contact_place.hpp"
#include "contact/flush_rims.hpp"
#include "contact/friction.hpp"
#include "contact/gap_pull.hpp"
#include "contact/penalty.hpp"
#include "core/state_archive.hpp"

namespace contactsim {

namespace {

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
  carry(places.faces, places.n_faces_after, std::uint8_t{0}, was_pushed_);
  carry(places.faces, places.n_faces_after, std::uint8_t{0}, is_pushed_);
}

void FaceFaceContacts::begin_step() {
  std::swap(was_pushed_, is_pushed_);
  was_pushed_.resize(faces_.faces.size(), 0);
  is_pushed_.assign(faces_.faces.size(), 0);
  if (!has_friction_) return;
  std::swap(means_, next_means_);
  means_.resize(faces_.faces.size(), Eigen::Vector4d::Zero());
  next_means_.assign(faces_.faces.size(), Eigen::Vector4d::Zero());
}

void FaceFaceContacts::note(const ContactRecord& record) {
  if (!record.touches() || record.is_held_apart) return;
  is_pushed_[record.first_place] = is_pushed_[record.second_place] = 1;
  if (!has_friction_) return;
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
  saved.list("contact/faces/was_pushed", is_pushed_);
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
  const bool did_touch = touched_[candidate.place] != 0;
  if (!scene.is_frozen) touched_[candidate.place] = 0;
  if (!may_touch(a, b, reach) || !rule.is_active || rule.law == ContactLaw::tied) return;
  if (rule.law != ContactLaw::sliding && scene.glued.holds_faces(candidate.first, candidate.second)) return;

  PairPenalty penalty = make_pair_penalty(faces_.faces[candidate.first].backing,
                                          &faces_.faces[candidate.second].backing, *rule.pair);
  // What came in by itself may be as deep as its speed brought it, and stays known a bit deeper than that.
  penalty.depth = std::max((did_touch ? known_depth : 1.0) * penalty.depth, 1.5 * closed);
  const MovingFace first = scene.surface.face(candidate.first), second = scene.surface.face(candidate.second);
  const FaceFaceContact contact = find_face_face_contact(first, second, penalty, reach);
  if (!contact.overlaps) return;
  const Eigen::Vector3d apart =
      velocity_at(first, contact.weights_1) - velocity_at(second, contact.weights_2);
  if (contact.force > 0.0 && !did_touch &&
      !met_in_front(scene, candidate, contact, -apart.dot(contact.normal) * scene.dt))
    return;

  if (contact.force > 0.0 && is_at_flush_rim(scene, candidate.first, candidate.second, contact)) return;

  ContactRecord& record = records.emplace_back(make_record(candidate, contact));
  record.damped = contact.damped_power * scene.dt;
  if (!record.touches()) return;
  if (!scene.is_frozen) touched_[candidate.place] = 1;
  if (!(rule.friction > 0.0)) return;
  record.slip = apart * scene.dt;
  if (!did_touch && !scene.is_frozen) elastic_[candidate.place] = mean_slip(candidate);
  record.elastic = elastic_[candidate.place];
  add_friction(penalty.stiffness * contact.area, rule.slip_limit(record, scene.dt), scene.is_frozen, record);
  if (!scene.is_frozen) elastic_[candidate.place] = record.elastic;
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
    if (!rule.is_active || !may_touch(a, b, rule.reach)) return false;
    const FacePush push{scene.surface.face(candidate.first), scene.surface.face(candidate.second),
                        make_pair_penalty(first.backing, &second.backing, *rule.pair), scene.dt};
    return pull_faces(*rule.place, push, scene.is_frozen, record);
  };
  const bool is_held = feels();
  // A junction's spring is its own: what only touches has none.
  if (rule.place->rate_limit && !scene.is_frozen)
    elastic_[candidate.place] = is_held ? record.elastic : Eigen::Vector3d::Zero();
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
  const double thickness = std::min(faces_.faces[candidate.first].backing.thickness,
                                    faces_.faces[candidate.second].backing.thickness);
  return contact.gap + closed > -shallow_depth * thickness || was_pushed_[candidate.first] != 0 ||
         was_pushed_[candidate.second] != 0;
}

Eigen::Vector3d FaceFaceContacts::mean_slip(const Candidate& candidate) const {
  const Eigen::Vector4d &first = means_[candidate.first], &second = means_[candidate.second];
  if (first[3] > 0.0) return first.head<3>() / first[3];
  if (second[3] > 0.0) return -second.head<3>() / second[3];
  return Eigen::Vector3d::Zero();
}

}  // namespace contactsim
