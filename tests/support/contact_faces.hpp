// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#include "support/contact_bodies.hpp"

namespace contactsim::test {

/// The face of an element that looks along a direction.
inline FaceIndex face_of(const ContactParts& parts, std::uint32_t element, const Eigen::Vector3d& direction) {
  for (const FaceIndex i : indices(parts.contact_mesh.faces)) {
    const ContactFace& face = parts.contact_mesh.faces[i];
    const Eigen::Vector3d area = parts.kinematics.area(face);
    if (face.side.element().value == element && area.normalized().dot(direction) > 0.99) return i;
  }
  throw std::logic_error("there is no such face");
}

/// The surface node of a node of the mesh.
inline SurfaceNodeIndex row_of_node(const ContactParts& parts, std::uint32_t mesh_node) {
  for (const SurfaceNodeIndex i : indices(parts.contact_mesh.surface_nodes)) {
    if (parts.contact_mesh.mesh_nodes[parts.contact_mesh.surface_nodes[i].node].value == mesh_node) return i;
  }
  throw std::logic_error("there is no such node");
}

/// Two unit cubes of one element, so far apart along z; the second may be narrower, and stands aside by its
/// first corner.
inline MeshBuilder cube_over_cube(double gap, double width = 1.0, double aside = 0.0) {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  return b.add_hexes(
      {.id = 2, .origin = {aside, aside, 1 + gap}, .size = {width, width, 1}, .share_nodes = false});
}

}  // namespace contactsim::test
