// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_removal.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/overlap/body_parting.hpp"
#include "contact/overlap/gap_closure.hpp"
#include "contact/overlap/side_mover.hpp"
#include "core/definition/contact.hpp"
#include "core/mesh/element_checks.hpp"
#include "core/mesh/node_elements.hpp"
#include "core/mesh/turned_elements.hpp"

namespace contactsim {

namespace {

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
        mover_(model, parts_.contact_mesh, is_held, points_),
        is_held_(is_held),
        deepest_(model.pairs.size(), 0.0) {
    const bool closes_gaps = std::ranges::any_of(model.pairs, &SurfacePair::closes_gaps);
    is_all_parted_ = settings_.is_on() || settings_.is_all_there_is || !closes_gaps;
    part_bodies();
    for (const SurfacePair& pair : model.pairs)
      search_.widen(find_closure_tolerance(points_.renewed(), pair));
    search_.find(points_.renewed());
  }

  /// Returns whether anything was moved.
  ///   n_before  passes before this one
  bool pass(std::int64_t n_before);
  /// Moves nodes over the gaps that pairs close.
  void close_gaps();
  OverlapRemoved take();

 private:
  /// Whether overlap of a pair is removed: of those that close gaps always.
  bool parts(PairIndex pair) const { return is_all_parted_ || model_.pairs[pair].closes_gaps(); }
  /// Whether a node goes out: of pairs that close gaps those of SIDE B, or of the node set.
  bool may_go(PairIndex pair, const Overlap& overlap) const;
  /// Moves whole bodies out of what they lie deep in.
  void part_bodies();
  void renew_lofts() {
    points_.renew();
    search_.renew_lofts(points_.renewed());
  }
  bool pass_nodes(PairIndex pair, OverlapKind kind, bool is_last);
  bool pass_lofts(PairIndex pair, bool is_last);
  void note(PairIndex pair, const Overlap& overlap) {
    deepest_of_pass_ = std::max(deepest_of_pass_, overlap.depth);
    deepest_[pair] = std::max(deepest_[pair], overlap.depth);
  }
  OverlapMoves moves_of(PairIndex pair) const;
  void find_squeezed(OverlapRemoved& removed) const;

  const ContactModel& model_;
  const Mesh& mesh_;
  const OverlapRemoval& settings_;
  const OverlapParts parts_;
  ShiftedPoints points_;
  OverlapSearch search_;
  OverlapDetection detection_;
  BodyParting bodies_;
  SideMover mover_;
  std::span<const std::uint8_t> is_held_;
  bool is_all_parted_ = true;
  std::int64_t n_parted_ = 0;                 ///< passes that moved bodies
  double deepest_of_pass_ = 0.0;              ///< found so far [length]
  IndexedVector<PairIndex, double> deepest_;  ///< found so far [length]
  std::optional<GapClosure> closure_;
  IndexedVector<PairIndex, double> widest_;  ///< gap that is closed [length]
};

void OverlapRemover::part_bodies() {
  for (; n_parted_ < settings_.iterations; ++n_parted_) {
    std::vector<BodyMove> moves = bodies_.find_moves(points_.coordinates(), points_.renewed(), is_held_);
    std::erase_if(moves, [this](const BodyMove& move) { return !parts(move.pair); });
    if (moves.empty()) return;
    for (const BodyMove& move : moves) {
      deepest_[move.pair] = std::max(deepest_[move.pair], move.depth);
      for (const NodeIndex node : bodies_.nodes_of(move.body)) mover_.move(move.pair, node, move.way);
    }
    points_.renew();
  }
}

bool OverlapRemover::may_go(PairIndex index, const Overlap& overlap) const {
  const SurfacePair& pair = model_.pairs[index];
  if (!pair.closes_gaps()) return true;
  const ContactNodeIndex node = overlap.first.nodes[0];
  if (pair.adjusted_node_set) {
    const auto& nodes = mesh_.node_sets()[*pair.adjusted_node_set].nodes;
    return std::ranges::find(nodes, parts_.contact_mesh.mesh_nodes[node]) != nodes.end();
  }
  return !pair.side_b || parts_.contact_mesh.find_row(node, *pair.side_b).has_value();
}

bool OverlapRemover::pass_nodes(PairIndex pair, OverlapKind kind, bool is_last) {
  bool has_moved = false;
  if (is_last) {
    // One node at a time, or both sides would go the whole way.
    detection_.visit_nodes(pair, kind, [&](const Overlap& overlap) {
      if (!may_go(pair, overlap)) return;
      note(pair, overlap);
      has_moved |= mover_.resolve(pair, overlap, overlap.depth);
    });
    return has_moved;
  }
  std::vector<Overlap> overlaps;
  detection_.visit_nodes(pair, kind, [&](const Overlap& overlap) {
    if (may_go(pair, overlap)) overlaps.push_back(overlap);
  });
  for (const Overlap& overlap : overlaps) {
    note(pair, overlap);
    const double share = mover_.share_of_first(pair, overlap);
    // Several points of lofts hang on one node.
    has_moved |= kind == OverlapKind::lofted ? mover_.resolve_rest(pair, overlap, share)
                                             : mover_.resolve(pair, overlap, share * overlap.depth);
  }
  return has_moved;
}

bool OverlapRemover::pass_lofts(PairIndex pair, bool is_last) {
  if (!search_.sites()[pair].has_lofts()) return false;
  points_.renew();
  deepest_of_pass_ = 0.0;
  bool has_moved = pass_nodes(pair, OverlapKind::lofted, is_last);
  const double deepest_node = deepest_of_pass_;
  points_.renew();
  detection_.visit_edges(pair, [&](const Overlap& overlap) {
    note(pair, overlap);
    has_moved |= mover_.resolve_rest(pair, overlap, 1.0);
  });
  points_.renew();
  detection_.visit_rims(pair, [&](const Overlap& overlap) {
    // Where nodes lie as deep, these go out first.
    if (overlap.depth <= deepest_node) return;
    note(pair, overlap);
    has_moved |= mover_.resolve_rest(pair, overlap, 1.0);
  });
  return has_moved;
}

bool OverlapRemover::pass(std::int64_t n_before) {
  bool has_moved = false;
  if (n_before > 0) renew_lofts();
  for (const PairIndex p : indices(model_.pairs)) {
    if (!parts(p)) continue;
    if (n_before < settings_.iterations)
      has_moved |= pass_nodes(p, OverlapKind::meshed, n_before + 1 == settings_.iterations);
    if (n_before < settings_.shell_iterations)
      has_moved |= pass_lofts(p, n_before + 1 == settings_.shell_iterations);
  }
  return has_moved;
}

void OverlapRemover::close_gaps() {
  points_.renew();
  closure_.emplace(model_, mesh_, parts_, search_, detection_, points_);
  for (const PairIndex p : indices(model_.pairs)) widest_.push_back(closure_->widest(p));
  for (std::int64_t i = 0; i < settings_.iterations; ++i) {
    if (!closure_->pass(i + 1 == settings_.iterations, mover_)) return;
    points_.renew();
  }
}

OverlapMoves OverlapRemover::moves_of(PairIndex pair) const {
  OverlapMoves moves;
  moves.pair = pair;
  moves.n_nodes = static_cast<std::uint32_t>(mover_.moved(pair).size());
  double squares = 0.0;
  for (const auto& [node, way] : mover_.moved(pair)) {
    squares += way.squaredNorm();
    const auto has_moved = [&, moved = node](PairIndex p) { return mover_.moved(p).contains(moved); };
    for (const PairIndex p : IndexRange(PairIndex{0}, pair)) {
      if (!has_moved(p)) continue;
      ++moves.n_again;
      break;
    }
    if (way.norm() <= moves.largest) continue;
    moves.largest = way.norm();
    moves.largest_node = {node};
  }
  if (moves.n_nodes > 0) moves.mean_square = std::sqrt(squares / moves.n_nodes);
  return moves;
}

/// The solid that has lost the largest share of its volume.
void OverlapRemover::find_squeezed(OverlapRemoved& removed) const {
  std::set<ElementIndex> touched;
  const NodeElements elements(mesh_);
  for (const PairIndex p : indices(model_.pairs)) {
    for (const auto& [node, way] : mover_.moved(p)) {
      for (const ElementIndex element : elements.of({node})) touched.insert(element);
    }
  }
  for (const ElementIndex element : touched) {
    const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(element)].shape);
    if (shape.family != Family::solid) continue;
    const auto nodes = mesh_.element_nodes(element);
    const double share =
        solid_volume(removed.coordinates, nodes, shape) / solid_volume(mesh_.coordinates(), nodes, shape);
    if (removed.squeezed && share >= removed.volume_share) continue;
    removed.squeezed = element;
    removed.volume_share = share;
  }
}

OverlapRemoved OverlapRemover::take() {
  OverlapRemoved removed;
  renew_lofts();
  IndexedVector<PairIndex, double> left(model_.pairs.size(), 0.0);
  for (const DeepOverlap& deep : bodies_.find_deep(points_.coordinates(), points_.renewed()))
    left[deep.pair] = std::max(left[deep.pair], deep.depth);
  for (const PairIndex p : indices(model_.pairs)) {
    if (!parts(p)) continue;
    OverlapMoves moves = moves_of(p);
    moves.left = left[p];
    detection_.visit_all(p, [&](const Overlap& overlap) {
      if (may_go(p, overlap)) moves.left = std::max(moves.left, overlap.depth);
    });
    moves.deepest = std::max(deepest_[p], moves.left);
    moves.widest = widest_[p];
    moves.left_open = closure_->widest(p);
    if (moves.deepest == 0.0 && moves.widest == 0.0) continue;
    removed.moves.push_back(moves);
  }
  removed.coordinates = points_.take();
  removed.n_body_passes = n_parted_;
  for (const ElementIndex element : find_turned_elements(mesh_, removed.coordinates))
    removed.turned.push_back({element, mover_.culprit_of(mesh_.element_nodes(element))});
  if (std::ranges::any_of(model_.pairs, &SurfacePair::closes_gaps)) find_squeezed(removed);
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
  remover.close_gaps();
  OverlapRemoved removed = remover.take();
  removed.n_passes = n_passes;
  return removed;
}

}  // namespace contactsim
