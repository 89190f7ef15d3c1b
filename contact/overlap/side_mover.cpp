// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/side_mover.hpp"

#include <algorithm>

#include "contact/overlap/body_parting.hpp"

namespace contactsim {

namespace {

/// What is left of an overlap after others of the pass have moved its sides is round-off below this share.
constexpr double remaining_share = 1e-9;

/// A side whose free nodes have this share of it or less would have to move them far: it counts as held.
constexpr double held_share = 0.3;

}  // namespace

bool SideMover::is_held(ContactNodeIndex point) const {
  return !is_held_.empty() && is_held_[contact_mesh_.mesh_nodes[point].value] == held_fully;
}

bool SideMover::can_move(const ContactPointSide& side) const {
  return mobility(side) > held_share * held_share;
}

double SideMover::mobility(const ContactPointSide& side) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (!is_held(side.nodes[k])) sum += weight * weight;
  }
  return sum;
}

double SideMover::share_of_first(PairIndex pair, const Overlap& overlap) const {
  const bool is_face = overlap.second.weights != Eigen::Vector4d::Zero();
  const bool has_two_sides = model_.surfaces.surfaces[model_.pairs[pair].second].kind == SurfaceKind::face;
  const bool is_all_held =
      std::ranges::all_of(overlap.second.nodes, [this](ContactNodeIndex node) { return is_held(node); });
  const bool goes_alone = model_.pairs[pair].closes_gaps() && model_.pairs[pair].side_b;
  return overlap.mover == OverlapMover::first && !goes_alone && is_face && has_two_sides && !is_all_held
             ? 0.5
             : 1.0;
}

void SideMover::move(PairIndex pair, const ContactPointSide& side, const Eigen::Vector3d& way) {
  const double sum = mobility(side);
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (weight == 0.0 || is_held(side.nodes[k])) continue;
    const Eigen::Vector3d step = weight / sum * way;
    points_.shift(side.nodes[k], step);
    const std::uint32_t node = contact_mesh_.mesh_nodes[side.nodes[k]].value;
    moved_[pair].try_emplace(node, Eigen::Vector3d::Zero()).first->second += step;
  }
}

bool SideMover::resolve(PairIndex pair, const Overlap& overlap, double way) {
  const bool can_first = can_move(overlap.first);
  const bool can_second = overlap.mover != OverlapMover::first && can_move(overlap.second);
  const bool is_shared = overlap.mover == OverlapMover::both && can_first && can_second;
  if (is_shared) way *= 0.5;
  if (can_first) move(pair, overlap.first, way * overlap.normal);
  if (can_second && (is_shared || !can_first)) move(pair, overlap.second, -way * overlap.normal);
  return can_first || can_second;
}

bool SideMover::resolve_rest(PairIndex pair, const Overlap& overlap, double share) {
  Eigen::Vector3d gone = points_.way_of(overlap.first);
  if (overlap.mover != OverlapMover::first) gone -= points_.way_of(overlap.second);
  const double rest = share * overlap.depth - gone.dot(overlap.normal);
  return rest > remaining_share * overlap.depth && resolve(pair, overlap, rest);
}

PairIndex SideMover::culprit_of(std::span<const NodeIndex> element_nodes) const {
  PairIndex culprit;
  double farthest = 0.0;
  for (const PairIndex p : indices(moved_)) {
    for (const NodeIndex node : element_nodes) {
      const auto found = moved_[p].find(node.value);
      if (found == moved_[p].end() || found->second.norm() <= farthest) continue;
      farthest = found->second.norm();
      culprit = p;
    }
  }
  return culprit;
}

void SideMover::move(PairIndex pair, NodeIndex node, const Eigen::Vector3d& way) {
  points_.shift(node, way);
  moved_[pair].try_emplace(node.value, Eigen::Vector3d::Zero()).first->second += way;
}

}  // namespace contactsim
