// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_parts.hpp"

#include <algorithm>
#include <cmath>

#include "contact/mesh/feature_edges.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "core/definition/contact.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

namespace {

IndexedVector<FaceIndex, OverlapFace> measure_faces(const ContactKinematics& start, const Mesh& mesh) {
  IndexedVector<FaceIndex, OverlapFace> measured;
  for (const ContactFace& face : start.contact_mesh().faces) {
    const double area = start.area(face).norm();
    const bool has_thickness = start.contact_mesh().is_lofted(face) || is_solid(mesh, face.side);
    measured.push_back(
        {std::sqrt(area), has_thickness && area > 0.0 ? 0.5 * face.penalty_properties.thickness : 0.0});
  }
  return measured;
}

IndexedVector<SurfaceNodeIndex, OverlapNode> measure_nodes(
    const ContactKinematics& start, const IndexedVector<FaceIndex, OverlapFace>& of_face) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  IndexedVector<SurfaceNodeIndex, OverlapNode> measured;
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    OverlapNode& made = measured.emplace_back();
    made.half_thickness = node.radius;
    if (node.radius > 0.0f) continue;
    bool is_first = true;
    for (const FaceIndex face : contact_mesh.faces_of_node.of(node.node)) {
      if (contact_mesh.faces[face].surface != node.surface) continue;
      made.normal += start.area(contact_mesh.faces[face]);
      made.size = std::max(made.size, of_face[face].size);
      made.half_thickness = is_first ? of_face[face].half_thickness
                                     : std::min(made.half_thickness, of_face[face].half_thickness);
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
  const auto contact_mesh = std::make_shared<ContactMesh>(make_contact_mesh(model, mesh));
  const ContactKinematics start = kinematics_of_mesh(*contact_mesh, mesh);
  choose_feature_edges(definition.surface_options, model.surfaces.surfaces, start, *contact_mesh);
  add_smooth_faces(model, start, *contact_mesh);
  OverlapParts parts{contact_mesh, *contact_mesh, measure_faces(start, mesh), {}};
  parts.of_node = measure_nodes(start, parts.of_face);
  return parts;
}

OverlapParts make_overlap_parts(const ContactKinematics& kinematics, const Mesh& mesh) {
  OverlapParts parts{nullptr, kinematics.contact_mesh(), measure_faces(kinematics, mesh), {}};
  parts.of_node = measure_nodes(kinematics, parts.of_face);
  return parts;
}

}  // namespace contactsim
