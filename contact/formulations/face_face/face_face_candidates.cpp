// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/start_gaps.hpp"

namespace contactsim {

namespace {

/// The largest distance along the normal at which faces of any pair have to do with each other while nothing
/// moves, but for what is taken off their gaps [length].
double widest_reach(const ContactMesh& contact_mesh, const PairRules& rules) {
  double thickest = 0.0;
  for (const ContactFace& face : contact_mesh.faces)
    thickest = std::max(thickest, face.penalty_properties.thickness);
  double widest = closed_share * thickest;
  for (const PairIndex pair : indices(rules.rules()))
    widest = std::max({widest, rules[pair].pair->held_gap(thickest), rules.max_activation_distance(pair)});
  return widest;
}

}  // namespace

FaceFaceContacts::FaceFaceContacts(const FormulationSetup& setup)
    : contact_mesh_(setup.contact_mesh),
      rules_(setup.rules),
      history_(setup.rules.has_friction(), setup.rules.may_hold()),
      widest_reach_(widest_reach(contact_mesh_, rules_)) {}

void FaceFaceContacts::find_candidates(ContactSearch& search, const ContactKinematics& kinematics,
                                       const Motion& motion) {
  FacePairLists next;
  search.find_face_pairs(kinematics, motion, depths(), next);
  if (search.keeps_first_partners() && search.n_searches() == 0) {
    start_partners_.begin_faces(kinematics, rules_, next);
    next = start_partners_.restricted(rules_, contact_mesh_, next);
    search.keep_face_partners(next);
  }
  take_candidates(start_partners_.empty() ? std::move(next) : start_partners_.united_with(rules_, next));
}

void FaceFaceContacts::take_candidates(FacePairLists candidates) {
  history_.transfer(candidates_, candidates);
  candidates_ = std::move(candidates);
  close_.forget();
}

void FaceFaceContacts::watch(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const {
  for (const FaceIndex row : candidates_.rows()) {
    if (!candidates_.of(row).empty()) is_watched[row] = 1;
    for (const FaceIndex partner : candidates_.of(row)) is_watched[partner] = 1;
  }
}

void FaceFaceContacts::watch_close(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const {
  if (!start_partners_.empty()) return watch(is_watched);
  close_.visit_close([&](FaceIndex first, std::size_t position) {
    is_watched[first] = is_watched[candidates_.partner(position)] = 1;
  });
}

void FaceFaceContacts::mark_close(const ContactStepContext& context, double size_share,
                                  PairRules& rules) const {
  for (const NearPair& near : find_near_pairs(context, candidates_, {}, size_share, is_hybrid)) {
    const MovingFace first = context.kinematics.face(near.first_face()),
                     second = context.kinematics.face(near.second);
    if (!find_mean_overlap(first, second, near.tolerance)) continue;
    rules.mark_close_face(near.pair, near.first_face());
    rules.mark_close_face(near.pair, near.second);
  }
}

void FaceFaceContacts::add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const {
  for (const FaceIndex first : candidates_.rows()) {
    for (const FaceIndex second : candidates_.of(first)) {
      const PairIndex pair =
          *context.rules.find(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface);
      if (!context.rules.gap_offsets().needs_start(pair)) continue;
      auto gap = find_start_gap(context.kinematics, *context.rules[pair].pair, first, second);
      if (!gap) continue;
      gap->pair = pair;
      for (const FaceIndex face : {first, second}) {
        gap->entity = face.value;
        gaps.faces.push_back(*gap);
      }
    }
  }
}

void FaceFaceContacts::remap(const ContactRemap& remap) {
  std::vector<std::size_t> before;
  candidates_ = transferred(candidates_, remap.faces, remap.faces, remap.n_faces_after, before);
  history_.remap(remap, before);
  close_.forget();
  widest_reach_ = widest_reach(contact_mesh_, rules_);
  released_ = start_partners_.remap(remap.faces, remap.faces, remap.n_faces_after);
}

void FaceFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/face_pairs", candidates_, saved);
  close_.forget();
  history_.archive(saved);
  start_partners_.archive("contact/start_faces", saved);
}

FaceFaceContacts::Candidate FaceFaceContacts::make_candidate(const ContactStepContext& context,
                                                             FaceIndex first, std::size_t position) const {
  const FaceIndex second = candidates_.partner(position);
  const PairIndex pair =
      *context.rules.find(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface);
  Candidate candidate{first, second, pair, position, context.rules.of_faces(pair, first, second)};
  if (start_partners_.empty()) return candidate;
  if (const auto carry = start_partners_.find_carry(context.kinematics, first, second))
    candidate.carry = *carry;
  return candidate;
}

}  // namespace contactsim
