// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_removal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "contact/node_face.hpp"
#include "contact/overlap_parts.hpp"

namespace contactsim {

namespace {

/// Overlap below this share of the face's size is round-off.
constexpr double smallest_share = 1e-9;
/// A node in a valley between faces is over none of them, but beside them by less than this share of its
/// depth.
constexpr double beside_share = 0.25;

/// A node's surface looks against a face when the cosine of their normals is less; the corner of a cube
/// against a flat face has -0.58.
constexpr double against_cosine = -0.25;

/// A node behind something.
struct Overlap {
  std::uint32_t node = 0;                            ///< position in OverlapParts::nodes
  double depth = 0.0;                                ///< <= 0 is in front [length]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, the way out [1]
  bool can_share = false;                            ///< the other side can move too
};

class OverlapRemover {
 public:
  OverlapRemover(const ContactModel& model, const Mesh& mesh, std::span<const std::uint8_t> is_held)
      : model_(model),
        parts_(make_overlap_parts(model, mesh)),
        is_held_(is_held),
        coordinates_(mesh.coordinates()),
        deepest_(model.pairs.size(), 0.0),
        moved_(model.pairs.size()) {}

  /// Returns whether anything was moved.
  bool pass(bool is_last);
  OverlapRemoved take();

 private:
  /// The nodes of a pair in order, each as it stands when its turn comes.
  void for_each_overlap(std::uint32_t pair, const std::function<void(const Overlap&)>& act) const;
  /// The way out of several faces is the shortest one; in front of the nearest face a node is outside.
  std::optional<Overlap> find_behind_faces(const SurfacePair& pair,
                                           std::span<const OverlapCandidate> of_node) const;
  std::optional<Overlap> find_near_face(const SurfacePair& pair, const OverlapCandidate& candidate) const;
  std::optional<Overlap> find_behind_plane(const SurfacePair& pair, const OverlapCandidate& candidate) const;
  bool looks_against(const OverlapNode& node, const Eigen::Vector3d& normal) const;
  bool can_move(const SurfacePair& pair, const OverlapFace& face) const;
  bool is_held(std::uint32_t node) const { return !is_held_.empty() && is_held_[node] != 0; }
  bool move(std::uint32_t pair, const Overlap& overlap, double share);

  const ContactModel& model_;
  OverlapParts parts_;
  std::span<const std::uint8_t> is_held_;
  Eigen::Matrix3Xd coordinates_;
  std::vector<double> deepest_;                                  ///< [n_pairs] found so far [length]
  std::vector<std::map<std::uint32_t, Eigen::Vector3d>> moved_;  ///< [n_pairs] by mesh node [length]
};

/// Whether the surface of a node looks back at a face, so that the node is about to pass through it.
bool OverlapRemover::looks_against(const OverlapNode& node, const Eigen::Vector3d& normal) const {
  const bool has_faces = node.size > 0.0;
  return !has_faces || node.normal.dot(normal) < against_cosine * node.normal.norm();
}

bool OverlapRemover::can_move(const SurfacePair& pair, const OverlapFace& face) const {
  const bool has_two_sides = model_.surfaces.surfaces[pair.second].kind == SurfaceKind::face;
  return has_two_sides && !std::all_of(face.nodes.begin(), face.nodes.end(),
                                       [&](std::uint32_t node) { return is_held(node); });
}

std::optional<Overlap> OverlapRemover::find_near_face(const SurfacePair& pair,
                                                      const OverlapCandidate& candidate) const {
  const OverlapNode& node = parts_.nodes[candidate.node];
  const OverlapFace& face = parts_.faces[candidate.partner];
  FaceCorners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = coordinates_.col(face.nodes[static_cast<std::size_t>(i)]);
  const auto point = project_onto_face(corners, face.is_triangle(), coordinates_.col(node.node));
  if (!point) return std::nullopt;
  const double least = smallest_share * face.size;
  const double depth = std::abs(point->gap) > least ? -point->gap : 0.0;
  const double deepest = pair.overlap_normal_tolerance.value_or(face.reach);
  const double beside =
      std::max({beside_share * depth, least, pair.overlap_tangential_tolerance.value_or(0.0)});
  const bool is_near = std::abs(depth) <= deepest && point->beyond <= beside;
  if (!is_near || !looks_against(node, point->normal)) return std::nullopt;
  // On a face a node is outside, but one without a surface of its own may lie in the face's rim and go in
  // there.
  if (depth == 0.0 && node.size == 0.0) return std::nullopt;
  return Overlap{candidate.node, depth, point->normal, can_move(pair, face)};
}

std::optional<Overlap> OverlapRemover::find_behind_faces(const SurfacePair& pair,
                                                         std::span<const OverlapCandidate> of_node) const {
  std::optional<Overlap> least;
  for (const OverlapCandidate& candidate : of_node) {
    const auto found = find_near_face(pair, candidate);
    if (found && (!least || std::abs(found->depth) < std::abs(least->depth))) least = found;
  }
  return least && least->depth > 0.0 ? least : std::nullopt;
}

std::optional<Overlap> OverlapRemover::find_behind_plane(const SurfacePair& pair,
                                                         const OverlapCandidate& candidate) const {
  const OverlapNode& node = parts_.nodes[candidate.node];
  const AnalyticPlane& plane = model_.planes[candidate.partner];
  const Eigen::Vector3d normal = plane.normal.stableNormalized();
  const double depth = (plane.origin - coordinates_.col(node.node)).dot(normal);
  const double deepest = pair.overlap_normal_tolerance.value_or(node.reach);
  const bool is_behind = depth > smallest_share * node.size && depth <= deepest;
  if (!is_behind || !looks_against(node, normal)) return std::nullopt;
  return Overlap{candidate.node, depth, normal, false};
}

void OverlapRemover::for_each_overlap(std::uint32_t pair,
                                      const std::function<void(const Overlap&)>& act) const {
  const OverlapSites& sites = parts_.sites[pair];
  const std::span<const OverlapCandidate> faces = sites.faces;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].node == faces[begin].node) ++end;
    if (const auto found = find_behind_faces(model_.pairs[pair], faces.subspan(begin, end - begin)))
      act(*found);
  }
  for (const OverlapCandidate& candidate : sites.planes) {
    if (const auto found = find_behind_plane(model_.pairs[pair], candidate)) act(*found);
  }
}

bool OverlapRemover::move(std::uint32_t pair, const Overlap& overlap, double share) {
  const std::uint32_t node = parts_.nodes[overlap.node].node;
  deepest_[pair] = std::max(deepest_[pair], overlap.depth);
  if (is_held(node)) return false;
  const Eigen::Vector3d step = share * overlap.depth * overlap.normal;
  coordinates_.col(node) += step;
  moved_[pair].try_emplace(node, Eigen::Vector3d::Zero()).first->second += step;
  return true;
}

bool OverlapRemover::pass(bool is_last) {
  bool has_moved = false;
  for (std::uint32_t p = 0; p < model_.pairs.size(); ++p) {
    if (is_last) {
      // One node at a time, or both sides would go the whole way.
      for_each_overlap(p, [&](const Overlap& overlap) { has_moved |= move(p, overlap, 1.0); });
      continue;
    }
    std::vector<Overlap> overlaps;
    for_each_overlap(p, [&](const Overlap& overlap) { overlaps.push_back(overlap); });
    for (const Overlap& overlap : overlaps) has_moved |= move(p, overlap, overlap.can_share ? 0.5 : 1.0);
  }
  return has_moved;
}

OverlapRemoved OverlapRemover::take() {
  OverlapRemoved removed;
  for (std::uint32_t p = 0; p < model_.pairs.size(); ++p) {
    if (deepest_[p] == 0.0) continue;
    OverlapMoves moves;
    moves.pair = p;
    moves.n_nodes = static_cast<std::uint32_t>(moved_[p].size());
    moves.deepest = deepest_[p];
    for (const auto& [node, way] : moved_[p]) {
      if (way.norm() <= moves.largest) continue;
      moves.largest = way.norm();
      moves.largest_node = {node};
    }
    for_each_overlap(p, [&](const Overlap& overlap) { moves.left = std::max(moves.left, overlap.depth); });
    removed.moves.push_back(moves);
  }
  removed.coordinates = std::move(coordinates_);
  return removed;
}

}  // namespace

OverlapRemoved remove_overlap(const ContactModel& model, const Mesh& mesh, std::int64_t iterations,
                              std::span<const std::uint8_t> is_held) {
  OverlapRemover remover(model, mesh, is_held);
  std::int64_t n_passes = 0;
  while (n_passes < iterations && remover.pass(n_passes + 1 == iterations)) ++n_passes;
  OverlapRemoved removed = remover.take();
  removed.n_passes = n_passes;
  return removed;
}

}  // namespace contactsim
