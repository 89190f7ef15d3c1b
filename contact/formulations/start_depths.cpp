// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_depths.hpp"

#include <algorithm>
#include <limits>

namespace contactsim {

namespace {

void set_all(double depth, ContactMesh& contact_mesh) {
  for (ContactFace& face : contact_mesh.faces) face.penalty_properties.start_depth = depth;
  for (SurfaceNode& node : contact_mesh.surface_nodes) node.penalty_properties.start_depth = depth;
  for (ContactEdge& edge : contact_mesh.edges) edge.penalty_properties.start_depth = depth;
}

void deepen(double depth, PenaltyProperties& penalty_properties) {
  penalty_properties.start_depth = std::max(penalty_properties.start_depth, depth);
}

template <class AnIndex, class Item>
void transfer_of(const NewPositions<AnIndex>& positions, const IndexedVector<AnIndex, Item>& before,
                 IndexedVector<AnIndex, Item>& after) {
  for (const AnIndex i : indices(before)) {
    if (positions[i])
      after[*positions[i]].penalty_properties.start_depth = before[i].penalty_properties.start_depth;
  }
}

}  // namespace

void forget_start_depths(ContactMesh& contact_mesh) {
  set_all(std::numeric_limits<double>::infinity(), contact_mesh);
}

void set_start_depths(std::span<const ContactPoint> points, ContactMesh& contact_mesh) {
  set_all(0.0, contact_mesh);
  for (const ContactPoint& point : points) {
    const bool is_plane = point.second.weights.isZero(0.0);
    if (point.is_of_edges) {
      deepen(point.deepest, contact_mesh.edges[point.first_edge()].penalty_properties);
      deepen(point.deepest, contact_mesh.edges[point.second_edge()].penalty_properties);
      continue;
    }
    deepen(point.deepest, point.first.is_node() ? contact_mesh.surface_nodes[point.row()].penalty_properties
                                                : contact_mesh.faces[point.first_face()].penalty_properties);
    if (!is_plane) deepen(point.deepest, contact_mesh.faces[point.second_face()].penalty_properties);
  }
}

void transfer_start_depths(const ContactRemap& remap, const ContactMesh& before, ContactMesh& after) {
  transfer_of(remap.faces, before.faces, after.faces);
  transfer_of(remap.rows, before.surface_nodes, after.surface_nodes);
  transfer_of(remap.edges, before.edges, after.edges);
}

}  // namespace contactsim
