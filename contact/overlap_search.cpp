// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_search.hpp"

#include <algorithm>

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
      joined_(parts.faces, mesh),
      sites_(model.pairs.size()) {
  has_lofts_ = std::ranges::any_of(parts.faces.surface_nodes,
                                   [&](const SurfaceNode& node) { return parts.is_lofted(node); });
  for (const SurfacePair& pair : model.pairs)
    deepest_ = std::max(deepest_, pair.overlap_normal_tolerance.value_or(0.0));
  spare_ = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < parts.faces.faces.size(); ++i) {
    if (parts.faces.is_lofted(parts.faces.faces[i])) spare_ = std::min(spare_, 0.5 * parts.of_face[i].reach);
  }
  for (const SurfaceNode& node : parts.faces.surface_nodes) {
    if (node.radius > 0.0f) spare_ = std::min<double>(spare_, 0.5 * node.radius);
  }
  if (!parts.faces.edges.empty())
    edges_.emplace(parts.faces, mesh, rules_, definition.search, definition.dash);
}

void OverlapSearch::find(const MovingSurface& surface) {
  add_planes();
  add_faces(surface, false);
  add_edges(surface);
  if (!has_lofts_) return;
  add_rims(surface);
  note_places(surface);
}

void OverlapSearch::renew_lofts(const MovingSurface& surface) {
  if (!has_lofts_) return;
  for (PairSites& sites : sites_) sites.edges.clear();
  add_edges(surface);
  if (!is_due(surface)) return;
  for (PairSites& sites : sites_) {
    sites.lofted.faces.clear();
    sites.rims.clear();
  }
  add_faces(surface, true);
  add_rims(surface);
  note_places(surface);
}

void OverlapSearch::note_places(const MovingSurface& surface) {
  searched_at_.resize(3, static_cast<Eigen::Index>(parts_.faces.n_nodes()));
  for (std::uint32_t i = 0; i < parts_.faces.n_nodes(); ++i) searched_at_.col(i) = surface.x(i);
}

bool OverlapSearch::is_due(const MovingSurface& surface) const {
  for (std::uint32_t i = 0; i < parts_.faces.n_nodes(); ++i) {
    if ((surface.x(i) - searched_at_.col(i)).norm() > spare_) return true;
  }
  return false;
}

void OverlapSearch::add_planes() {
  const ContactFaces& faces = parts_.faces;
  const auto add = [&](std::uint32_t with_planes, std::uint32_t with_nodes, PairSites& sites) {
    for (const std::uint32_t plane : model_.surfaces.surfaces[with_planes].analytic_planes) {
      for (std::uint32_t i = faces.first_node[with_nodes]; i < faces.first_node[with_nodes + 1]; ++i) {
        const bool is_lofted = parts_.is_lofted(faces.surface_nodes[i]);
        (is_lofted ? sites.lofted : sites.meshed).planes.push_back({i, plane});
      }
    }
  };
  for (std::uint32_t p = 0; p < model_.pairs.size(); ++p) {
    const SurfacePair& pair = model_.pairs[p];
    add(pair.first, pair.second, sites_[p]);
    if (pair.first != pair.second) add(pair.second, pair.first, sites_[p]);
  }
}

Box OverlapSearch::box_of_node(const MovingSurface& surface, std::uint32_t row) const {
  const SurfaceNode& node = parts_.faces.surface_nodes[row];
  // A ball may be pushed on by as much as it is thick.
  return box_around(surface.x(node.node), 2.0 * static_cast<double>(node.radius));
}

Box OverlapSearch::box_of_face(const MovingSurface& surface, std::uint32_t face) const {
  const auto& corners = parts_.faces.faces[face].corners;
  FaceCorners x;
  for (std::size_t k = 0; k < 4; ++k) x.col(static_cast<Eigen::Index>(k)) = surface.x(corners[k]);
  // Both sides move, each by no more than the deepest overlap.
  return box_around(x, 2.0 * std::max(parts_.of_face[face].reach, deepest_));
}

bool OverlapSearch::may_meet(std::uint32_t row, std::uint32_t index) const {
  const ContactFaces& faces = parts_.faces;
  const SurfaceNode& node = faces.surface_nodes[row];
  const ContactFace& face = faces.faces[index];
  if (rules_.find(node.surface, face.surface) == PairRules::none) return false;
  const auto own = mesh_.element_nodes(face.side.element());
  return std::ranges::find(own, NodeIndex{faces.mesh_nodes[node.node]}) == own.end();
}

void OverlapSearch::add_faces(const MovingSurface& surface, bool is_of_lofts_only) {
  const ContactFaces& faces = parts_.faces;
  if (faces.faces.empty() || faces.surface_nodes.empty()) return;
  const auto n_nodes = static_cast<std::uint32_t>(faces.surface_nodes.size());
  const auto n_faces = static_cast<std::uint32_t>(faces.faces.size());
  if (nodes_.update(n_nodes, [&](std::uint32_t row) { return box_of_node(surface, row); })) return;
  if (faces_.update(n_faces, [&](std::uint32_t face) { return box_of_face(surface, face); })) return;
  const auto may_meet_now = [&](std::uint32_t row, std::uint32_t face) {
    return (!is_of_lofts_only || is_lofted(row, face)) && may_meet(row, face);
  };
  PairLists near;
  nodes_.find_pairs(faces_, may_meet_now, near);
  for (std::uint32_t row = 0; row < near.n_rows(); ++row) {
    const std::uint32_t own = faces.surface_nodes[row].surface;
    for (const std::uint32_t face : near.of(row)) {
      PairSites& sites = sites_[rules_.find(own, faces.faces[face].surface)];
      (is_lofted(row, face) ? sites.lofted : sites.meshed).faces.push_back({row, face});
    }
  }
}

void OverlapSearch::add_edges(const MovingSurface& surface) {
  if (!edges_) return;
  const auto& edges = parts_.faces.edges;
  PairLists near;
  edges_->find_edges(surface, {0.0, 0.0, mesh_.coordinates(), mesh_.coordinates()}, near);
  for (std::uint32_t i = 0; i < near.n_rows(); ++i) {
    for (const std::uint32_t other : near.of(i)) {
      if (edges[i].is_sharp() && edges[other].is_sharp()) continue;
      sites_[rules_.find(edges[i].surface, edges[other].surface)].edges.push_back({i, other});
    }
  }
}

bool OverlapSearch::may_cross(const MovingSurface& surface, std::uint32_t first, std::uint32_t second) const {
  const ContactFace &a = parts_.faces.faces[first], &b = parts_.faces.faces[second];
  if (!parts_.faces.is_lofted(a) && !parts_.faces.is_lofted(b)) return false;
  if (rules_.find(a.surface, b.surface) == PairRules::none) return false;
  if (a.side.element() == b.side.element() || parts_.faces.share_node(a, b)) return false;
  return surface.area(a).dot(surface.area(b)) < 0.0;
}

/// By the boxes of faces that nodes have been looked for in.
void OverlapSearch::add_rims(const MovingSurface& surface) {
  const auto& faces = parts_.faces.faces;
  if (faces.empty()) return;
  PairLists near;
  faces_.find_pairs([&](std::uint32_t a, std::uint32_t b) { return may_cross(surface, a, b); }, near);
  for (std::uint32_t i = 0; i < near.n_rows(); ++i) {
    for (const std::uint32_t other : near.of(i))
      sites_[rules_.find(faces[i].surface, faces[other].surface)].rims.push_back({i, other});
  }
}

}  // namespace contactsim
