// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/side_thickness.hpp"

#include <algorithm>

namespace contactsim {

double thinner_side(const ContactMesh& contact_mesh, const ContactPoint& point) {
  if (point.is_of_edges) {
    return std::min(contact_mesh.edges[point.first_edge()].penalty_properties.thickness,
                    contact_mesh.edges[point.second_edge()].penalty_properties.thickness);
  }
  const double first = point.first.is_node()
                           ? contact_mesh.surface_nodes[point.row()].penalty_properties.thickness
                           : contact_mesh.faces[point.first_face()].penalty_properties.thickness;
  if (point.second.weights.isZero(0.0)) return first;
  return std::min(first, contact_mesh.faces[point.second_face()].penalty_properties.thickness);
}

}  // namespace contactsim
