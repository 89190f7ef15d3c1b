// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "contact/surfaces/surface_edits.hpp"
#include "contact/surfaces/surface_warnings.hpp"
#include "core/definition/contact.hpp"
#include "core/mesh/node_elements.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim {

namespace {

/// What each request makes: a surface and its subsets, that own nothing yet.
SurfaceList make_surfaces(std::span<const SurfaceRequest> requests) {
  SurfaceList surfaces;
  for (const SurfaceRequest& request : requests) {
    ContactSurface made;
    made.kind = request.kind;
    made.command = request.command;
    made.may_gain_faces = request.kind == SurfaceKind::face && !request.blocks.empty();
    made.name = request.name;
    made.location = request.location;
    surfaces.push_back(made);
    surfaces.back().analytic_planes = request.analytic_planes;
    for (const SubsetRequest& subset : request.subsets) {
      made.name = subset.name;
      made.location = subset.location;
      surfaces.push_back(made);
    }
  }
  return surfaces;
}

/// Faces of solids: the skin, and what side sets hold besides.
void claim_faces(const OwnershipRules& rules, const Mesh& mesh, const Skin& skin, SurfaceEdits& edits) {
  for (const ElementSide face : skin.exterior) edits.change_face(face, {}, rules.of_face(face, true));
  std::vector<ElementSide> others;
  std::ranges::set_difference(rules.sides(), skin.exterior, std::back_inserter(others));
  for (const ElementSide side : others) {
    if (!is_lofted(mesh.blocks()[mesh.block_of(side.element())]))
      edits.change_face(side, {}, rules.of_face(side, false));
  }
}

void claim_lofted(const OwnershipRules& rules, const Mesh& mesh, SurfaceEdits& edits) {
  for (const ElementBlock& block : mesh.blocks()) {
    if (!is_lofted(block)) continue;
    for (std::uint32_t i = 0; i < block.n_elements; ++i) {
      const ElementIndex element{block.first_element.value + i};
      const LoftedClaim claim = rules.of_lofted(element);
      edits.change_lofted(element, {}, claim.body);
      for (std::size_t k = 0; k < claim.sides.size(); ++k)
        edits.change_face(claim.sides[k], {}, claim.of_sides[k]);
    }
  }
}

void claim_nodes(const NodeOwnershipRules& rules, const Mesh& mesh, SurfaceEdits& edits) {
  if (!rules.has_requests()) return;
  const std::vector<std::uint8_t> alive(mesh.n_elements(), 1);
  std::optional<NodeElements> elements;
  if (rules.needs_elements()) elements.emplace(mesh);
  for (const NodeIndex node : rules.find_claimed()) {
    const auto around = elements ? elements->of(node) : std::span<const ElementIndex>{};
    edits.change_node(node, {}, rules.of_node(node, around, alive));
  }
}

/// Faces between present blocks that the block forms would build from skins of single blocks.
std::uint32_t count_ignored_faces(const OwnershipRules& rules, const Skin& skin) {
  std::uint32_t n = 0;
  for (std::uint32_t block = 0; block < skin.in_between.size(); ++block) {
    if (rules.is_of_block_form(block)) n += skin.in_between[block];
  }
  return n;
}

}  // namespace

ContactSurfaces resolve_surfaces(const OwnershipRules& rules, const Mesh& mesh) {
  ContactSurfaces surfaces;
  surfaces.surfaces = make_surfaces(rules.requests());
  SurfaceEdits edits(surfaces.surfaces.size());
  {
    const Skin skin = make_skin(mesh, rules.find_present());
    surfaces.interior_faces_ignored = count_ignored_faces(rules, skin);
    claim_faces(rules, mesh, skin, edits);
  }
  claim_lofted(rules, mesh, edits);
  claim_nodes(rules.nodes(), mesh, edits);
  edits.apply(surfaces);
  set_surface_warnings(rules.requests(), mesh, surfaces);
  return surfaces;
}

ContactSurfaces resolve_surfaces(const ContactDefinition& contact, const RegionNames& names, const Mesh& mesh,
                                 Diagnostics& diagnostics) {
  const OwnershipRules rules(make_surface_requests(contact, names, mesh, diagnostics), mesh,
                             contact.subdomain);
  return resolve_surfaces(rules, mesh);
}

}  // namespace contactsim
