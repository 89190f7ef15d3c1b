// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/weighted_gaps.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace contactsim {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void WeightedGaps::clear() {
  for (const WeightedNode& node : nodes_) first_[node.row] = none;
  overlaps_.clear();
  nodes_.clear();
  next_.clear();
}

std::uint32_t WeightedGaps::number_of(PairIndex pair, SurfaceNodeIndex row) {
  if (first_.size() <= row.value) first_.resize(std::size_t{row.value} + 1, none);
  for (std::uint32_t i = first_[row]; i != none; i = next_[i]) {
    if (nodes_[i].pair == pair) return i;
  }
  WeightedNode node;
  node.pair = pair;
  node.row = row;
  nodes_.push_back(node);
  next_.push_back(first_[row]);
  first_[row] = static_cast<std::uint32_t>(nodes_.size() - 1);
  return first_[row];
}

void WeightedGaps::add(const ContactMesh& contact_mesh, WeightedOverlap overlap) {
  const ContactFace& face = contact_mesh.faces[overlap.is_of_first ? overlap.first : overlap.second];
  for (std::size_t k = 0; k < overlap.shares.n; ++k) {
    const OverlapShare& share = overlap.shares.corners[k];
    const std::uint32_t number =
        number_of(overlap.pair, *contact_mesh.find_row(face.corners[share.part], face.surface));
    overlap.nodes[k] = number;
    WeightedNode& node = nodes_[number];
    const double area = overlap.weight * share.area;
    if (!(node.area > 0.0)) node.penalty = overlap.penalty;
    node.area += area;
    const double part = area / node.area;
    node.gap += part * (overlap.gaps[k] - node.gap);
    node.penalty.stiffness += part * (overlap.penalty.stiffness - node.penalty.stiffness);
  }
  overlaps_.push_back(std::move(overlap));
}

void WeightedGaps::find_pressures(const ContactMultipliers& multipliers) {
  for (WeightedNode& node : nodes_) {
    node.multiplier = multipliers.of_node(node.pair, node.row);
    if (!(node.depth() > 0.0)) continue;
    node.pressure = node.penalty.pressure_at(node.depth());
    node.slope = node.penalty.slope(node.depth());
  }
}

const WeightedOverlap* WeightedGaps::find(std::size_t candidate) const {
  const auto found = std::ranges::lower_bound(overlaps_, candidate, {}, &WeightedOverlap::candidate);
  return found != overlaps_.end() && found->candidate == candidate ? &*found : nullptr;
}

}  // namespace contactsim
