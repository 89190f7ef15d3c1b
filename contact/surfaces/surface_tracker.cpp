// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_tracker.hpp"

#include <algorithm>

#include "contact/surfaces/sort_once.hpp"
#include "contact/surfaces/surface_warnings.hpp"
#include "core/mesh/skin_change.hpp"

namespace contactsim {

SurfaceTracker::SurfaceTracker(OwnershipRules rules, const FaceGroups& faces,
                               std::vector<std::uint8_t> erodes)
    : rules_(std::move(rules)),
      faces_(faces),
      alive_(faces.mesh().n_elements(), 1),
      present_(rules_.find_present()),
      erodes_(std::move(erodes)) {}

bool SurfaceTracker::is_lofted(ElementIndex element) const {
  const Mesh& mesh = faces_.mesh();
  return contactsim::is_lofted(mesh.blocks()[mesh.block_of(element)]);
}

/// Faces of solids: those of the dead go, those that the dead covered are exterior from now on.
void SurfaceTracker::change_faces(std::span<const ElementIndex> dead, SurfaceEdits& edits,
                                  ContactSurfaces& surfaces) const {
  const SkinChange skin = find_skin_change(faces_, present_, dead);
  for (const ElementSide face : skin.removed) edits.change_face(face, rules_.of_face(face, true), {});
  for (const ElementSide face : skin.exposed)
    edits.change_face(face, rules_.of_face(face, false), rules_.of_face(face, true));
  for (const ElementIndex element : dead) {
    if (is_lofted(element)) continue;
    for (const ElementSide side : rules_.sides_of(element)) {
      if (std::ranges::binary_search(skin.removed, side)) continue;
      edits.change_face(side, rules_.of_face(side, false), {});
    }
  }
  for (std::uint32_t block = 0; block < skin.in_between.size(); ++block) {
    if (rules_.is_of_block_form(block))
      surfaces.interior_faces_ignored += static_cast<std::uint32_t>(skin.in_between[block]);
  }
}

void SurfaceTracker::remove_lofted(ElementIndex element, SurfaceEdits& edits) const {
  const LoftedClaim claim = rules_.of_lofted(element);
  edits.change_lofted(element, claim.body, {});
  for (std::size_t i = 0; i < claim.sides.size(); ++i)
    edits.change_face(claim.sides[i], claim.of_sides[i], {});
}

bool SurfaceTracker::has_eroded(NodeIndex node) const {
  return !erodes_.empty() && std::ranges::all_of(faces_.elements().of(node), [&](ElementIndex element) {
    return alive_[element.value] == 0 && erodes_[element.value] != 0;
  });
}

/// The nodes of dead elements, ascending; none when no surface of nodes asks for them.
std::vector<NodeIndex> SurfaceTracker::nodes_of(std::span<const ElementIndex> dead) const {
  std::vector<NodeIndex> nodes;
  if (!rules_.nodes().has_requests()) return nodes;
  for (const ElementIndex element : dead) {
    const auto own = faces_.mesh().element_nodes(element);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  sort_once(nodes);
  return nodes;
}

Claim SurfaceTracker::claim_of(NodeIndex node) const {
  return rules_.nodes().of_node(node, faces_.elements().of(node), alive_);
}

SurfaceChanges SurfaceTracker::update_for_deaths(std::span<const ElementIndex> dead,
                                                 ContactSurfaces& surfaces) {
  SurfaceEdits edits(surfaces.surfaces.size());
  change_faces(dead, edits, surfaces);
  for (const ElementIndex element : dead) {
    if (is_lofted(element)) remove_lofted(element, edits);
  }
  const std::vector<NodeIndex> nodes = nodes_of(dead);
  std::vector<Claim> before;
  for (const NodeIndex node : nodes) before.push_back(claim_of(node));
  for (const ElementIndex element : dead) alive_[element.value] = present_[element.value] = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    edits.change_node(nodes[i], before[i], has_eroded(nodes[i]) ? Claim{} : claim_of(nodes[i]));
  SurfaceChanges changes = edits.apply(surfaces);
  set_surface_warnings(rules_.requests(), faces_.mesh(), surfaces);
  return changes;
}

}  // namespace contactsim
