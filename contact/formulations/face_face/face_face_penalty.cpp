// SPDX-License-Identifier: BSD-3-Clause
// The contact points of two faces that the elastic penalty parts, and their friction.
#include <limits>

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
  const bool is_split =
      (is_warped(faces.first, flat) || is_warped(faces.second, flat)) &&
      !is_contact_uncut(faces.first, faces.second, push.penalty, push.activation_distance, faces.deeper);
  if (!is_split) return visit(Facet{faces.first}, Facet{faces.second}, faces.deeper);
  const Facets facets_1(faces.first, flat), facets_2(faces.second, flat);
  for (const Facet& a : facets_1.all()) {
    for (const Facet& b : facets_2.all())
      visit(a, b, CornerDepths{a.at_corners(faces.deeper.first), b.at_corners(faces.deeper.second)});
  }
}

void FaceFaceContacts::add_penalty_points(const ContactStepContext& context, const Candidate& candidate,
                                          const PenaltyPush& push, std::vector<ContactPoint>& points) const {
  visit_flat(candidate, push, [&](const Facet& a, const Facet& b, const CornerDepths& deeper) {
    FaceFaceContact contact =
        find_face_face_contact(a.face, b.face, push.penalty, push.activation_distance, deeper);
    contact.weights_1 = a.to_face(contact.weights_1);
    contact.weights_2 = b.to_face(contact.weights_2);
    add_penalty_point(context, candidate, push, contact, points);
  });
}

/// Over the part of two faces that touches, or of round ones over all that may.
CornerCoupling FaceFaceContacts::coupling_of(const ContactStepContext& context,
                                             const Candidate& candidate) const {
  const MeetingFaces faces = make_meeting_faces(context, candidate);
  const PairPenalty penalty = make_penalty(candidate, faces.did_touch, std::numeric_limits<double>::max());
  CornerCoupling coupling = CornerCoupling::Zero();
  visit_flat(candidate, {faces, penalty, 0.0},
             [&](const Facet& a, const Facet& b, const CornerDepths& deeper) {
               const CornerCoupling of_facets =
                   find_overlap_coupling(a.face, b.face, penalty.depth, deeper, faces.are_round());
               CornerCoupling to_faces = CornerCoupling::Zero();
               for (Eigen::Index k = 0; k < 4; ++k) {
                 to_faces.col(k).head<4>() = a.to_face(Eigen::Vector4d::Unit(k));
                 to_faces.col(4 + k).tail<4>() = b.to_face(Eigen::Vector4d::Unit(k));
               }
               coupling += to_faces * of_facets * to_faces.transpose();
             });
  return coupling;
}

void FaceFaceContacts::visit_couplings(const ContactStepContext& context,
                                       std::span<const ContactPoint> points, const TakeCoupling& take) const {
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const ContactPoint& first = points[begin];
    ContactPoint all = first;  // those of one pair of faces together
    all.area = all.stiffness = 0.0;
    for (; end < points.size() && points[end].first_entity == first.first_entity &&
           points[end].second_entity == first.second_entity;
         ++end) {
      all.area += points[end].area;
      all.stiffness += points[end].stiffness;
      if (points[end].force > all.force) {
        all.force = points[end].force;
        all.normal = points[end].normal;
      }
    }
    const std::size_t position = candidates_.position(first.first_face(), first.second_face());
    const CornerCoupling coupling =
        coupling_of(context, make_candidate(context, first.first_face(), position));
    // The sum of the first side's products is the area.
    const double area = coupling.topLeftCorner<4, 4>().sum();
    if (area > 0.0) take(all, all.area / area * coupling);
  }
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
  contact_point.begin_gap +=
      push.faces.deeper.first.dot(contact.weights_1) + push.faces.deeper.second.dot(contact.weights_2);
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
