// SPDX-License-Identifier: BSD-3-Clause
// The contact points of two faces that the elastic penalty parts, and their friction.
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/geometry/facets.hpp"
#include "contact/interface_laws/friction.hpp"

namespace contactsim {

template <class Visit>
void FaceFaceContacts::visit_flat(const Candidate& candidate, const PenaltyPush& push,
                                  const Visit& visit) const {
  const MeetingFaces& faces = push.faces;
  const double flat = flat_share * thinner(candidate);
  const bool is_split = (is_warped(faces.first, flat) || is_warped(faces.second, flat)) &&
                        !is_contact_uncut(faces.first, faces.second, push.penalty, push.activation_distance);
  if (!is_split) return visit(Facet{faces.first}, Facet{faces.second});
  const Facets facets_1(faces.first, flat), facets_2(faces.second, flat);
  for (const Facet& a : facets_1.all()) {
    for (const Facet& b : facets_2.all()) visit(a, b);
  }
}

void FaceFaceContacts::add_penalty_points(const ContactStepContext& context, const Candidate& candidate,
                                          const PenaltyPush& push, std::vector<ContactPoint>& points) const {
  visit_flat(candidate, push, [&](const Facet& a, const Facet& b) {
    FaceFaceContact contact = find_face_face_contact(a.face, b.face, push.penalty, push.activation_distance);
    contact.weights_1 = a.to_face(contact.weights_1);
    contact.weights_2 = b.to_face(contact.weights_2);
    add_penalty_point(context, candidate, push, contact, points);
  });
}

void FaceFaceContacts::add_penalty_point(const ContactStepContext& context, const Candidate& candidate,
                                         const PenaltyPush& push, const FaceFaceContact& contact,
                                         std::vector<ContactPoint>& points) const {
  if (!contact.overlaps) return;
  const Eigen::Vector3d apart =
      push.faces.first.velocity_at(contact.weights_1) - push.faces.second.velocity_at(contact.weights_2);
  if (contact.force > 0.0 && !push.faces.did_touch) {
    const double closed = -apart.dot(contact.normal) * context.dt;
    if (!met_in_front(context, candidate, contact, closed)) return;
    if (is_at_flush_rim(context, candidate.first, candidate.second, contact)) return;
  }
  ContactPoint& contact_point = points.emplace_back(make_contact_point(candidate, contact));
  contact_point.damped = contact.damped_power * context.dt;
  add_friction_to(context, candidate, push, apart, contact_point);
}

void FaceFaceContacts::add_friction_to(const ContactStepContext& context, const Candidate& candidate,
                                       const PenaltyPush& push, const Eigen::Vector3d& apart,
                                       ContactPoint& point) const {
  const PairRule& rule = candidate.rule;
  if (!point.touches() || !(rule.friction > 0.0)) return;
  point.slip = apart * context.dt;
  point.elastic_slip = push.faces.did_touch ? history_.elastic_slip(candidate.position)
                                            : history_.mean_slip(candidate.first, candidate.second);
  add_friction(push.penalty.stiffness * point.area, rule.slip_limit(point, context.dt), point);
}

}  // namespace contactsim
