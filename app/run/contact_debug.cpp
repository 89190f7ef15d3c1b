// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/contact_debug.hpp"

#include "core/base/csv_field.hpp"
#include "core/definition/simulation.hpp"

#include <fmt/format.h>

#include <iterator>

namespace contactsim {

std::vector<std::string> ContactDebugFiles::paths() const {
  std::vector<std::string> paths;
  if (!facets.empty()) paths.push_back(facets);
  if (!places.empty()) paths.push_back(places);
  return paths;
}

ContactDebugFiles contact_debug_files(const SimulationDefinition& definition, const ContactDebug& debug) {
  ContactDebugFiles files;
  if (debug.visualizes_facets) files.facets = expand_file_name(definition, "%B_contact_facets.exo");
  if (debug.writes_constraints) files.places = expand_file_name(definition, "%B_contact_places.csv");
  return files;
}

std::string format_places_csv(const ContactForce& force, const ContactModel& contact, const Mesh& mesh) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out,
      "first,second,first_element,first_side,first_node,second_element,second_side,gap,area,normal_force,"
      "tangential_x,tangential_y,tangential_z\n");
  const auto face_of = [&](std::uint32_t entity, bool is_edge) {
    const ElementSide side =
        is_edge ? force.contact_mesh().edges[{entity}].side : force.contact_mesh().faces[{entity}].side;
    return fmt::format("{},{}", mesh.element_id(side.element()), side.side());
  };
  const auto& surfaces = contact.surfaces.surfaces;
  for (const ContactPoint& place : force.points()) {
    const SurfacePair& pair = contact.pairs[place.pair];
    const bool is_node = place.first.is_node() && !place.is_of_edges;
    const bool is_rigid = place.second.weights.isZero(0.0);
    const std::int64_t node = mesh.node_id({force.contact_mesh().mesh_nodes[place.first.nodes[0]]});
    fmt::format_to(out, "{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                   csv_field(surfaces[place.is_swapped ? pair.second : pair.first].name),
                   csv_field(surfaces[place.is_swapped ? pair.first : pair.second].name),
                   is_node ? "," : face_of(place.first_entity, place.is_of_edges),
                   is_node ? fmt::to_string(node) : "",
                   is_rigid ? "," : face_of(place.second_entity, place.is_of_edges), place.open_gap(),
                   place.area, place.force, place.tangential[0], place.tangential[1], place.tangential[2]);
  }
  return fmt::to_string(text);
}

}  // namespace contactsim
