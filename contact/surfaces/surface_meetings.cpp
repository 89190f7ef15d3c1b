// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_meetings.hpp"

#include <algorithm>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

/// Adds every pair among listed surfaces; of a list of one name it with itself.
///   positions  of those that there are
template <class Add>
void add_among(const std::vector<DeckName>& names, const std::vector<SurfaceIndex>& positions,
               const Add& add) {
  if (names.size() == 1 && positions.size() == 1) add(Meeting{positions[0], positions[0]});
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (std::size_t j = i + 1; j < positions.size(); ++j) add(Meeting{positions[i], positions[j]});
  }
}

}  // namespace

SurfaceMeetings::SurfaceMeetings(const SurfaceList& surfaces) : surfaces_(surfaces) {
  for (const ContactSurface& surface : surfaces) {
    const bool has_faces =
        !surface.faces.empty() || !surface.lofted_elements.empty() || surface.may_gain_faces;
    positions_.try_emplace(fold(surface.name), parts_.next());
    parts_.push_back({has_faces, !surface.nodes.empty(), !surface.analytic_planes.empty()});
  }
}

std::vector<SurfaceIndex> SurfaceMeetings::positions_of(const std::vector<DeckName>& names) const {
  std::vector<SurfaceIndex> positions;
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
    if (meeting.has_sides && pair.first != pair.second) pair.sides[1] = ShellSides::both;
    if (pair.is_one_sided || pair.first <= pair.second) return;
    std::swap(pair.first, pair.second);
    std::swap(pair.sides[0], pair.sides[1]);
    return;
  }
  pair.formulation = ConstraintFormulation::node_face;
  pair.is_one_sided = true;
  if (!can_meet_one_way(parts_[pair.first], parts_[pair.second])) std::swap(pair.first, pair.second);
  pair.side_b = pair.second;
}

bool SurfaceMeetings::is_all(const DeckName& name) const {
  return fold(name.text) == "all" && !positions_.contains("all");
}

std::vector<SurfaceIndex> SurfaceMeetings::positions_with_all(const std::vector<DeckName>& names) const {
  std::vector<SurfaceIndex> positions = positions_of(names);
  if (std::ranges::none_of(names, [&](const DeckName& name) { return is_all(name); })) return positions;
  const auto all = indices(surfaces_);
  return {all.begin(), all.end()};
}

std::map<PairKey, Meeting> SurfaceMeetings::meetings_of(const Interaction& interaction) const {
  std::map<PairKey, Meeting> meetings;
  const auto add = [&](const Meeting& meeting) {
    const PairKey key = std::minmax(meeting.first, meeting.second);
    const auto [known, is_new] = meetings.try_emplace(key, meeting);
    const bool is_turned = !is_new && known->second.first != meeting.first;
    if (is_turned) known->second.has_sides = false;
  };
  const bool excludes = interaction.pair.behavior == InteractionBehavior::no_interaction;
  const auto named_a = positions_of(interaction.side_a), named_b = positions_of(interaction.side_b);
  const auto is_named_twice = [&](SurfaceIndex i) {
    return std::ranges::count(named_a, i) > 0 && std::ranges::count(named_b, i) > 0;
  };
  for (const SurfaceIndex a : positions_with_all(interaction.side_a)) {
    for (const SurfaceIndex b : positions_with_all(interaction.side_b)) {
      if (a != b || excludes || is_named_twice(a)) add({a, b, true});
    }
  }
  add_among(interaction.surfaces, positions_of(interaction.surfaces), add);
  return meetings;
}

std::map<PairKey, Meeting> SurfaceMeetings::meetings_of(const SurfaceExclusion& exclusion) const {
  std::map<PairKey, Meeting> meetings;
  const auto add = [&](const Meeting& meeting) {
    meetings.try_emplace(std::minmax(meeting.first, meeting.second), meeting);
  };
  const auto named = positions_of(exclusion.surfaces);
  if (std::ranges::none_of(exclusion.surfaces, [&](const DeckName& name) { return is_all(name); })) {
    add_among(exclusion.surfaces, named, add);
    return meetings;
  }
  const auto all = positions_with_all(exclusion.surfaces);
  for (const SurfaceIndex a : named.empty() ? all : named) {
    for (const SurfaceIndex b : all) add({a, b});
  }
  return meetings;
}

}  // namespace contactsim
