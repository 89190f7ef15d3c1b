// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/contact_remap.hpp"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace contactsim {

namespace {

/// Positions in one ascending list of what stands in another.
///   begin, end  of both in their arrays
template <class Key>
void match(std::span<const Key> before, std::span<const Key> after, std::uint32_t first_after,
           std::vector<OptionalIndex<std::uint32_t>>& positions) {
  std::size_t j = 0;
  for (const Key& key : before) {
    while (j < after.size() && after[j] < key) ++j;
    const bool is_there = j < after.size() && after[j] == key;
    // Facets of one side have the same key, and are as many before and after.
    OptionalIndex<std::uint32_t>& position = positions.emplace_back();
    if (is_there) position = first_after + static_cast<std::uint32_t>(j++);
  }
}

/// What tells a face of a surface from its others. Those of lofts follow the others, joints those of bricks.
using FaceKey = std::tuple<int, ElementSide, std::array<std::uint32_t, 4>>;

FaceKey key_of(const ContactMesh& contact_mesh, const ContactFace& face) {
  constexpr int of_edges = 6;  // sides of a shell's brick; those of joints are greater
  std::array<std::uint32_t, 4> nodes{};
  const bool is_joint = contact_mesh.is_lofted(face) && face.side.side() > of_edges;
  for (std::size_t k = 0; is_joint && k < 4; ++k) nodes[k] = contact_mesh.mesh_nodes[face.corners[k]];
  return {is_joint ? 2 : contact_mesh.is_lofted(face) ? 1 : 0, face.side, nodes};
}

std::vector<FaceKey> face_keys(const ContactMesh& contact_mesh, std::size_t surface) {
  std::vector<FaceKey> keys;
  for (std::uint32_t f = contact_mesh.first_face[surface]; f < contact_mesh.first_face[surface + 1]; ++f)
    keys.push_back(key_of(contact_mesh, contact_mesh.faces[f]));
  return keys;
}

/// Nodes of the mesh are the same by their numbers there, points of lofts by the faces that have them.
void match_nodes(const ContactMesh& before, const ContactMesh& after, ContactRemap& remap) {
  match<std::uint32_t>(std::span(before.mesh_nodes).first(before.n_mesh_points()),
                       std::span(after.mesh_nodes).first(after.n_mesh_points()), 0, remap.nodes);
  remap.nodes.resize(before.n_nodes());
  for (std::size_t f = 0; f < before.faces.size(); ++f) {
    if (!remap.faces[f] || !before.is_lofted(before.faces[f])) continue;
    const ContactFace& face = after.faces[*remap.faces[f]];
    for (std::size_t k = 0; k < 4; ++k) {
      OptionalIndex<std::uint32_t>& position = remap.nodes[before.faces[f].corners[k]];
      if (!position) position = face.corners[k];
    }
  }
}

/// What tells a surface node from others: its surface, its node, whether it is a sphere.
using RowKey = std::tuple<std::uint32_t, std::uint32_t, bool>;

void match_rows(const ContactMesh& before, const ContactMesh& after, ContactRemap& remap) {
  std::map<RowKey, std::uint32_t> known;
  for (std::uint32_t i = 0; i < after.surface_nodes.size(); ++i) {
    const SurfaceNode& row = after.surface_nodes[i];
    known.emplace_hint(known.end(), RowKey(row.surface, row.node, row.radius > 0.0f), i);
  }
  for (const SurfaceNode& row : before.surface_nodes) {
    OptionalIndex<std::uint32_t>& position = remap.rows.emplace_back();
    const OptionalIndex<std::uint32_t> node = remap.nodes[row.node];
    if (!node) continue;
    const auto found = known.find({row.surface, *node, row.radius > 0.0f});
    if (found != known.end()) position = found->second;
  }
}

/// What tells an edge from others: its surface, its nodes, its radius.
using EdgeKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, double>;

void match_edges(const ContactMesh& before, const ContactMesh& after, ContactRemap& remap) {
  std::map<EdgeKey, std::uint32_t> known;
  for (std::uint32_t i = 0; i < after.edges.size(); ++i) {
    const ContactEdge& edge = after.edges[i];
    known[{edge.surface, edge.nodes[0], edge.nodes[1], edge.radius}] = i;
  }
  for (const ContactEdge& edge : before.edges) {
    OptionalIndex<std::uint32_t>& position = remap.edges.emplace_back();
    const OptionalIndex<std::uint32_t> first = remap.nodes[edge.nodes[0]],
                                       second = remap.nodes[edge.nodes[1]];
    if (!first || !second) continue;
    const auto found = known.find({edge.surface, *first, *second, edge.radius});
    if (found != known.end()) position = found->second;
  }
}

}  // namespace

ContactRemap make_contact_remap(const ContactMesh& before, const ContactMesh& after) {
  ContactRemap remap;
  remap.n_faces_after = after.faces.size();
  remap.n_rows_after = after.surface_nodes.size();
  remap.n_nodes_after = after.n_nodes();
  remap.n_edges_after = after.edges.size();
  for (std::size_t s = 0; s + 1 < before.first_face.size(); ++s) {
    const auto keys = face_keys(before, s), keys_after = face_keys(after, s);
    match<FaceKey>(keys, keys_after, after.first_face[s], remap.faces);
  }
  match_nodes(before, after, remap);
  match_rows(before, after, remap);
  match_edges(before, after, remap);
  return remap;
}

PairLists transferred(const PairLists& lists, std::span<const OptionalIndex<std::uint32_t>> rows,
                      std::span<const OptionalIndex<std::uint32_t>> partners, std::size_t n_rows_after,
                      std::vector<std::size_t>& before) {
  std::vector<std::optional<std::size_t>> old_rows(n_rows_after);
  for (std::size_t row = 0; row < lists.n_rows(); ++row) {
    if (rows[row]) old_rows[*rows[row]] = row;
  }
  PairLists after;
  before.clear();
  for (const std::optional<std::size_t> row : old_rows) {
    const std::size_t end = row ? lists.begin[*row + 1] : 0;
    for (std::size_t k = row ? lists.begin[*row] : 0; k < end; ++k) {
      const OptionalIndex<std::uint32_t> partner = partners[lists.partners[k]];
      if (!partner) continue;
      after.partners.push_back(*partner);
      before.push_back(k);
    }
    after.begin.push_back(static_cast<std::uint32_t>(after.partners.size()));
  }
  return after;
}

}  // namespace contactsim
