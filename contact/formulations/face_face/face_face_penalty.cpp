// SPDX-License-Identifier: BSD-3-Clause
// The contact points of two faces that the elastic penalty parts, and their friction.
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/interface_laws/friction.hpp"

namespace contactsim {

void FaceFaceContacts::add_penalty_points(const ContactStepContext& context, Meetings& meetings,
                                          std::vector<ContactPoint>& points) const {
  meetings.pushed.clear();
  meetings.contacts.clear();
  for (const auto& [candidate, faces, penalty, activation] : meetings.all)
    meetings.pushed.push_back({faces.first, faces.second, penalty, activation.near, activation.flat});
  find_face_face_contacts(meetings.pushed, meetings.contacts);
  for (const auto& [pair, contact] : meetings.contacts)
    add_penalty_point(context, meetings.all[pair], contact, points);
}

void FaceFaceContacts::add_penalty_point(const ContactStepContext& context, const Meeting& meeting,
                                         const FaceFaceContact& contact,
                                         std::vector<ContactPoint>& points) const {
  if (!contact.overlaps) return;
  const Candidate& candidate = meeting.candidate;
  const MeetingFaces& faces = meeting.faces;
  const Eigen::Vector3d apart =
      faces.first.velocity_at(contact.weights_1) - faces.second.velocity_at(contact.weights_2);
  if (contact.force > 0.0 && !faces.did_touch) {
    const double closed = -apart.dot(contact.normal) * context.dt;
    if (!met_in_front(context, candidate, contact, closed)) return;
    if (FlushStrips(context, candidate.first, candidate.second).hold(contact)) return;
  }
  ContactPoint& contact_point = points.emplace_back(make_contact_point(candidate, contact));
  contact_point.damped = contact.damped_power * context.dt;
  add_friction_to(context, meeting, apart, contact_point);
}

void FaceFaceContacts::add_spring_points(const ContactStepContext& context, const Meeting& meeting,
                                         std::vector<ContactPoint>& points) const {
  const auto& [candidate, faces, penalty, activation] = meeting;
  const double held = candidate.rule.pair->held_gap(thinner(candidate));
  const double near = std::max(activation.near, held);
  const FaceFaceConstraints found = faces.find_constraints({0.0, near, near, penalty.depth, activation.flat});
  for (const OverlapShare& share : found.all()) {
    const FaceFaceContact contact = contact_of(share, faces.first, faces.second);
    const Eigen::Vector3d apart =
        faces.first.velocity_at(share.weights_1) - faces.second.velocity_at(share.weights_2);
    ContactPoint point = make_contact_point(candidate, contact);
    point.part = share.part;
    point.pulls = history_.is_held(point);
    if (contact.gap > (point.pulls ? held : activation.near)) continue;
    if (contact.gap < 0.0 && !faces.did_touch && !point.pulls) {
      if (!met_in_front(context, candidate, contact, -apart.dot(contact.normal) * context.dt)) continue;
      if (FlushStrips(context, candidate.first, candidate.second).hold(contact)) continue;
    }
    push_node({penalty, candidate.rule.pair->damping_fraction, contact.area, apart, context.dt, 0.0, apart,
               context.is_static},
              point);
    add_friction_to(context, meeting, apart, point);
    points.push_back(point);
  }
}

void FaceFaceContacts::add_friction_to(const ContactStepContext& context, const Meeting& meeting,
                                       const Eigen::Vector3d& apart, ContactPoint& point) const {
  const Candidate& candidate = meeting.candidate;
  const PairRule& rule = candidate.rule;
  if (!point.touches() || !(rule.friction > 0.0)) return;
  point.slip = apart * context.dt;
  point.elastic_slip = meeting.faces.did_touch ? history_.elastic_slip(candidate.position)
                                               : history_.mean_slip(candidate.first, candidate.second);
  add_friction(meeting.penalty.stiffness * point.area, rule.slip_limit(point, context.dt), point);
}

}  // namespace contactsim
