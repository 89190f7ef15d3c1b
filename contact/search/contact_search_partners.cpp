// SPDX-License-Identifier: BSD-3-Clause
// What may meet what: by surfaces, sides, elements and bodies.
#include <algorithm>

#include "contact/search/contact_search.hpp"

namespace contactsim {

bool ContactSearch::faces_may_meet(FaceIndex first, FaceIndex second) const {
  const ContactFace &a = contact_mesh_.faces[first], &b = contact_mesh_.faces[second];
  const OptionalIndex<PairIndex> pair = rules_.find(a.surface, b.surface);
  if (!pair) return false;
  const SurfacePair& of = *rules_[*pair].pair;
  if (of.formulation != ConstraintFormulation::face_face) return false;
  if (!(takes_part(of, a) && takes_part(of, b))) return false;
  if (!rules_.start_reach().may_meet_faces(*pair, first, second, a.surface)) return false;
  if (rules_[*pair].only_ties() && n_searches_ > 0) return false;  // what was near at the start is tied
  if (a.side.element() == b.side.element() || contact_mesh_.share_node(a, b)) return false;
  if (are_skins_of_one(a.side, a.corners[0], b.side, b.corners[0])) return false;
  if (are_of_one_rigid_body(a.corners, b.corners)) return false;
  return !adjacent_.are_adjacent(first, second);
}

bool ContactSearch::node_may_meet(SurfaceNodeIndex row, FaceIndex index) const {
  const SurfaceNode& node = contact_mesh_.surface_nodes[row];
  const ContactFace& face = contact_mesh_.faces[index];
  const OptionalIndex<PairIndex> pair = rules_.find(node.surface, face.surface);
  if (!pair) return false;
  const SurfacePair& of = *rules_[*pair].pair;
  if (rules_[*pair].only_ties() && n_searches_ > 0) return false;
  // Balls have no faces: they meet those of others as nodes, whatever the formulation.
  const bool is_sphere = node.radius > 0.0f;
  if (!is_sphere && !node.is_free && of.formulation != ConstraintFormulation::node_face) return false;
  if (!is_sphere && of.is_one_sided && (of.first != face.surface || of.second != node.surface)) return false;
  if (!rules_.start_reach().may_meet_node(*pair, row, index, node.surface)) return false;
  if (!(takes_part(of, node) && takes_part(of, face))) return false;
  if (are_of_one_rigid_body({&node.node, 1}, face.corners)) return false;
  return !has_element_of(node.node, face) && !adjacent_.are_adjacent(node, index);
}

bool ContactSearch::edges_may_meet(EdgeIndex first, EdgeIndex second) const {
  const ContactEdge &a = contact_mesh_.edges[first], &b = contact_mesh_.edges[second];
  const OptionalIndex<PairIndex> pair = rules_.find(a.surface, b.surface);
  if (!pair || rules_[*pair].only_ties()) return false;
  if (!rules_.start_reach().may_meet_edges(*pair, first, second, a.surface)) return false;
  // Balls meet the edges of faces together with the faces.
  if ((a.is_sharp() && b.is_particle()) || (a.is_particle() && b.is_sharp())) return false;
  if (a.is_sharp() && b.is_sharp() && !(a.is_feature && b.is_feature)) return false;
  if (a.is_sharp() && b.is_sharp() && (is_smoothed(a, *pair) || is_smoothed(b, *pair))) return false;
  if (a.is_sharp() && b.is_sharp() && are_skins_of_one(a.side, a.nodes[0], b.side, b.nodes[0])) return false;
  if (are_of_one_rigid_body(a.nodes, b.nodes)) return false;
  const auto is_of_b = [&](std::uint32_t node) {
    const std::uint32_t alike = contact_mesh_.first_alike[node];
    return alike == contact_mesh_.first_alike[b.nodes[0]] || alike == contact_mesh_.first_alike[b.nodes[1]];
  };
  return !std::ranges::any_of(a.nodes, is_of_b) && !adjacent_.are_adjacent(a, b);
}

bool ContactSearch::is_smoothed(const ContactEdge& edge, PairIndex pair) const {
  return contact_mesh_.smooth_faces.go_on(rules_[pair].pair->smoothing, (*edge.faces)[0], (*edge.faces)[1]);
}

std::int32_t ContactSearch::rigid_body_of(std::span<const std::uint32_t> nodes) const {
  if (body_of_.empty()) return -1;
  const auto body = [&](std::uint32_t node) { return body_of_[contact_mesh_.mesh_nodes[node]]; };
  const std::int32_t first = body(nodes[0]);
  return std::ranges::all_of(nodes, [&](std::uint32_t node) { return body(node) == first; }) ? first : -1;
}

bool ContactSearch::are_skins_of_one(ElementSide first, std::uint32_t first_node, ElementSide second,
                                     std::uint32_t second_node) const {
  const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
  if (first_node >= n_mesh_points || second_node >= n_mesh_points) return false;
  const auto nodes = mesh_.element_nodes(first.element());
  return std::ranges::any_of(mesh_.element_nodes(second.element()),
                             [&](NodeIndex node) { return std::ranges::find(nodes, node) != nodes.end(); });
}

bool ContactSearch::has_element_of(std::uint32_t node, const ContactFace& face) const {
  const auto nodes = mesh_.element_nodes(face.side.element());
  return std::find(nodes.begin(), nodes.end(), NodeIndex{contact_mesh_.mesh_nodes[node]}) != nodes.end();
}

}  // namespace contactsim
