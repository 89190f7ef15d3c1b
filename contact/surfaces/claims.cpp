// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/claims.hpp"

#include <algorithm>
#include <iterator>

#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

namespace {

/// Both ascending.
std::vector<std::uint32_t> joined(const std::vector<std::uint32_t>& some,
                                  const std::vector<std::uint32_t>& others) {
  std::vector<std::uint32_t> all;
  all.reserve(some.size() + others.size());
  std::set_union(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(all));
  return all;
}

/// Both ascending.
std::vector<std::uint32_t> without(const std::vector<std::uint32_t>& list,
                                   const std::vector<std::uint32_t>& removed) {
  std::vector<std::uint32_t> rest;
  std::set_difference(list.begin(), list.end(), removed.begin(), removed.end(), std::back_inserter(rest));
  return rest;
}

/// Candidate faces of side sets, ascending.
std::vector<std::uint32_t> faces_of_side_sets(const std::vector<std::uint32_t>& sets, const Mesh& mesh,
                                              const SkinFaces& skin_faces) {
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t set : sets) {
    for (const ElementSide side : mesh.side_sets()[set].sides) {
      if (const auto face = skin_faces.find_face(side)) faces.push_back(*face);
    }
  }
  sort_once(faces);
  return faces;
}

}  // namespace

std::vector<std::uint32_t> claimed_faces(const SurfaceRequest& request, const Mesh& mesh,
                                         const SkinFaces& skin_faces) {
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t index : request.blocks) {
    const auto [first, last] = skin_faces.faces_of(mesh.blocks()[index]);
    for (std::uint32_t face = first; face < last; ++face) {
      if (skin_faces.is_exterior[face]) faces.push_back(face);
    }
  }
  if (!request.side_sets.empty())
    faces = joined(faces, faces_of_side_sets(request.side_sets, mesh, skin_faces));
  if (!request.removed_side_sets.empty())
    faces = without(faces, faces_of_side_sets(request.removed_side_sets, mesh, skin_faces));
  return faces;
}

std::vector<std::uint32_t> claimed_lofted(const SurfaceRequest& request, const Mesh& mesh,
                                          const SkinFaces& skin_faces) {
  std::vector<std::uint32_t> lofted, removed;
  for (const std::uint32_t index : request.blocks) {
    const auto [first, last] = skin_faces.lofted_of(mesh.blocks()[index]);
    for (std::uint32_t element = first; element < last; ++element) lofted.push_back(element);
  }
  const auto add = [&](ElementIndex element, std::vector<std::uint32_t>& list) {
    if (const auto found = skin_faces.find_lofted(element)) list.push_back(*found);
  };
  for (const ElementIndex element : request.elements) add(element, lofted);
  for (const std::uint32_t set : request.removed_side_sets) {
    for (const ElementSide side : mesh.side_sets()[set].sides) add(side.element(), removed);
  }
  sort_once(lofted);
  sort_once(removed);
  return without(lofted, removed);
}

std::vector<NodeIndex> claimed_nodes(const SurfaceRequest& request, const Mesh& mesh,
                                     const ContactDomain& domain) {
  std::vector<NodeIndex> nodes;
  for (const std::uint32_t set : request.node_sets) {
    const auto& members = mesh.node_sets()[set].nodes;
    nodes.insert(nodes.end(), members.begin(), members.end());
  }
  for (const std::uint32_t set : request.side_sets) {
    for (const ElementSide side : mesh.side_sets()[set].sides) {
      if (!domain.is_alive(side.element())) continue;
      const auto corners = mesh.side_nodes(side);
      nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
  }
  for (const std::uint32_t index : request.blocks) {
    const ElementBlock& block = mesh.blocks()[index];
    for (std::uint32_t i = 0; i < block.n_elements; ++i) {
      if (!domain.is_alive({block.first_element.value + i})) continue;
      const auto corners = block.element_nodes(i);
      nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
  }
  std::erase_if(nodes, [&](NodeIndex node) { return !domain.holds(node); });
  sort_once(nodes);
  return nodes;
}

}  // namespace contactsim
