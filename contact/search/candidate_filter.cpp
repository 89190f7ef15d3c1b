// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/candidate_filter.hpp"

#include <algorithm>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

bool has_to_face(const PairRule& rule, bool is_once) {
  return rule.law == ContactLaw::sliding && !rule.far && !rule.model.is_variant() && !rule.may_act_apart() &&
         rule.pair->separates && !rule.pair->gap.needs_start() &&
         rule.pair->behavior != InteractionBehavior::infinitesimal_sliding && !is_once;
}

}  // namespace

CandidateFilter::CandidateFilter(const ContactMesh& contact_mesh, const Mesh& mesh, const PairRules& rules,
                                 bool is_once, std::span<const OptionalIndex<std::uint32_t>> body_of)
    : contact_mesh_(contact_mesh),
      mesh_(mesh),
      rules_(rules),
      adjacent_(contact_mesh, mesh),
      body_of_(body_of) {
  for (const PairRule& rule : rules.rules())
    has_to_face_.push_back(contactsim::has_to_face(rule, is_once) ? 1 : 0);
  set_spans();
}

void CandidateFilter::renew() {
  adjacent_.renew(mesh_);
  set_spans();
}

void CandidateFilter::set_spans() {
  const auto n = static_cast<std::uint32_t>(contact_mesh_.faces.size());
  element_spans_.resize(n);
  parallel_for(n, threads_for(n), [this](std::uint32_t i) {
    const auto [lowest, highest] =
        std::ranges::minmax(mesh_.element_nodes(contact_mesh_.faces[{i}].side.element()));
    element_spans_[{i}] = {lowest, highest};
  });
}

OptionalIndex<PairIndex> CandidateFilter::pair_of_faces(FaceIndex first, FaceIndex second) const {
  const auto pair = rules_.find(contact_mesh_.faces[first].surface, contact_mesh_.faces[second].surface);
  const bool is_of_faces = pair && rules_[*pair].pair->formulation == ConstraintFormulation::face_face;
  return is_of_faces ? pair : OptionalIndex<PairIndex>();
}

bool CandidateFilter::faces_may_meet(PairIndex pair, FaceIndex first, FaceIndex second) const {
  const ContactFace &a = contact_mesh_.faces[first], &b = contact_mesh_.faces[second];
  const SurfacePair& of = *rules_[pair].pair;
  if (!(takes_part(of, a) && takes_part(of, b))) return false;
  if (!rules_.start_reach().may_meet_faces(pair, first, second, a.surface)) return false;
  if (rules_[pair].only_ties() && !is_first_search_) return false;
  if (a.side.element() == b.side.element() || contact_mesh_.share_node(a, b)) return false;
  if (are_skins_of_one(first, second)) return false;
  if (are_of_one_rigid_body(a.corners, b.corners)) return false;
  return !adjacent_.are_adjacent(first, second);
}

bool CandidateFilter::node_may_meet(SurfaceNodeIndex row, FaceIndex index) const {
  const SurfaceNode& node = contact_mesh_.surface_nodes[row];
  const ContactFace& face = contact_mesh_.faces[index];
  const OptionalIndex<PairIndex> pair = rules_.find(node.surface, face.surface);
  if (!pair) return false;
  const SurfacePair& of = *rules_[*pair].pair;
  if (rules_[*pair].only_ties() && !is_first_search_) return false;
  // Balls have no faces: they meet those of others as nodes, whatever the formulation.
  const bool is_sphere = node.radius > 0.0f;
  if (!is_sphere && !node.is_free && of.formulation != ConstraintFormulation::node_face) return false;
  if (!is_sphere && of.is_one_sided && (of.first != face.surface || of.second != node.surface)) return false;
  if (!rules_.start_reach().may_meet_node(*pair, row, index, node.surface)) return false;
  if (!(takes_part(of, node) && takes_part(of, face))) return false;
  if (are_of_one_rigid_body({&node.node, 1}, face.corners)) return false;
  return !has_element_of(node.node, face) && !adjacent_.are_adjacent(node, index);
}

bool CandidateFilter::edges_may_meet(EdgeIndex first, EdgeIndex second) const {
  const ContactEdge &a = contact_mesh_.edges[first], &b = contact_mesh_.edges[second];
  const OptionalIndex<PairIndex> pair = rules_.find(a.surface, b.surface);
  if (!pair || rules_[*pair].only_ties()) return false;
  if (!rules_.start_reach().may_meet_edges(*pair, first, second, a.surface)) return false;
  // Balls meet the edges of faces together with the faces.
  if ((a.is_sharp() && b.is_particle()) || (a.is_particle() && b.is_sharp())) return false;
  if (a.is_sharp() && b.is_sharp() && !(a.is_feature && b.is_feature)) return false;
  if (a.is_sharp() && b.is_sharp() && (is_smoothed(a, *pair) || is_smoothed(b, *pair))) return false;
  if (a.is_sharp() && b.is_sharp() && are_skins_of_one((*a.faces)[0], (*b.faces)[0])) return false;
  if (are_of_one_rigid_body(a.nodes, b.nodes)) return false;
  const auto is_of_b = [&](ContactNodeIndex node) {
    const ContactNodeIndex alike = contact_mesh_.first_alike[node];
    return alike == contact_mesh_.first_alike[b.nodes[0]] || alike == contact_mesh_.first_alike[b.nodes[1]];
  };
  return !std::ranges::any_of(a.nodes, is_of_b) && !adjacent_.are_adjacent(a, b);
}

bool CandidateFilter::is_smoothed(const ContactEdge& edge, PairIndex pair) const {
  return contact_mesh_.smooth_faces.go_on(rules_[pair].pair->smoothing, (*edge.faces)[0], (*edge.faces)[1]);
}

OptionalIndex<std::uint32_t> CandidateFilter::rigid_body_of(std::span<const ContactNodeIndex> nodes) const {
  if (body_of_.empty()) return {};
  const auto body = [&](ContactNodeIndex node) { return body_of_[contact_mesh_.mesh_nodes[node].value]; };
  const OptionalIndex<std::uint32_t> first = body(nodes[0]);
  const bool is_one = std::ranges::all_of(nodes, [&](ContactNodeIndex node) { return body(node) == first; });
  return is_one ? first : OptionalIndex<std::uint32_t>();
}

bool CandidateFilter::are_skins_of_one(FaceIndex first, FaceIndex second) const {
  const NodeSpan &of_first = element_spans_[first], &of_second = element_spans_[second];
  if (of_first.highest < of_second.lowest || of_second.highest < of_first.lowest) return false;
  const ContactFace &a = contact_mesh_.faces[first], &b = contact_mesh_.faces[second];
  if (!contact_mesh_.is_mesh_point(a.corners[0]) || !contact_mesh_.is_mesh_point(b.corners[0])) return false;
  const auto nodes = mesh_.element_nodes(a.side.element());
  return std::ranges::any_of(mesh_.element_nodes(b.side.element()),
                             [&](NodeIndex node) { return std::ranges::find(nodes, node) != nodes.end(); });
}

bool CandidateFilter::has_element_of(ContactNodeIndex node, const ContactFace& face) const {
  const auto nodes = mesh_.element_nodes(face.side.element());
  return std::find(nodes.begin(), nodes.end(), contact_mesh_.mesh_nodes[node]) != nodes.end();
}

}  // namespace contactsim
