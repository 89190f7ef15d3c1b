// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_removal.hpp"

#include <algorithm>
#include <map>

#include "contact/overlap/body_parting.hpp"
#include "contact/overlap/overlap_detection.hpp"
#include "core/definition/contact.hpp"
#include "core/mesh/turned_elements.hpp"

namespace contactsim {

namespace {

/// What is left of an overlap after others of the pass have moved its sides is round-off below this share.
constexpr double remaining_share = 1e-9;

/// A side whose free nodes have this share of it or less would have to move them far: it counts as held.
constexpr double held_share = 0.3;

class OverlapRemover {
 public:
  OverlapRemover(const ContactModel& model, const Mesh& mesh, const ContactDefinition& definition,
                 std::span<const std::uint8_t> is_held)
      : model_(model),
        mesh_(mesh),
        settings_(definition.overlap_removal),
        parts_(make_overlap_parts(model, definition, mesh)),
        points_(parts_.contact_mesh, mesh),
        search_(model, definition, mesh, parts_),
        detection_(model, parts_, search_, points_, settings_.shell_tolerance),
        bodies_(model, mesh, parts_),
        is_held_(is_held),
        deepest_(model.pairs.size(), 0.0),
        moved_(model.pairs.size()) {
    part_bodies();
    search_.find(points_.renewed());
  }

  /// Returns whether anything was moved.
  ///   n_before  passes before this one
  bool pass(std::int64_t n_before);
  OverlapRemoved take();

 private:
  /// The pair that has moved the nodes of an element farthest.
  std::uint32_t culprit_of(ElementIndex element) const;
  /// Moves whole bodies out of what they lie deep in.
  void part_bodies();
  void renew_lofts() {
    points_.renew();
    search_.renew_lofts(points_.renewed());
  }
  bool pass_nodes(std::uint32_t pair, OverlapKind kind, bool is_last);
  bool pass_lofts(std::uint32_t pair, bool is_last);
  void note(std::uint32_t pair, const Overlap& overlap) {
    deepest_of_pass_ = std::max(deepest_of_pass_, overlap.depth);
    deepest_[pair] = std::max(deepest_[pair], overlap.depth);
  }
  /// Moves what moves out of an overlap: this share of the way, less what it has gone since the last renewal.
  bool resolve_rest(std::uint32_t pair, const Overlap& overlap, double share);
  bool resolve(std::uint32_t pair, const Overlap& overlap, double way);
  /// Moves a side by moving its free nodes, those more that have more of it.
  void move(std::uint32_t pair, const ContactPointSide& side, const Eigen::Vector3d& way);
  /// The sum of the squares of the free nodes' weights [1].
  double mobility(const ContactPointSide& side) const;
  bool can_move(const ContactPointSide& side) const { return mobility(side) > held_share * held_share; }
  /// Half the way when the nodes of the other side, which go out on their own account, can move.
  double share_of_first(std::uint32_t pair, const Overlap& overlap) const;
  bool is_held(std::uint32_t point) const {
    return !is_held_.empty() && is_held_[parts_.contact_mesh.mesh_nodes[point]] == held_fully;
  }

  const ContactModel& model_;
  const Mesh& mesh_;
  const OverlapRemoval& settings_;
  const OverlapParts parts_;
  ShiftedPoints points_;
  OverlapSearch search_;
  OverlapDetection detection_;
  BodyParting bodies_;
  std::span<const std::uint8_t> is_held_;
  std::int64_t n_parted_ = 0;                                    ///< passes that moved bodies
  double deepest_of_pass_ = 0.0;                                 ///< found so far [length]
  std::vector<double> deepest_;                                  ///< [n_pairs] found so far [length]
  std::vector<std::map<std::uint32_t, Eigen::Vector3d>> moved_;  ///< [n_pairs] by mesh node [length]
};

void OverlapRemover::part_bodies() {
  for (; n_parted_ < settings_.iterations; ++n_parted_) {
    const std::vector<BodyMove> moves =
        bodies_.find_moves(points_.coordinates(), points_.renewed(), is_held_);
    if (moves.empty()) return;
    for (const BodyMove& move : moves) {
      deepest_[move.pair] = std::max(deepest_[move.pair], move.depth);
      for (const NodeIndex node : bodies_.nodes_of(move.body)) {
        points_.shift(node, move.way);
        moved_[move.pair].try_emplace(node.value, Eigen::Vector3d::Zero()).first->second += move.way;
      }
    }
    points_.renew();
  }
}

double OverlapRemover::mobility(const ContactPointSide& side) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (!is_held(side.nodes[k])) sum += weight * weight;
  }
  return sum;
}

double OverlapRemover::share_of_first(std::uint32_t pair, const Overlap& overlap) const {
  const bool is_face = overlap.second.weights != Eigen::Vector4d::Zero();
  const bool has_two_sides = model_.surfaces.surfaces[model_.pairs[pair].second].kind == SurfaceKind::face;
  const bool is_all_held =
      std::ranges::all_of(overlap.second.nodes, [this](std::uint32_t node) { return is_held(node); });
  return overlap.mover == OverlapMover::first && is_face && has_two_sides && !is_all_held ? 0.5 : 1.0;
}

void OverlapRemover::move(std::uint32_t pair, const ContactPointSide& side, const Eigen::Vector3d& way) {
  const double sum = mobility(side);
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (weight == 0.0 || is_held(side.nodes[k])) continue;
    const Eigen::Vector3d step = weight / sum * way;
    points_.shift(side.nodes[k], step);
    const std::uint32_t node = parts_.contact_mesh.mesh_nodes[side.nodes[k]];
    moved_[pair].try_emplace(node, Eigen::Vector3d::Zero()).first->second += step;
  }
}

bool OverlapRemover::resolve(std::uint32_t pair, const Overlap& overlap, double way) {
  const bool can_first = can_move(overlap.first);
  const bool can_second = overlap.mover != OverlapMover::first && can_move(overlap.second);
  const bool is_shared = overlap.mover == OverlapMover::both && can_first && can_second;
  if (is_shared) way *= 0.5;
  if (can_first) move(pair, overlap.first, way * overlap.normal);
  if (can_second && (is_shared || !can_first)) move(pair, overlap.second, -way * overlap.normal);
  return can_first || can_second;
}

bool OverlapRemover::resolve_rest(std::uint32_t pair, const Overlap& overlap, double share) {
  Eigen::Vector3d gone = points_.way_of(overlap.first);
  if (overlap.mover != OverlapMover::first) gone -= points_.way_of(overlap.second);
  const double rest = share * overlap.depth - gone.dot(overlap.normal);
  return rest > remaining_share * overlap.depth && resolve(pair, overlap, rest);
}

bool OverlapRemover::pass_nodes(std::uint32_t pair, OverlapKind kind, bool is_last) {
  bool has_moved = false;
  if (is_last) {
    // One node at a time, or both sides would go the whole way.
    detection_.visit_nodes(pair, kind, [&](const Overlap& overlap) {
      note(pair, overlap);
      has_moved |= resolve(pair, overlap, overlap.depth);
    });
    return has_moved;
  }
  std::vector<Overlap> overlaps;
  detection_.visit_nodes(pair, kind, [&](const Overlap& overlap) { overlaps.push_back(overlap); });
  for (const Overlap& overlap : overlaps) {
    note(pair, overlap);
    const double share = share_of_first(pair, overlap);
    // Several points of lofts hang on one node.
    has_moved |= kind == OverlapKind::lofted ? resolve_rest(pair, overlap, share)
                                             : resolve(pair, overlap, share * overlap.depth);
  }
  return has_moved;
}

bool OverlapRemover::pass_lofts(std::uint32_t pair, bool is_last) {
  if (!search_.sites()[pair].has_lofts()) return false;
  points_.renew();
  deepest_of_pass_ = 0.0;
  bool has_moved = pass_nodes(pair, OverlapKind::lofted, is_last);
  const double deepest_node = deepest_of_pass_;
  points_.renew();
  detection_.visit_edges(pair, [&](const Overlap& overlap) {
    note(pair, overlap);
    has_moved |= resolve_rest(pair, overlap, 1.0);
  });
  points_.renew();
  detection_.visit_rims(pair, [&](const Overlap& overlap) {
    // Where nodes lie as deep, these go out first.
    if (overlap.depth <= deepest_node) return;
    note(pair, overlap);
    has_moved |= resolve_rest(pair, overlap, 1.0);
  });
  return has_moved;
}

bool OverlapRemover::pass(std::int64_t n_before) {
  bool has_moved = false;
  if (n_before > 0) renew_lofts();
  for (std::uint32_t p = 0; p < model_.pairs.size(); ++p) {
    if (n_before < settings_.iterations)
      has_moved |= pass_nodes(p, OverlapKind::meshed, n_before + 1 == settings_.iterations);
    if (n_before < settings_.shell_iterations)
      has_moved |= pass_lofts(p, n_before + 1 == settings_.shell_iterations);
  }
  return has_moved;
}

std::uint32_t OverlapRemover::culprit_of(ElementIndex element) const {
  std::uint32_t culprit = 0;
  double farthest = 0.0;
  for (std::uint32_t p = 0; p < moved_.size(); ++p) {
    for (const NodeIndex node : mesh_.element_nodes(element)) {
      const auto found = moved_[p].find(node.value);
      if (found == moved_[p].end() || found->second.norm() <= farthest) continue;
      farthest = found->second.norm();
      culprit = p;
    }
  }
  return culprit;
}

OverlapRemoved OverlapRemover::take() {
  OverlapRemoved removed;
  renew_lofts();
  std::vector<double> left(model_.pairs.size(), 0.0);
  for (const DeepOverlap& deep : bodies_.find_deep(points_.coordinates(), points_.renewed()))
    left[deep.pair] = std::max(left[deep.pair], deep.depth);
  for (std::uint32_t p = 0; p < model_.pairs.size(); ++p) {
    OverlapMoves moves;
    moves.left = left[p];
    detection_.visit_all(p,
                         [&](const Overlap& overlap) { moves.left = std::max(moves.left, overlap.depth); });
    moves.deepest = std::max(deepest_[p], moves.left);
    if (moves.deepest == 0.0) continue;
    moves.pair = p;
    moves.n_nodes = static_cast<std::uint32_t>(moved_[p].size());
    for (const auto& [node, way] : moved_[p]) {
      if (way.norm() <= moves.largest) continue;
      moves.largest = way.norm();
      moves.largest_node = {node};
    }
    removed.moves.push_back(moves);
  }
  removed.coordinates = points_.take();
  removed.n_body_passes = n_parted_;
  for (const ElementIndex element : find_turned_elements(mesh_, removed.coordinates))
    removed.turned.push_back({element, culprit_of(element)});
  return removed;
}

}  // namespace

OverlapRemoved remove_overlap(const ContactModel& model, const Mesh& mesh,
                              const ContactDefinition& definition, std::span<const std::uint8_t> is_held) {
  const OverlapRemoval& settings = definition.overlap_removal;
  const std::int64_t most = std::max(settings.iterations, settings.shell_iterations);
  OverlapRemover remover(model, mesh, definition, is_held);
  std::int64_t n_passes = 0;
  while (n_passes < most && remover.pass(n_passes)) ++n_passes;
  OverlapRemoved removed = remover.take();
  removed.n_passes = n_passes;
  return removed;
}

}  // namespace contactsim
