// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_renumbering.hpp"

#include <map>
#include <tuple>
#include <utility>

namespace contactsim {

namespace {

constexpr std::uint32_t gone = ContactRenumbering::gone;

/// Positions in one ascending list of what stands in another.
///   begin, end  of both in their arrays
template <class Key>
void match(std::span<const Key> before, std::span<const Key> after, std::uint32_t first_after,
           std::vector<std::uint32_t>& places) {
  std::size_t j = 0;
  for (const Key& key : before) {
    while (j < after.size() && after[j] < key) ++j;
    const bool is_there = j < after.size() && after[j] == key;
    // Facets of one side have the same key, and are as many before and after.
    places.push_back(is_there ? first_after + static_cast<std::uint32_t>(j++) : gone);
  }
}

/// What tells a face of a surface from its others. Those of lofts follow the others, joints those of bricks.
using FaceKey = std::tuple<int, ElementSide, std::array<std::uint32_t, 4>>;

FaceKey key_of(const ContactFaces& faces, const ContactFace& face) {
  constexpr int of_edges = 6;  // sides of a shell's brick; those of joints are greater
  std::array<std::uint32_t, 4> nodes{};
  const bool is_joint = faces.is_lofted(face) && face.side.side() > of_edges;
  for (std::size_t k = 0; is_joint && k < 4; ++k) nodes[k] = faces.mesh_nodes[face.corners[k]];
  return {is_joint ? 2 : faces.is_lofted(face) ? 1 : 0, face.side, nodes};
}

std::vector<FaceKey> face_keys(const ContactFaces& faces, std::size_t surface) {
  std::vector<FaceKey> keys;
  for (std::uint32_t f = faces.first_face[surface]; f < faces.first_face[surface + 1]; ++f)
    keys.push_back(key_of(faces, faces.faces[f]));
  return keys;
}

/// Nodes of the mesh are the same by their numbers there, points of lofts by the faces that have them.
void match_nodes(const ContactFaces& before, const ContactFaces& after, ContactRenumbering& places) {
  match<std::uint32_t>(std::span(before.mesh_nodes).first(before.n_mesh_points()),
                       std::span(after.mesh_nodes).first(after.n_mesh_points()), 0, places.nodes);
  places.nodes.resize(before.n_nodes(), gone);
  for (std::size_t f = 0; f < before.faces.size(); ++f) {
    if (places.faces[f] == gone || !before.is_lofted(before.faces[f])) continue;
    const ContactFace& face = after.faces[places.faces[f]];
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint32_t& place = places.nodes[before.faces[f].corners[k]];
      if (place == gone) place = face.corners[k];
    }
  }
}

/// What tells a surface node from others: its surface, its node, whether it is a ball.
using RowKey = std::tuple<std::uint32_t, std::uint32_t, bool>;

void match_rows(const ContactFaces& before, const ContactFaces& after, ContactRenumbering& places) {
  std::map<RowKey, std::uint32_t> known;
  for (std::uint32_t i = 0; i < after.surface_nodes.size(); ++i) {
    const SurfaceNode& row = after.surface_nodes[i];
    known.emplace_hint(known.end(), RowKey(row.surface, row.node, row.radius > 0.0f), i);
  }
  for (const SurfaceNode& row : before.surface_nodes) {
    const auto found = known.find({row.surface, places.nodes[row.node], row.radius > 0.0f});
    places.rows.push_back(found != known.end() ? found->second : gone);
  }
}

/// What tells an edge from others: its surface, its nodes, its radius.
using EdgeKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, double>;

void match_edges(const ContactFaces& before, const ContactFaces& after, ContactRenumbering& places) {
  std::map<EdgeKey, std::uint32_t> known;
  for (std::uint32_t i = 0; i < after.edges.size(); ++i) {
    const ContactEdge& edge = after.edges[i];
    known[{edge.surface, edge.nodes[0], edge.nodes[1], edge.radius}] = i;
  }
  for (const ContactEdge& edge : before.edges) {
    const EdgeKey key{edge.surface, places.nodes[edge.nodes[0]], places.nodes[edge.nodes[1]], edge.radius};
    const auto found = known.find(key);
    places.edges.push_back(found != known.end() ? found->second : gone);
  }
}

}  // namespace

ContactRenumbering renumber(const ContactFaces& before, const ContactFaces& after) {
  ContactRenumbering places;
  places.n_faces_after = after.faces.size();
  places.n_rows_after = after.surface_nodes.size();
  places.n_nodes_after = after.n_nodes();
  places.n_edges_after = after.edges.size();
  for (std::size_t s = 0; s + 1 < before.first_face.size(); ++s) {
    const auto keys = face_keys(before, s), keys_after = face_keys(after, s);
    match<FaceKey>(keys, keys_after, after.first_face[s], places.faces);
  }
  match_nodes(before, after, places);
  match_rows(before, after, places);
  match_edges(before, after, places);
  return places;
}

PairLists carried(const PairLists& lists, std::span<const std::uint32_t> rows,
                  std::span<const std::uint32_t> partners, std::size_t n_rows_after,
                  std::vector<std::size_t>& before) {
  constexpr std::size_t none = SIZE_MAX;
  std::vector<std::size_t> old_rows(n_rows_after, none);
  for (std::size_t row = 0; row < lists.n_rows(); ++row) {
    if (rows[row] != gone) old_rows[rows[row]] = row;
  }
  PairLists after;
  before.clear();
  for (const std::size_t row : old_rows) {
    const std::size_t end = row == none ? 0 : lists.begin[row + 1];
    for (std::size_t k = row == none ? 0 : lists.begin[row]; k < end; ++k) {
      const std::uint32_t partner = partners[lists.partners[k]];
      if (partner == gone) continue;
      after.partners.push_back(partner);
      before.push_back(k);
    }
    after.begin.push_back(static_cast<std::uint32_t>(after.partners.size()));
  }
  return after;
}

}  // namespace contactsim
