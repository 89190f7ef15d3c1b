// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_tracker.hpp"

#include <algorithm>
#include <iterator>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

namespace {

/// Takes items out of an ascending list and puts others in; returns whether there were any.
template <class T>
void edit(std::vector<T>& lost, std::vector<T>& gained, std::vector<T>& list) {
  if (lost.empty() && gained.empty()) return;
  std::ranges::sort(lost);
  std::ranges::sort(gained);
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

SurfaceTracker::SurfaceTracker(OwnershipRules rules, const FaceGroups& faces,
                               std::span<const std::uint8_t> alive, const ContactSurfaces& surfaces,
                               std::vector<std::uint8_t> erodes)
    : rules_(std::move(rules)),
      faces_(faces),
      alive_(alive.begin(), alive.end()),
      present_(find_present(rules_.requests(), faces.mesh(), ContactDomain(faces.mesh(), {}, alive))),
      erodes_(std::move(erodes)),
      dies_(faces.mesh().n_elements(), 0),
      edits_(surfaces.surfaces.size()) {
  alive_.resize(faces.mesh().n_elements(), 1);
  for (std::uint32_t loser = 0; loser < surfaces.surfaces.size(); ++loser) {
    for (const LostClaims& lost : surfaces.surfaces[loser].lost_to) lost_[{loser, lost.winner}] = lost;
  }
}

bool SurfaceTracker::is_solid(ElementIndex element) const {
  const Mesh& mesh = faces_.mesh();
  return topology(mesh.blocks()[mesh.block_of(element)].shape).family == Family::solid;
}

void SurfaceTracker::count(const Claim& claim, Kind kind, int by) {
  for (const Claim::Lost& lost : claim.lost) {
    LostClaims& claims = lost_[{lost.loser, lost.winner}];
    claims.winner = lost.winner;
    std::uint32_t& n =
        kind == Kind::face ? claims.faces : (kind == Kind::lofted ? claims.lofted : claims.nodes);
    n += static_cast<std::uint32_t>(by);
  }
}

void SurfaceTracker::change_face(ElementSide face, const Claim& before, const Claim& after) {
  count(before, Kind::face, -1);
  count(after, Kind::face, 1);
  if (before.owner == after.owner) return;
  if (before.owner != Claim::nobody) edits_[before.owner].lost.push_back(face);
  if (after.owner != Claim::nobody) edits_[after.owner].gained.push_back(face);
}

/// As Skin::in_between counts, of block forms.
std::uint32_t SurfaceTracker::count_in_between(std::span<const ElementSide> group, bool is_after) const {
  std::vector<ElementIndex> present;
  for (const ElementSide face : group) {
    if (is_present(face.element(), is_after)) present.push_back(face.element());
  }
  if (present.size() < 2) return 0;
  const auto block_of = [&](std::size_t i) { return faces_.mesh().block_of(present[i]); };
  std::uint32_t n = 0;
  for (std::size_t i = 0; i < present.size(); ++i) {
    const std::uint32_t block = block_of(i);
    const bool has_same =
        (i > 0 && block_of(i - 1) == block) || (i + 1 < present.size() && block_of(i + 1) == block);
    if (is_solid(present[i]) && !has_same && rules_.is_of_block_form(block)) ++n;
  }
  return n;
}

/// All faces with the same corners as one of a dying element. Each group is done once, for the first of its
/// elements that die.
void SurfaceTracker::update_group(ElementSide face, ContactSurfaces& surfaces) {
  faces_.find_group(face, group_);
  std::size_t n_before = 0, n_after = 0;
  for (const ElementSide other : group_) {
    if (dies_[other.element().value] != 0 && other < face) return;
    n_before += is_present(other.element(), false) ? 1 : 0;
    n_after += is_present(other.element(), true) ? 1 : 0;
  }
  surfaces.interior_faces_ignored += count_in_between(group_, true) - count_in_between(group_, false);
  for (const ElementSide other : group_) {
    const ElementIndex element = other.element();
    if (alive_[element.value] == 0 || !is_solid(element)) continue;
    const Claim before = rules_.of_face(other, is_present(element, false) && n_before == 1);
    const bool dies = dies_[element.value] != 0;
    change_face(other, before,
                dies ? Claim{} : rules_.of_face(other, is_present(element, true) && n_after == 1));
  }
}

/// Sides that are no faces to a skin: they have too few different nodes.
void SurfaceTracker::update_sides(ElementIndex element) {
  std::vector<ElementSide> own;
  faces_.find_faces(element, own);
  for (const ElementSide side : rules_.sides_of(element)) {
    if (std::ranges::find(own, side) == own.end()) change_face(side, rules_.of_face(side, false), {});
  }
}

void SurfaceTracker::update_lofted(ElementIndex element) {
  const LoftedClaim claim = rules_.of_lofted(element);
  count(claim.body, Kind::lofted, -1);
  if (claim.body.owner != Claim::nobody) edits_[claim.body.owner].lofted_lost.push_back(element);
  for (std::size_t i = 0; i < claim.sides.size(); ++i) change_face(claim.sides[i], claim.of_sides[i], {});
}

bool SurfaceTracker::has_eroded(NodeIndex node) const {
  return !erodes_.empty() && std::ranges::all_of(faces_.elements().of(node), [&](ElementIndex element) {
    return alive_[element.value] == 0 && erodes_[element.value] != 0;
  });
}

void SurfaceTracker::update_nodes(std::span<const ElementIndex> dead,
                                  std::span<const std::uint8_t> alive_before) {
  std::vector<NodeIndex> nodes;
  for (const ElementIndex element : dead) {
    const auto own = faces_.mesh().element_nodes(element);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  sort_once(nodes);
  for (const NodeIndex node : nodes) {
    const Claim before = rules_.of_node(node, faces_.elements(), alive_before);
    const Claim after = has_eroded(node) ? Claim{} : rules_.of_node(node, faces_.elements(), alive_);
    count(before, Kind::node, -1);
    count(after, Kind::node, 1);
    if (before.owner == after.owner) continue;
    if (before.owner != Claim::nobody) edits_[before.owner].nodes_lost.push_back(node);
    if (after.owner != Claim::nobody) edits_[after.owner].nodes_gained.push_back(node);
  }
}

std::vector<SurfaceChange> SurfaceTracker::apply(ContactSurfaces& surfaces) {
  std::vector<SurfaceChange> changes;
  for (std::size_t s = 0; s < edits_.size(); ++s) {
    Edit& made = edits_[s];
    changes.push_back({size_of(made.gained), size_of(made.lost), size_of(made.lofted_lost),
                       size_of(made.nodes_gained), size_of(made.nodes_lost)});
    ContactSurface& surface = surfaces.surfaces[s];
    std::vector<ElementIndex> none;
    edit(made.lost, made.gained, surface.faces);
    edit(made.lofted_lost, none, surface.lofted_elements);
    edit(made.nodes_lost, made.nodes_gained, surface.nodes);
    surface.lost_to.clear();
    made = {};
  }
  std::erase_if(lost_, [](const auto& entry) {
    return entry.second.faces + entry.second.lofted + entry.second.nodes == 0;
  });
  for (const auto& [places, claims] : lost_) surfaces.surfaces[places.first].lost_to.push_back(claims);
  set_surface_warnings(rules_.requests(), faces_.mesh(), surfaces);
  return changes;
}

std::vector<SurfaceChange> SurfaceTracker::update_for_deaths(std::span<const ElementIndex> dead,
                                                             ContactSurfaces& surfaces) {
  std::vector<std::uint8_t> before;
  if (rules_.has_node_requests()) before = alive_;
  for (const ElementIndex element : dead) dies_[element.value] = 1;
  std::vector<ElementSide> own;
  for (const ElementIndex element : dead) {
    faces_.find_faces(element, own);
    for (const ElementSide face : own) update_group(face, surfaces);
    is_solid(element) ? update_sides(element) : update_lofted(element);
  }
  for (const ElementIndex element : dead)
    alive_[element.value] = present_[element.value] = dies_[element.value] = 0;
  if (rules_.has_node_requests()) update_nodes(dead, before);
  return apply(surfaces);
}

}  // namespace contactsim
