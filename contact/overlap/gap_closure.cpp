// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/gap_closure.hpp"

#include <algorithm>
#include <limits>

#include "contact/geometry/face_bound.hpp"
#include "contact/mesh/mean_edge.hpp"

namespace contactsim {

namespace {

/// AUTO over the mean edge of the faces. Source: ADJUST = AUTO of OptiStruct's CONTACT, 5 %.
constexpr double automatic_share = 0.05;

}  // namespace

double find_closure_tolerance(const ContactKinematics& start, const SurfacePair& pair) {
  if (!pair.gap_closure) return 0.0;
  const double tolerance = pair.gap_closure->given.value_or(automatic_share * mean_edge(start, pair));
  return pair.search_distance ? std::min(tolerance, find_search_distance(start, pair)) : tolerance;
}

GapClosure::GapClosure(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts,
                       const OverlapSearch& search, const OverlapDetection& detection,
                       const ShiftedPoints& points)
    : model_(model), parts_(parts), detection_(detection), points_(points) {
  for (const PairIndex p : indices(model.pairs)) {
    const SurfacePair& pair = model.pairs[p];
    if (pair.adjusted_node_set) {
      add_set(p, mesh, *pair.adjusted_node_set);
    } else if (pair.gap_closure) {
      const double tolerance = find_closure_tolerance(points.renewed(), pair);
      add_near(p, search.sites()[p].meshed, tolerance);
      add_near(p, search.sites()[p].lofted, tolerance);
    }
  }
}

bool GapClosure::may_go(const SurfacePair& pair, SurfaceNodeIndex row) const {
  return !pair.side_b || parts_.contact_mesh.surface_nodes[row].surface == *pair.side_b;
}

void GapClosure::add(ClosingNode node) {
  if (find_gap(node)) nodes_.push_back(std::move(node));
}

void GapClosure::add_near(PairIndex pair, const OverlapSites& sites, double tolerance) {
  const std::span<const NodeFaceCandidate> faces = sites.faces;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].entity == faces[begin].entity) ++end;
    const auto of_node = faces.subspan(begin, end - begin);
    if (may_go(model_.pairs[pair], faces[begin].entity))
      add({pair, tolerance, {of_node.begin(), of_node.end()}, {}});
  }
  for (const NodePlaneCandidate& candidate : sites.planes) {
    if (may_go(model_.pairs[pair], candidate.entity)) add({pair, tolerance, {}, {candidate}});
  }
}

/// A few nodes at any distance: every face is looked at.
void GapClosure::add_set(PairIndex index, const Mesh& mesh, std::uint32_t set) {
  constexpr double far = std::numeric_limits<float>::max();
  const SurfacePair& pair = model_.pairs[index];
  const ContactMesh& contact_mesh = parts_.contact_mesh;
  const auto is_in_set = [&](const SurfaceNode& node) {
    const NodeIndex own{contact_mesh.mesh_nodes[node.node]};
    return std::ranges::find(mesh.node_sets()[set].nodes, own) != mesh.node_sets()[set].nodes.end();
  };
  for (const auto& [own, other] : {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
    for (const SurfaceNodeIndex row : contact_mesh.rows_of(own)) {
      const SurfaceNode& node = contact_mesh.surface_nodes[row];
      if (!is_in_set(node)) continue;
      ClosingNode closing{index, far, {}, {}};
      for (const FaceIndex face : contact_mesh.faces_of(other)) {
        const auto& corners = contact_mesh.faces[face].corners;
        if (std::ranges::find(corners, node.node) != corners.end()) continue;
        const FaceBound bound(points_.corners(contact_mesh.faces[face]), FaceCorners::Zero(),
                              contact_mesh.faces[face].is_triangle());
        if (may_project_inside(points_.at(node.node), bound, far, far, node.radius))
          closing.faces.push_back({row, face});
      }
      for (const std::uint32_t plane : model_.surfaces.surfaces[other].analytic_planes)
        closing.planes.push_back({row, plane});
      add(std::move(closing));
    }
    if (pair.first == pair.second) break;
  }
}

std::optional<Overlap> GapClosure::find_gap(const ClosingNode& node) const {
  if (!node.faces.empty()) {
    if (const auto found = detection_.find_before_faces(model_.pairs[node.pair], node.faces, node.reach))
      return found;
  }
  for (const NodePlaneCandidate& plane : node.planes) {
    if (const auto found = detection_.find_before_plane(plane, node.reach)) return found;
  }
  return std::nullopt;
}

bool GapClosure::pass(bool is_last, SideMover& mover) const {
  struct Way {
    PairIndex pair;
    Overlap gap;
  };
  std::vector<Way> ways;
  bool has_moved = false;
  for (const ClosingNode& node : nodes_) {
    const auto gap = find_gap(node);
    if (!gap) continue;
    if (is_last) {
      has_moved |= mover.resolve(node.pair, *gap, gap->depth);
    } else {
      ways.push_back({node.pair, *gap});
    }
  }
  for (const Way& way : ways)
    has_moved |= mover.resolve(way.pair, way.gap, mover.share_of_first(way.pair, way.gap) * way.gap.depth);
  return has_moved;
}

double GapClosure::widest(PairIndex pair) const {
  double widest = 0.0;
  for (const ClosingNode& node : nodes_) {
    if (node.pair != pair) continue;
    if (const auto gap = find_gap(node)) widest = std::max(widest, -gap->depth);
  }
  return widest;
}

}  // namespace contactsim
