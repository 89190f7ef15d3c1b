// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_parts.hpp"

#include <algorithm>
#include <cmath>

#include "contact/moving_surface.hpp"
#include "contact/sharp_edges.hpp"

namespace contactsim {

namespace {

std::vector<OverlapFace> measure_faces(const MovingSurface& start, const Mesh& mesh) {
  std::vector<OverlapFace> measured;
  for (const ContactFace& face : start.faces().faces) {
    const double area = start.area(face).norm();
    const bool has_thickness = start.faces().is_lofted(face) || is_solid(mesh, face.side);
    measured.push_back({std::sqrt(area), has_thickness && area > 0.0 ? 0.5 * face.backing.thickness : 0.0});
  }
  return measured;
}

std::vector<OverlapNode> measure_nodes(const MovingSurface& start, std::span<const OverlapFace> of_face) {
  const ContactFaces& faces = start.faces();
  std::vector<OverlapNode> measured;
  for (const SurfaceNode& node : faces.surface_nodes) {
    OverlapNode& made = measured.emplace_back();
    made.reach = node.radius;
    if (node.radius > 0.0f) continue;
    bool is_first = true;
    for (const std::uint32_t face : faces.faces_of_node.of(node.node)) {
      if (faces.faces[face].surface != node.surface) continue;
      made.normal += start.area(faces.faces[face]);
      made.size = std::max(made.size, of_face[face].size);
      made.reach = is_first ? of_face[face].reach : std::min(made.reach, of_face[face].reach);
      is_first = false;
    }
  }
  return measured;
}

}  // namespace

bool is_solid(const Mesh& mesh, ElementSide side) {
  return topology(mesh.blocks()[mesh.block_of(side.element())].shape).family == Family::solid;
}

OverlapParts make_overlap_parts(const ContactModel& model, const ContactDefinition& definition,
                                const Mesh& mesh) {
  OverlapParts parts;
  parts.faces = make_contact_faces(model, mesh);
  const MovingSurface start = surface_of_mesh(parts.faces, mesh);
  choose_edges(definition.surface_options, model.surfaces.surfaces, start, parts.faces);
  parts.of_face = measure_faces(start, mesh);
  parts.of_node = measure_nodes(start, parts.of_face);
  return parts;
}

}  // namespace contactsim
