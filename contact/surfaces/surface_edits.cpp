// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_edits.hpp"

#include <algorithm>
#include <iterator>

namespace contactsim {

namespace {

template <class T>
void sort_if_needed(std::vector<T>& list) {
  if (!std::ranges::is_sorted(list)) std::ranges::sort(list);
}

/// Takes items out of an ascending list and puts others in.
template <class T>
void edit_list(std::vector<T>& lost, std::vector<T>& gained, std::vector<T>& list) {
  if (lost.empty() && gained.empty()) return;
  sort_if_needed(lost);
  sort_if_needed(gained);
  if (list.empty()) {
    list = std::move(gained);
    return;
  }
  std::vector<T> kept, all;
  kept.reserve(list.size());
  std::ranges::set_difference(list, lost, std::back_inserter(kept));
  all.reserve(kept.size() + gained.size());
  std::ranges::merge(kept, gained, std::back_inserter(all));
  list = std::move(all);
}

template <class T>
std::uint32_t size_of(const std::vector<T>& list) {
  return static_cast<std::uint32_t>(list.size());
}

}  // namespace

template <class T>
void SurfaceEdits::change(T item, const Claim& before, const Claim& after, Edit<T> Edits::*edit,
                          std::uint32_t LostClaims::*count) {
  for (const Claim::Lost& lost : before.lost) --(lost_[{lost.loser, lost.winner}].*count);
  for (const Claim::Lost& lost : after.lost) ++(lost_[{lost.loser, lost.winner}].*count);
  if (before.owner == after.owner) return;
  if (before.owner) (edits_[*before.owner].*edit).lost.push_back(item);
  if (after.owner) (edits_[*after.owner].*edit).gained.push_back(item);
}

void SurfaceEdits::change_face(ElementSide face, const Claim& before, const Claim& after) {
  change(face, before, after, &Edits::faces, &LostClaims::faces);
}

void SurfaceEdits::change_lofted(ElementIndex element, const Claim& before, const Claim& after) {
  change(element, before, after, &Edits::lofted, &LostClaims::lofted);
}

void SurfaceEdits::change_node(NodeIndex node, const Claim& before, const Claim& after) {
  change(node, before, after, &Edits::nodes, &LostClaims::nodes);
}

void SurfaceEdits::apply_lost_claims(ContactSurfaces& surfaces) const {
  for (const auto& [loser_and_winner, change] : lost_) {
    const auto& [loser, winner] = loser_and_winner;
    std::vector<LostClaims>& lost_to = surfaces.surfaces[loser].lost_to;
    auto lost = std::ranges::lower_bound(lost_to, winner, {}, &LostClaims::winner);
    if (lost == lost_to.end() || lost->winner != winner) lost = lost_to.insert(lost, {.winner = winner});
    lost->faces += change.faces;
    lost->lofted += change.lofted;
    lost->nodes += change.nodes;
    if (lost->faces + lost->lofted + lost->nodes == 0) lost_to.erase(lost);
  }
}

SurfaceChanges SurfaceEdits::apply(ContactSurfaces& surfaces) {
  SurfaceChanges changes;
  for (const SurfaceIndex s : indices(edits_)) {
    auto& [faces, lofted, nodes] = edits_[s];
    changes.push_back({size_of(faces.gained), size_of(faces.lost), size_of(lofted.lost),
                       size_of(nodes.gained), size_of(nodes.lost)});
    ContactSurface& surface = surfaces.surfaces[s];
    edit_list(faces.lost, faces.gained, surface.faces);
    edit_list(lofted.lost, lofted.gained, surface.lofted_elements);
    edit_list(nodes.lost, nodes.gained, surface.nodes);
  }
  apply_lost_claims(surfaces);
  return changes;
}

}  // namespace contactsim
