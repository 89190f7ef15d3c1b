// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_meetings.hpp"

#include <algorithm>

#include "core/base/names.hpp"

namespace contactsim {

SurfaceMeetings::SurfaceMeetings(const std::vector<ContactSurface>& surfaces) : surfaces_(surfaces) {
  for (const ContactSurface& surface : surfaces) {
    const bool has_faces =
        !surface.faces.empty() || !surface.lofted_elements.empty() || surface.may_gain_faces;
    positions_.try_emplace(fold(surface.name), static_cast<std::uint32_t>(parts_.size()));
    parts_.push_back({has_faces, !surface.nodes.empty(), !surface.analytic_planes.empty()});
  }
}

std::vector<std::uint32_t> SurfaceMeetings::positions_of(const std::vector<DeckName>& names) const {
  std::vector<std::uint32_t> positions;
  for (const DeckName& name : names) {
    const auto found = positions_.find(fold(name.text));
    if (found != positions_.end()) positions.push_back(found->second);
  }
  return positions;
}

bool SurfaceMeetings::can_meet(const Meeting& meeting) const {
  const Parts &a = parts_[meeting.first], &b = parts_[meeting.second];
  return can_meet_one_way(a, b) || can_meet_one_way(b, a);
}

bool SurfaceMeetings::has_empty_side(const Meeting& meeting) const {
  return surfaces_[meeting.first].is_empty() || surfaces_[meeting.second].is_empty();
}

void SurfaceMeetings::settle(const Meeting& meeting, SurfacePair& pair) const {
  pair.first = meeting.first;
  pair.second = meeting.second;
  const bool has_faces = parts_[pair.first].faces && parts_[pair.second].faces;
  if (has_faces) {
    const bool is_node_face = pair.formulation == ConstraintFormulation::node_face;
    pair.is_one_sided = meeting.has_sides && is_node_face && pair.first != pair.second;
    if (meeting.has_sides && pair.first != pair.second) pair.side_b = pair.second;
    if (!pair.is_one_sided && pair.first > pair.second) std::swap(pair.first, pair.second);
    return;
  }
  pair.formulation = ConstraintFormulation::node_face;
  pair.is_one_sided = true;
  if (!can_meet_one_way(parts_[pair.first], parts_[pair.second])) std::swap(pair.first, pair.second);
  pair.side_b = pair.second;
}

std::map<PairKey, Meeting> SurfaceMeetings::meetings_of(const Interaction& interaction) const {
  std::map<PairKey, Meeting> meetings;
  const auto add = [&](const Meeting& meeting) {
    const PairKey key = std::minmax(meeting.first, meeting.second);
    const auto [known, is_new] = meetings.try_emplace(key, meeting);
    const bool is_turned = !is_new && known->second.first != meeting.first;
    if (is_turned) known->second.has_sides = false;
  };
  for (const std::uint32_t a : positions_of(interaction.side_a)) {
    for (const std::uint32_t b : positions_of(interaction.side_b)) add({a, b, true});
  }
  const auto listed = positions_of(interaction.surfaces);
  if (interaction.surfaces.size() == 1 && listed.size() == 1) add({listed[0], listed[0]});
  for (std::size_t i = 0; i < listed.size(); ++i) {
    for (std::size_t j = i + 1; j < listed.size(); ++j) add({listed[i], listed[j]});
  }
  return meetings;
}

}  // namespace contactsim
