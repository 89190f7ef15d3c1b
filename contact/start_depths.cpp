// SPDX-License-Identifier: BSD-3-Clause
#include "contact/start_depths.hpp"

#include <algorithm>
#include <limits>

namespace contactsim {

namespace {

void set_all(double depth, ContactFaces& faces) {
  for (ContactFace& face : faces.faces) face.backing.start_depth = depth;
  for (SurfaceNode& node : faces.surface_nodes) node.backing.start_depth = depth;
  for (ContactEdge& edge : faces.edges) edge.backing.start_depth = depth;
}

void deepen(double depth, Backing& backing) { backing.start_depth = std::max(backing.start_depth, depth); }

template <class Item>
void carry_of(std::span<const std::uint32_t> places, std::span<const Item> before, std::span<Item> after) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (places[i] != ContactRenumbering::gone)
      after[places[i]].backing.start_depth = before[i].backing.start_depth;
  }
}

}  // namespace

void forget_start_depths(ContactFaces& faces) { set_all(std::numeric_limits<double>::infinity(), faces); }

void set_start_depths(std::span<const ContactRecord> points, ContactFaces& faces) {
  set_all(0.0, faces);
  for (const ContactRecord& point : points) {
    const std::uint32_t first = point.first_place, second = point.second_place;
    const bool is_plane = point.second.weights.isZero(0.0);
    if (point.is_of_edges) {
      deepen(point.deepest, faces.edges[first].backing);
      deepen(point.deepest, faces.edges[second].backing);
      continue;
    }
    deepen(point.deepest,
           point.first.is_node() ? faces.surface_nodes[first].backing : faces.faces[first].backing);
    if (!is_plane) deepen(point.deepest, faces.faces[second].backing);
  }
}

void carry_start_depths(const ContactRenumbering& places, const ContactFaces& before, ContactFaces& after) {
  carry_of<ContactFace>(places.faces, before.faces, after.faces);
  carry_of<SurfaceNode>(places.rows, before.surface_nodes, after.surface_nodes);
  carry_of<ContactEdge>(places.edges, before.edges, after.edges);
}

}  // namespace contactsim
