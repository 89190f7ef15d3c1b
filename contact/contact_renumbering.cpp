// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_renumbering.hpp"

#include <functional>

namespace contactsim {

namespace {

/// Positions in one ascending list of what stands in another; `less` compares two items of either.
template <class T, class Less>
void match(std::span<const T> before, std::span<const T> after, std::uint32_t first_after, const Less& less,
           std::vector<std::uint32_t>& places) {
  std::size_t j = 0;
  for (const T& item : before) {
    while (j < after.size() && less(after[j], item)) ++j;
    const bool is_there = j < after.size() && !less(item, after[j]);
    places.push_back(is_there ? first_after + static_cast<std::uint32_t>(j) : ContactRenumbering::gone);
  }
}

/// The part of a surface in a list.
template <class T>
std::span<const T> part(const std::vector<T>& list, const std::vector<std::uint32_t>& first, std::size_t s) {
  return std::span(list).subspan(first[s], first[s + 1] - first[s]);
}

}  // namespace

ContactRenumbering renumber(const ContactFaces& before, const ContactFaces& after) {
  ContactRenumbering places;
  places.n_faces_after = after.faces.size();
  places.n_rows_after = after.surface_nodes.size();
  places.n_nodes_after = after.n_nodes();
  match<std::uint32_t>(before.mesh_nodes, after.mesh_nodes, 0, std::less<>(), places.nodes);
  const auto by_side = [](const ContactFace& a, const ContactFace& b) { return a.side < b.side; };
  for (std::size_t s = 0; s + 1 < before.first_face.size(); ++s) {
    match(part(before.faces, before.first_face, s), part(after.faces, after.first_face, s),
          after.first_face[s], by_side, places.faces);
    std::vector<std::uint32_t> nodes_before, nodes_after;
    for (const SurfaceNode& node : part(before.surface_nodes, before.first_node, s))
      nodes_before.push_back(before.mesh_nodes[node.node]);
    for (const SurfaceNode& node : part(after.surface_nodes, after.first_node, s))
      nodes_after.push_back(after.mesh_nodes[node.node]);
    match<std::uint32_t>(nodes_before, nodes_after, after.first_node[s], std::less<>(), places.rows);
  }
  return places;
}

}  // namespace contactsim
