// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/body_parting.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/dynamics/model.hpp"

namespace contactsim {

namespace {

/// Nodes whose way out has a smaller cosine with that of the others are waited for until these are out.
constexpr double along_cosine = 0.5;

/// A sum of ways out that is smaller than this share of what they could come to is round-off.
constexpr double even_share = 1e-6;

/// What two bodies have to go apart.
struct Parting {
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();  ///< sum times depths, out of the second body [length]
  std::vector<const DeepOverlap*> overlaps;
  std::vector<double> signs;  ///< -1 of nodes of the second body [1]

  /// The way that brings out the nodes that go along it. Where as many want to go back, as those of sheets
  /// with one middle, it is that of the first.
  Eigen::Vector3d way() const {
    const bool is_even = normals.norm() <= even_share * static_cast<double>(overlaps.size()) * deepest();
    const Eigen::Vector3d along = is_even ? signs[0] * overlaps[0]->normal : normals.normalized();
    double length = 0.0;
    for (std::size_t i = 0; i < overlaps.size(); ++i) {
      const double cosine = signs[i] * overlaps[i]->normal.dot(along);
      if (cosine >= along_cosine) length = std::max(length, overlaps[i]->depth / cosine);
    }
    return length * along;
  }
  double deepest() const {
    double depth = 0.0;
    for (const DeepOverlap* overlap : overlaps) depth = std::max(depth, overlap->depth);
    return depth;
  }
};

}  // namespace

BodyParting::BodyParting(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts)
    : model_(model), parts_(parts), deep_(model, mesh, parts), begin_(mesh.n_nodes() + 1, 0) {
  const auto& bodies = deep_.bodies();
  for (const std::uint32_t body : bodies) ++begin_[body + 1];
  for (std::size_t i = 0; i < bodies.size(); ++i) begin_[i + 1] += begin_[i];
  nodes_.resize(bodies.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t node = 0; node < bodies.size(); ++node) nodes_[next[bodies[node]]++] = {node};
}

std::vector<DeepOverlap> BodyParting::find_deep(const Eigen::Matrix3Xd& coordinates,
                                                const ContactKinematics& kinematics) const {
  std::vector<DeepOverlap> overlaps = deep_.find(coordinates, kinematics);
  std::erase_if(overlaps, [](const DeepOverlap& overlap) { return !overlap.is_deep; });
  return overlaps;
}

std::vector<BodyMove> BodyParting::find_moves(const Eigen::Matrix3Xd& coordinates,
                                              const ContactKinematics& kinematics,
                                              std::span<const std::uint8_t> is_held) const {
  const std::vector<DeepOverlap> overlaps = find_deep(coordinates, kinematics);
  std::map<std::tuple<PairIndex, std::uint32_t, std::uint32_t>, Parting> partings;
  for (const DeepOverlap& overlap : overlaps) {
    const double most = model_.pairs[overlap.pair].overlap_normal_tolerance.value_or(overlap.depth);
    if (overlap.depth > most) continue;
    const std::uint32_t own = body_of(parts_.contact_mesh.surface_nodes[overlap.row].node);
    const std::uint32_t other = body_of(parts_.contact_mesh.faces[overlap.face].corners[0]);
    const double sign = own < other ? 1.0 : -1.0;
    Parting& parting = partings[{overlap.pair, std::min(own, other), std::max(own, other)}];
    parting.normals += sign * overlap.depth * overlap.normal;
    parting.overlaps.push_back(&overlap);
    parting.signs.push_back(sign);
  }
  const auto can_move = [&](std::uint32_t body) {
    return std::ranges::none_of(nodes_of(body),
                                [&](NodeIndex node) { return !is_held.empty() && is_held[node.value] != 0; });
  };
  std::vector<BodyMove> moves;
  const auto has_moved = [&](std::uint32_t body) {
    return std::ranges::any_of(moves, [&](const BodyMove& move) { return move.body == body; });
  };
  for (const auto& [key, parting] : partings) {
    const auto [pair, first, second] = key;
    if (has_moved(first) || has_moved(second)) continue;
    const bool first_can = can_move(first), second_can = can_move(second);
    const Eigen::Vector3d way = parting.way();
    if ((!first_can && !second_can) || way.isZero(0.0)) continue;
    const double share = first_can && second_can ? 0.5 : 1.0;
    if (first_can) moves.push_back({pair, first, share * way, parting.deepest()});
    if (second_can) moves.push_back({pair, second, -share * way, parting.deepest()});
  }
  return moves;
}

}  // namespace contactsim
