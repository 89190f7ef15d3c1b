// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_warnings.hpp"

#include <fmt/format.h>

#include <string>

#include "core/mesh/coincident_elements.hpp"
#include "core/mesh/hanging_faces.hpp"
#include "core/mesh/spanning_elements.hpp"

namespace contactsim {

namespace {

std::string name_of(ElementIndex element, const Mesh& mesh) {
  return fmt::format("element {} of {}", mesh.element_id(element),
                     mesh.name({EntityKind::block, mesh.block_of(element)}));
}

/// "the first of them " where there are several.
const char* first_of(std::size_t n) { return n == 1 ? "" : "the first of them "; }

/// Midside nodes that one side of a face has alone part from the other side.
void warn_of_hanging_nodes(const Mesh& mesh, const DeckLocation& location, Diagnostics& diagnostics) {
  const auto hanging = find_hanging_faces(mesh);
  if (!hanging) return;
  diagnostics.add_warning(
      "midside-nodes", location,
      fmt::format(
          "{} faces of six nodes lie on faces that have no or other midside nodes, the first of element "
          "{} on element {}",
          hanging->n, mesh.element_id(hanging->first.element()), mesh.element_id(hanging->beside.element())),
      "those nodes are joined to one side only: mesh both sides alike, or part the bodies and tie them");
}

/// Faces that two solids on the same nodes share are interior to both: contact would not see them.
void warn_of_coincident_elements(const Mesh& mesh, const DeckLocation& location, Diagnostics& diagnostics) {
  const auto coincident = find_coincident_elements(mesh);
  if (!coincident) return;
  diagnostics.add_warning(
      "coincident-elements", location,
      fmt::format("{} the nodes of other elements, {}{} those of {}",
                  coincident->n == 1 ? "1 element has" : fmt::format("{} elements have", coincident->n),
                  first_of(coincident->n), name_of(coincident->first, mesh),
                  name_of(coincident->beside, mesh)),
      "both carry load, and what they share is no outer face that others could meet");
}

/// Such an element is near everything in the search.
void warn_of_spanning_elements(const Mesh& mesh, const DeckLocation& location, Diagnostics& diagnostics) {
  const auto spanning = find_spanning_elements(mesh);
  if (!spanning) return;
  diagnostics.add_warning(
      "spanning-element", location,
      fmt::format("{} more than half of the model, {}{}, {:.4g} long where most of its block are {:.3g}",
                  spanning->n == 1 ? "1 element spans" : fmt::format("{} elements span", spanning->n),
                  first_of(spanning->n), name_of(spanning->first, mesh), spanning->extent, spanning->usual),
      "a node of it may stand where it should not; contact searches longer with it");
}

}  // namespace

void warn_of_mesh(const Mesh& mesh, const DeckLocation& location, Diagnostics& diagnostics) {
  warn_of_hanging_nodes(mesh, location, diagnostics);
  warn_of_coincident_elements(mesh, location, diagnostics);
  warn_of_spanning_elements(mesh, location, diagnostics);
}

}  // namespace contactsim
