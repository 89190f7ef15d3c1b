// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_model.hpp"

#include <algorithm>

#include "contact/lofting/loft_sizes.hpp"
#include "contact/lofting/section_sizes.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "contact/surfaces/resolve_surfaces.hpp"
#include "contact/surfaces/surface_names.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/name_lookup.hpp"

namespace contactsim {

namespace {

/// Every lofted element that a surface owns, ascending.
std::vector<OwnedElement> owned_elements(const SurfaceList& surfaces) {
  std::vector<OwnedElement> owned;
  for (const SurfaceIndex surface : indices(surfaces)) {
    for (const ElementIndex element : surfaces[surface].lofted_elements) owned.push_back({element, surface});
  }
  std::sort(owned.begin(), owned.end());
  return owned;
}

/// The owners of parts of lofts; owned elements ascend.
template <class Part>
std::vector<SurfaceIndex> owners_of(const std::vector<Part>& parts, const std::vector<OwnedElement>& owned) {
  std::vector<SurfaceIndex> owners;
  owners.reserve(parts.size());
  for (const Part& part : parts)
    owners.push_back(std::ranges::lower_bound(owned, part.element, {}, &OwnedElement::element)->surface);
  return owners;
}

RegionNames names_of(const SimulationDefinition& definition, const Region& region, const Mesh& mesh) {
  const FiniteElementModel* parts = find_finite_element_model(definition, region);
  return {region.analytic_planes, parts ? std::span(parts->aliases) : std::span<const MeshAlias>{},
          find_sizeless_blocks(definition, region, mesh)};
}

/// Whether some command takes all blocks of the mesh.
bool takes_all_blocks(const ContactDefinition& contact) {
  return std::ranges::any_of(contact.surface_commands, [](const SurfaceCommand& command) {
    const auto* block = std::get_if<ContactSurfaceBlock>(&command);
    return std::holds_alternative<SkinAllBlocks>(command) || (block != nullptr && block->includes_all_blocks);
  });
}

/// Finds the node sets that pairs name.
void find_adjusted_nodes(const RegionNames& names, const Mesh& mesh, std::vector<SurfacePair>& pairs,
                         Diagnostics& diagnostics) {
  static constexpr EntityKind kinds[] = {EntityKind::node_set};
  NameLookup lookup(mesh, names.aliases, diagnostics, "");
  for (SurfacePair& pair : pairs) {
    if (!pair.adjusted_nodes) continue;
    const auto found = lookup.find_members(*pair.adjusted_nodes, kinds, "ADJUST NODE SET");
    if (!found.empty()) pair.adjusted_node_set = found.front().index;
  }
}

}  // namespace

void make_lofts(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                ContactModel& model, Diagnostics& diagnostics) {
  const auto owned = owned_elements(model.surfaces.surfaces);
  const auto sizes = find_loft_sizes(definition, region, mesh, {model.surfaces.surfaces, owned}, diagnostics);
  std::vector<ElementIndex> elements;
  elements.reserve(owned.size());
  for (const OwnedElement& one : owned) elements.push_back(one.element);
  model.loft = make_loft(mesh, mesh.coordinates(), elements, sizes);
  model.surface_of_facet = owners_of(model.loft.facets, owned);
  model.surface_of_sphere = owners_of(model.loft.spheres, owned);
  model.surface_of_capsule = owners_of(model.loft.capsules, owned);
}

ContactModel make_contact_model(const SimulationDefinition& definition, const Region& region,
                                const Mesh& mesh, Diagnostics& diagnostics) {
  ContactModel model;
  model.planes = region.analytic_planes;
  const RegionNames names = names_of(definition, region, mesh);
  model.surfaces = resolve_surfaces(*region.contact, names, mesh, diagnostics);
  if (takes_all_blocks(*region.contact)) model.surfaces.blocks_passed_over = names.sizeless_blocks;
  for (ContactSurface& surface : model.surfaces.surfaces)
    surface.may_gain_faces = surface.may_gain_faces && !region.element_deaths.empty();
  check_surface_names(*region.contact, model.surfaces, diagnostics);
  model.pairs = make_surface_pairs(*region.contact, model.surfaces, diagnostics);
  find_adjusted_nodes(names, mesh, model.pairs, diagnostics);
  make_lofts(definition, region, mesh, model, diagnostics);
  find_smoothings(definition, *region.contact, mesh, model, diagnostics);
  return model;
}

std::vector<SurfaceRequest> find_surface_requests(const SimulationDefinition& definition,
                                                  const Region& region, const Mesh& mesh,
                                                  Diagnostics& diagnostics) {
  return make_surface_requests(*region.contact, names_of(definition, region, mesh), mesh, diagnostics);
}

void find_name_errors(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                      Diagnostics& diagnostics) {
  find_surface_requests(definition, region, mesh, diagnostics);
}

}  // namespace contactsim
