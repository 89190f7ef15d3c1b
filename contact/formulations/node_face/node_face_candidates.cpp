// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "contact/formulations/start_gaps.hpp"

namespace contactsim {

void NodeFaceContacts::find_candidates(ContactSearch& search, const ContactKinematics& kinematics,
                                       const Motion& motion) {
  search.find_node_faces(kinematics, motion, depths(), candidates_);
  close_.forget();
  if (search.keeps_first_partners() && search.n_searches() == 0)
    start_partners_.begin_nodes(kinematics, rules_, candidates_);
  if (!start_partners_.empty()) candidates_ = start_partners_.united_with(rules_, candidates_);
}

void NodeFaceContacts::watch_around(SurfaceNodeIndex row, FaceIndex face,
                                    IndexedVector<FaceIndex, std::uint8_t>& is_watched) const {
  for (const FaceIndex own : contact_mesh_.faces_of_node.of(contact_mesh_.surface_nodes[row].node))
    is_watched[own] = 1;
  is_watched[face] = 1;
  for (const ContactNodeIndex corner : contact_mesh_.faces[face].corners) {
    for (const FaceIndex neighbour : contact_mesh_.faces_of_node.of(corner)) is_watched[neighbour] = 1;
  }
}

void NodeFaceContacts::watch(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const {
  for (const SurfaceNodeIndex row : candidates_.rows()) {
    for (const FaceIndex face : candidates_.of(row)) watch_around(row, face, is_watched);
  }
}

void NodeFaceContacts::watch_close(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const {
  if (!leaves_out()) return watch(is_watched);
  close_.visit_close([&](SurfaceNodeIndex row, std::size_t position) {
    watch_around(row, candidates_.partner(position), is_watched);
  });
}

bool NodeFaceContacts::leaves_out() const {
  return start_partners_.empty() &&
         std::ranges::none_of(rules_.rules(), [](const PairRule& rule) { return rule.may_act_apart(); });
}

void NodeFaceContacts::mark_close(const ContactStepContext& context, double size_share,
                                  PairRules& rules) const {
  for (const NearPair& near : find_near_pairs(context, {}, candidates_, size_share, is_hybrid)) {
    // A rim is as near to the sides of the other body as to what it faces.
    if (near.is_facing) rules.mark_close_node(near.pair, near.row());
  }
}

void NodeFaceContacts::add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const {
  for (const SurfaceNodeIndex row : candidates_.rows()) {
    const auto gap = find_start_gap(context.kinematics, context.rules, row, candidates_.of(row));
    if (gap && context.rules.gap_offsets().needs_start(gap->pair)) gaps.nodes.push_back(*gap);
  }
}

void NodeFaceContacts::remap(const ContactRemap& remap) {
  std::vector<std::size_t> before;
  candidates_ = transferred(candidates_, remap.rows, remap.faces, remap.n_rows_after, before);
  close_.forget();
  history_.remap(remap);
  released_ = start_partners_.remap(remap.rows, remap.faces, remap.n_rows_after);
}

void NodeFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/node_pairs", candidates_, saved);
  close_.forget();
  history_.archive(saved);
  start_partners_.archive("contact/start_nodes", saved);
}

}  // namespace contactsim
