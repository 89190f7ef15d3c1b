// SPDX-License-Identifier: BSD-3-Clause
// The contact points of two faces that momentum balance parts.
#include <array>

#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/flush_rims.hpp"

namespace contactsim {

void FaceFaceContacts::add_balanced_points(const ContactStepContext& context, Meetings& meetings,
                                           std::vector<ContactPoint>& points) const {
  meetings.constrained.clear();
  for (const auto& [candidate, faces, penalty, activation] : meetings.all)
    meetings.constrained.push_back({faces.first, faces.second, activation});
  std::array<FaceFaceConstraints, n_lanes> found;
  find_face_face_constraints(meetings.constrained, found);
  for (std::size_t i = 0; i < meetings.all.size(); ++i)
    add_balanced_points(context, meetings.all[i], found[i], points);
}

void FaceFaceContacts::add_balanced_points(const ContactStepContext& context, const Meeting& meeting,
                                           const FaceFaceConstraints& found,
                                           std::vector<ContactPoint>& points) const {
  const Candidate& candidate = meeting.candidate;
  const MeetingFaces& faces = meeting.faces;
  const double held = candidate.rule.pair->held_gap(thinner(candidate));
  FlushStrips flush_strips(context, candidate.first, candidate.second);
  for (const OverlapShare& share : found.all()) {
    const FaceFaceContact contact = contact_of(share, faces.first, faces.second);
    const Eigen::Vector3d apart =
        faces.first.velocity_at(share.weights_1) - faces.second.velocity_at(share.weights_2);
    const double closing = -apart.dot(share.normal) * context.coming_dt;
    ContactPoint point = make_contact_point(candidate, contact);
    point.stiffness = 0.0;
    point.is_balanced = true;
    point.part = share.part;
    point.closing = closing;
    point.pulls = held > 0.0 && contact.gap <= held && history_.is_held(point);
    if (!point.pulls) {
      if (!faces.did_touch && contact.gap < 0.0 && !met_in_front(context, candidate, contact, closing))
        continue;
      if (contact.gap < closing && flush_strips.hold(contact)) continue;
    }
    points.push_back(point);
  }
}

}  // namespace contactsim
