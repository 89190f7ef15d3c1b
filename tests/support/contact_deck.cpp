// SPDX-License-Identifier: BSD-3-Clause
#include "support/contact_deck.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "contact/surfaces/surface_tracker.hpp"
#include "parser/commands/contact_commands.hpp"
#include "parser/commands/region_commands.hpp"
#include "parser/commands/sierra_commands.hpp"
#include "parser/text/syntax.hpp"
#include "support/deck_dump.hpp"

namespace contactsim::test {

namespace {

/// Binds lines as if they stood in the block that the table belongs to.
template <class T>
T bind_lines(const Table<T>& table, const std::string& lines) {
  Diagnostics diagnostics;
  const Block block = parse_syntax(make_source("c.i", lines), diagnostics);
  Binding binding{diagnostics};
  T target;
  table.bind(block, target, binding);
  if (!diagnostics.empty()) throw std::logic_error("the test's deck is wrong:\n" + messages(diagnostics));
  return target;
}

/// The errors alone, in machine form: models of surfaces without pairs are fine in tests.
std::string error_messages(const Diagnostics& diagnostics) {
  Diagnostics errors;
  for (const Diagnostic& found : diagnostics.all()) {
    if (found.severity == Severity::error) errors.add(found);
  }
  return messages(errors);
}

/// Lets the elements that are not alive die.
///   requests  that the surfaces were made by
void remove_dead(const Mesh& mesh, const ContactDefinition& contact, std::vector<SurfaceRequest> requests,
                 std::span<const std::uint8_t> alive, ContactSurfaces& surfaces) {
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  std::vector<ElementIndex> dead;
  for (std::uint32_t i = 0; i < alive.size(); ++i) {
    if (alive[i] == 0) dead.push_back({i});
  }
  SurfaceTracker(OwnershipRules(std::move(requests), mesh, contact.subdomain), faces)
      .update_for_deaths(dead, surfaces);
}

Resolved resolve(const Mesh& mesh, const ContactDefinition& contact, const RegionNames& names,
                 std::span<const std::uint8_t> alive) {
  Diagnostics diagnostics, discarded;
  Resolved resolved{resolve_surfaces(contact, names, mesh, diagnostics), ""};
  resolved.messages = messages(diagnostics);
  if (!alive.empty())
    remove_dead(mesh, contact, make_surface_requests(contact, names, mesh, discarded), alive, resolved);
  return resolved;
}

/// What these tests work out by hand are elastic penalties: the enforcement of decks that do not say another.
void push_elastically(ContactDefinition& contact) {
  if (!contact.enforcement.enforcement) contact.enforcement.enforcement = Enforcement::penalty;
}

}  // namespace

ContactDefinition parse_contact(const std::string& lines) {
  ContactDefinition contact = bind_lines(contact_definition_table(), lines);
  push_elastically(contact);
  return contact;
}

Region parse_region(const std::string& lines) {
  Region region = bind_lines(region_table(), lines);
  if (region.contact) push_elastically(*region.contact);
  return region;
}

SimulationDefinition parse_definitions(const std::string& lines) {
  static const Table<SimulationDefinition> table(definition_rows());
  return bind_lines(table, lines);
}

const ContactSurface& Resolved::operator[](const std::string& name) const {
  for (const ContactSurface& surface : surfaces) {
    if (surface.name == name) return surface;
  }
  throw std::logic_error("there is no surface " + name);
}

Resolved resolve(const Mesh& mesh, const std::string& lines, std::span<const std::uint8_t> alive) {
  return resolve(mesh, parse_contact(lines), RegionNames{}, alive);
}

Resolved resolve(const Mesh& mesh, const Region& region, std::span<const MeshAlias> aliases) {
  return resolve(mesh, *region.contact, RegionNames{region.analytic_planes, aliases}, {});
}

Modelled make_model(const Mesh& mesh, const Region& region, const std::string& definitions,
                    std::span<const std::uint8_t> alive) {
  Diagnostics diagnostics;
  const SimulationDefinition definition = parse_definitions(definitions);
  Modelled modelled{make_contact_model(definition, region, mesh, diagnostics), ""};
  modelled.messages = error_messages(diagnostics);
  if (!alive.empty()) {
    remove_dead(mesh, *region.contact, find_surface_requests(definition, region, mesh, diagnostics), alive,
                modelled.surfaces);
    make_lofts(definition, region, mesh, modelled, diagnostics);
  }
  return modelled;
}

Modelled make_model(const Mesh& mesh, const std::string& contact_lines, const std::string& definitions,
                    std::span<const std::uint8_t> alive) {
  Region region;
  region.contact = parse_contact(contact_lines);
  return make_model(mesh, region, definitions, alive);
}

std::vector<std::uint8_t> all_but(const Mesh& mesh, const std::vector<std::int64_t>& dead_ids) {
  std::vector<std::uint8_t> alive(mesh.n_elements(), 1);
  for (const std::int64_t id : dead_ids) alive[mesh.find_element(id).value().value] = 0;
  return alive;
}

std::string list_faces(const Mesh& mesh, const ContactSurface& surface) {
  std::vector<std::string> faces;
  for (const ElementSide face : surface.faces)
    faces.push_back(fmt::format("{}:{}", mesh.element_id(face.element()), face.side()));
  return fmt::format("{}", fmt::join(faces, " "));
}

std::string list_lofted(const Mesh& mesh, const ContactSurface& surface) {
  std::vector<std::int64_t> ids;
  for (const ElementIndex element : surface.lofted_elements) ids.push_back(mesh.element_id(element));
  return fmt::format("{}", fmt::join(ids, " "));
}

std::string list_nodes(const Mesh& mesh, const ContactSurface& surface) {
  std::vector<std::int64_t> ids;
  for (const NodeIndex node : surface.nodes) ids.push_back(mesh.node_id(node));
  return fmt::format("{}", fmt::join(ids, " "));
}

std::string list_lost(const ContactSurfaces& result, const ContactSurface& surface) {
  std::vector<std::string> losses;
  for (const LostClaims& lost : surface.lost_to) {
    std::string text = result.surfaces[lost.winner].name;
    if (lost.faces > 0) text += fmt::format(" {} faces", lost.faces);
    if (lost.lofted > 0) text += fmt::format(" {} lofted", lost.lofted);
    if (lost.nodes > 0) text += fmt::format(" {} nodes", lost.nodes);
    losses.push_back(text);
  }
  return fmt::format("{}", fmt::join(losses, ", "));
}

std::string describe(const Mesh& mesh, const ContactSurfaces& result) {
  std::string text;
  for (const ContactSurface& surface : result.surfaces) {
    text += fmt::format("{} | {} | {} | {} | {}\n", surface.name, list_faces(mesh, surface),
                        list_lofted(mesh, surface), list_nodes(mesh, surface), list_lost(result, surface));
  }
  return text;
}

std::string list_warnings(const ContactSurfaces& result) {
  std::string text;
  for (const SurfaceWarning& warning : result.warnings) {
    text += fmt::format("{}, line {}, {}, {}: {}\n", warning.id, warning.location.line, warning.surface,
                        warning.count, warning.text);
  }
  return text;
}

std::string describe_all(const Mesh& mesh, const ContactSurfaces& result) {
  return fmt::format("{}{}{} faces ignored\n", describe(mesh, result), list_warnings(result),
                     result.interior_faces_ignored);
}

std::vector<ElementSide> faces_where(MeshBuilder builder, const SideCondition& condition) {
  builder.add_side_set(0, "", condition);
  return builder.parts().side_sets.back().sides;
}

}  // namespace contactsim::test
