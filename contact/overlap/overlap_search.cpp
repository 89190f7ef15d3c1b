// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_search.hpp"

#include <algorithm>

#include "contact/search/shell_sides.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

namespace {

/// A box around points in columns, wider by a margin.
template <class Points>
Box box_around(const Points& points, double margin) {
  const Eigen::Vector3d lo = points.rowwise().minCoeff(), hi = points.rowwise().maxCoeff();
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = lo[static_cast<Eigen::Index>(k)] - margin;
    box.hi[k] = hi[static_cast<Eigen::Index>(k)] + margin;
  }
  return box;
}

}  // namespace

OverlapSearch::OverlapSearch(const ContactModel& model, const ContactDefinition& definition, const Mesh& mesh,
                             const OverlapParts& parts)
    : model_(model),
      mesh_(mesh),
      parts_(parts),
      rules_(model.pairs, std::vector<ActiveTimes>(model.pairs.size()), model.surfaces.surfaces.size()),
      adjacent_(parts.contact_mesh, mesh),
      sites_(model.pairs.size()) {
  has_lofts_ = std::ranges::any_of(parts.contact_mesh.surface_nodes,
                                   [&](const SurfaceNode& node) { return parts.is_lofted(node); });
  for (const SurfacePair& pair : model.pairs)
    deepest_ = std::max(deepest_, pair.overlap_normal_tolerance.value_or(0.0));
  spare_ = std::numeric_limits<double>::infinity();
  for (const FaceIndex i : indices(parts.contact_mesh.faces)) {
    if (parts.contact_mesh.is_lofted(parts.contact_mesh.faces[i]))
      spare_ = std::min(spare_, 0.5 * parts.of_face[i].half_thickness);
  }
  for (const SurfaceNode& node : parts.contact_mesh.surface_nodes) {
    if (node.radius > 0.0f) spare_ = std::min<double>(spare_, 0.5 * node.radius);
  }
  if (!parts.contact_mesh.edges.empty())
    edges_.emplace(parts.contact_mesh, mesh, rules_, definition.search, definition.dash);
}

void OverlapSearch::find(const ContactKinematics& kinematics) {
  add_planes();
  add_faces(kinematics, false);
  add_edges(kinematics);
  if (!has_lofts_) return;
  add_rims(kinematics);
  note_positions(kinematics);
}

void OverlapSearch::renew_lofts(const ContactKinematics& kinematics) {
  if (!has_lofts_) return;
  for (PairSites& sites : sites_) sites.edges.clear();
  add_edges(kinematics);
  if (!is_due(kinematics)) return;
  for (PairSites& sites : sites_) {
    sites.lofted.faces.clear();
    sites.rims.clear();
  }
  add_faces(kinematics, true);
  add_rims(kinematics);
  note_positions(kinematics);
}

void OverlapSearch::note_positions(const ContactKinematics& kinematics) {
  searched_at_.resize(3, static_cast<Eigen::Index>(parts_.contact_mesh.n_nodes()));
  for (const ContactNodeIndex i : parts_.contact_mesh.nodes()) searched_at_.col(i.value) = kinematics.x(i);
}

bool OverlapSearch::is_due(const ContactKinematics& kinematics) const {
  for (const ContactNodeIndex i : parts_.contact_mesh.nodes()) {
    if ((kinematics.x(i) - searched_at_.col(i.value)).norm() > spare_) return true;
  }
  return false;
}

void OverlapSearch::add_planes() {
  const ContactMesh& contact_mesh = parts_.contact_mesh;
  const auto add = [&](SurfaceIndex with_planes, SurfaceIndex with_nodes, PairSites& sites) {
    for (const std::uint32_t plane : model_.surfaces.surfaces[with_planes].analytic_planes) {
      for (const SurfaceNodeIndex i : contact_mesh.rows_of(with_nodes)) {
        const bool is_lofted = parts_.is_lofted(contact_mesh.surface_nodes[i]);
        (is_lofted ? sites.lofted : sites.meshed).planes.push_back({i, plane});
      }
    }
  };
  for (const PairIndex p : indices(model_.pairs)) {
    const SurfacePair& pair = model_.pairs[p];
    add(pair.first, pair.second, sites_[p]);
    if (pair.first != pair.second) add(pair.second, pair.first, sites_[p]);
  }
}

Box OverlapSearch::box_of_node(const ContactKinematics& kinematics, SurfaceNodeIndex row) const {
  const SurfaceNode& node = parts_.contact_mesh.surface_nodes[row];
  // A sphere may be pushed on by as much as it is thick.
  return box_around(kinematics.x(node.node), 2.0 * static_cast<double>(node.radius));
}

Box OverlapSearch::box_of_face(const ContactKinematics& kinematics, FaceIndex face) const {
  const auto& corners = parts_.contact_mesh.faces[face].corners;
  FaceCorners x;
  for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = kinematics.x(corners[k]);
  // Both sides move, each by no more than the deepest overlap.
  return box_around(x, 2.0 * std::max(parts_.of_face[face].half_thickness, deepest_) +
                           parts_.contact_mesh.smooth_faces.extent(face).height);
}

bool OverlapSearch::may_meet(SurfaceNodeIndex row, FaceIndex index) const {
  const ContactMesh& contact_mesh = parts_.contact_mesh;
  const SurfaceNode& node = contact_mesh.surface_nodes[row];
  const ContactFace& face = contact_mesh.faces[index];
  const OptionalIndex<PairIndex> pair = rules_.find(node.surface, face.surface);
  if (!pair) return false;
  const SurfacePair& of = *rules_[*pair].pair;
  if (!takes_part(of, node, contact_mesh, mesh_) || !takes_part(of, face, contact_mesh, mesh_)) return false;
  const auto own = mesh_.element_nodes(face.side.element());
  return std::ranges::find(own, contact_mesh.mesh_nodes[node.node]) == own.end();
}

void OverlapSearch::add_faces(const ContactKinematics& kinematics, bool is_of_lofts_only) {
  const ContactMesh& contact_mesh = parts_.contact_mesh;
  if (contact_mesh.faces.empty() || contact_mesh.surface_nodes.empty()) return;
  if (nodes_.update(indices(contact_mesh.surface_nodes),
                    [&](SurfaceNodeIndex row) { return box_of_node(kinematics, row); }))
    return;
  if (faces_.update(indices(contact_mesh.faces),
                    [&](FaceIndex face) { return box_of_face(kinematics, face); }))
    return;
  const auto may_meet_now = [&](SurfaceNodeIndex row, FaceIndex face) {
    return (!is_of_lofts_only || is_lofted(row, face)) && may_meet(row, face);
  };
  NodeFaceLists near;
  nodes_.find_pairs(faces_, may_meet_now, near);
  for (const SurfaceNodeIndex row : near.rows()) {
    const SurfaceIndex own = contact_mesh.surface_nodes[row].surface;
    for (const FaceIndex face : near.of(row)) {
      PairSites& sites = sites_[*rules_.find(own, contact_mesh.faces[face].surface)];
      (is_lofted(row, face) ? sites.lofted : sites.meshed).faces.push_back({row, face});
    }
  }
}

void OverlapSearch::add_edges(const ContactKinematics& kinematics) {
  if (!edges_) return;
  const auto& edges = parts_.contact_mesh.edges;
  EdgePairLists near;
  edges_->find_edge_pairs(kinematics, {0.0, 0.0, mesh_.coordinates(), mesh_.coordinates()}, {}, near);
  for (const EdgeIndex i : near.rows()) {
    for (const EdgeIndex other : near.of(i)) {
      if (edges[i].is_sharp() && edges[other].is_sharp()) continue;
      sites_[*rules_.find(edges[i].surface, edges[other].surface)].edges.push_back({i, other});
    }
  }
}

bool OverlapSearch::may_cross(const ContactKinematics& kinematics, FaceIndex first, FaceIndex second) const {
  const ContactFace &a = parts_.contact_mesh.faces[first], &b = parts_.contact_mesh.faces[second];
  if (!parts_.contact_mesh.is_lofted(a) && !parts_.contact_mesh.is_lofted(b)) return false;
  const OptionalIndex<PairIndex> pair = rules_.find(a.surface, b.surface);
  if (!pair) return false;
  const SurfacePair& of = *rules_[*pair].pair;
  if (!takes_part(of, a, parts_.contact_mesh, mesh_) || !takes_part(of, b, parts_.contact_mesh, mesh_))
    return false;
  if (a.side.element() == b.side.element() || parts_.contact_mesh.share_node(a, b)) return false;
  return kinematics.area(a).dot(kinematics.area(b)) < 0.0;
}

/// By the boxes of faces that nodes have been looked for in.
void OverlapSearch::add_rims(const ContactKinematics& kinematics) {
  const auto& faces = parts_.contact_mesh.faces;
  if (faces.empty()) return;
  FacePairLists near;
  faces_.find_pairs([&](FaceIndex a, FaceIndex b) { return may_cross(kinematics, a, b); }, near);
  for (const FaceIndex i : near.rows()) {
    for (const FaceIndex other : near.of(i))
      sites_[*rules_.find(faces[i].surface, faces[other].surface)].rims.push_back({i, other});
  }
}

}  // namespace contactsim
