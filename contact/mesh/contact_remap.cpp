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
template <class Key, class AnIndex>
void match(std::span<const Key> before, std::span<const Key> after, AnIndex first_after,
           std::vector<OptionalIndex<AnIndex>>& positions) {
  std::size_t j = 0;
  for (const Key& key : before) {
    while (j < after.size() && after[j] < key) ++j;
    const bool is_there = j < after.size() && after[j] == key;
    // Facets of one side have the same key, and are as many before and after.
    OptionalIndex<AnIndex>& position = positions.emplace_back();
    if (is_there) position = AnIndex{number_of(first_after) + static_cast<std::uint32_t>(j++)};
  }
}

/// What tells a face of a surface from its others. Those of lofts follow the others, joints those of bricks.
using FaceKey = std::tuple<int, ElementSide, std::array<NodeIndex, 4>>;

FaceKey key_of(const ContactMesh& contact_mesh, const ContactFace& face) {
  constexpr int of_edges = 6;        // sides of a shell's brick; those of joints are greater
  std::array<NodeIndex, 4> nodes{};  // of the mesh
  const bool is_joint = contact_mesh.is_lofted(face) && face.side.side() > of_edges;
  for (std::size_t k = 0; is_joint && k < 4; ++k) nodes[k] = contact_mesh.mesh_nodes[face.corners[k]];
  return {is_joint ? 2 : contact_mesh.is_lofted(face) ? 1 : 0, face.side, nodes};
}

std::vector<FaceKey> face_keys(const ContactMesh& contact_mesh, SurfaceIndex surface) {
  std::vector<FaceKey> keys;
  for (const FaceIndex f : contact_mesh.faces_of(surface))
    keys.push_back(key_of(contact_mesh, contact_mesh.faces[f]));
  return keys;
}

/// Nodes of the mesh are the same by their numbers there, points of lofts by the faces that have them.
void match_nodes(const ContactMesh& before, const ContactMesh& after, ContactRemap& remap) {
  match<NodeIndex>(std::span<const NodeIndex>(before.mesh_nodes).first(before.n_mesh_points()),
                   std::span<const NodeIndex>(after.mesh_nodes).first(after.n_mesh_points()),
                   ContactNodeIndex{0}, remap.nodes);
  remap.nodes.resize(before.n_nodes());
  for (const FaceIndex f : indices(before.faces)) {
    if (!remap.faces[f] || !before.is_lofted(before.faces[f])) continue;
    const ContactFace& face = after.faces[*remap.faces[f]];
    for (std::size_t k = 0; k < 4; ++k) {
      OptionalIndex<ContactNodeIndex>& position = remap.nodes[before.faces[f].corners[k]];
      if (!position) position = face.corners[k];
    }
  }
}

/// What tells a surface node from others: its surface, its node, whether it is a sphere.
using RowKey = std::tuple<SurfaceIndex, ContactNodeIndex, bool>;

void match_rows(const ContactMesh& before, const ContactMesh& after, ContactRemap& remap) {
  std::map<RowKey, SurfaceNodeIndex> known;
  for (const SurfaceNodeIndex i : indices(after.surface_nodes)) {
    const SurfaceNode& row = after.surface_nodes[i];
    known.emplace_hint(known.end(), RowKey(row.surface, row.node, row.radius > 0.0f), i);
  }
  for (const SurfaceNode& row : before.surface_nodes) {
    OptionalIndex<SurfaceNodeIndex>& position = remap.rows.emplace_back();
    const OptionalIndex<ContactNodeIndex> node = remap.nodes[row.node];
    if (!node) continue;
    const auto found = known.find({row.surface, *node, row.radius > 0.0f});
    if (found != known.end()) position = found->second;
  }
}

/// What tells an edge from others: its surface, its nodes, its radius.
using EdgeKey = std::tuple<SurfaceIndex, ContactNodeIndex, ContactNodeIndex, double>;

void match_edges(const ContactMesh& before, const ContactMesh& after, ContactRemap& remap) {
  std::map<EdgeKey, EdgeIndex> known;
  for (const EdgeIndex i : indices(after.edges)) {
    const ContactEdge& edge = after.edges[i];
    known[{edge.surface, edge.nodes[0], edge.nodes[1], edge.radius}] = i;
  }
  for (const ContactEdge& edge : before.edges) {
    OptionalIndex<EdgeIndex>& position = remap.edges.emplace_back();
    const OptionalIndex<ContactNodeIndex> first = remap.nodes[edge.nodes[0]],
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
  for (const SurfaceIndex s : before.surfaces()) {
    const auto keys = face_keys(before, s), keys_after = face_keys(after, s);
    match<FaceKey>(keys, keys_after, *after.faces_of(s).begin(), remap.faces);
  }
  match_nodes(before, after, remap);
  match_rows(before, after, remap);
  match_edges(before, after, remap);
  return remap;
}

}  // namespace contactsim
