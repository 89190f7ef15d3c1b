// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/weighted_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace contactsim {

void WeightedGaps::clear() {
  for (const WeightedNode& node : nodes_) first_[node.row] = std::nullopt;
  overlaps_.clear();
  nodes_.clear();
  next_.clear();
}

std::uint32_t WeightedGaps::number_of(PairIndex pair, SurfaceNodeIndex row) {
  if (first_.size() <= row.value) first_.resize(std::size_t{row.value} + 1);
  for (OptionalIndex<std::uint32_t> i = first_[row]; i; i = next_[*i]) {
    if (nodes_[*i].pair == pair) return *i;
  }
  WeightedNode node;
  node.pair = pair;
  node.row = row;
  nodes_.push_back(node);
  next_.push_back(first_[row]);
  const auto number = static_cast<std::uint32_t>(nodes_.size() - 1);
  first_[row] = number;
  return number;
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
    if (node.rule == nullptr) {
      node.rule = overlap.rule;
      node.penalty = overlap.penalty;
    }
    node.area += area;
    const double part = area / node.area;
    node.gap += part * (overlap.gaps[k] - node.gap);
    node.penalty.stiffness += part * (overlap.penalty.stiffness - node.penalty.stiffness);
    const double bearing = overlap.bearing_area(k);
    if (!(overlap.rule->friction > 0.0) || !(bearing > 0.0)) continue;
    node.bearing += bearing;
    const double bearing_part = bearing / node.bearing;
    node.normal += bearing * share.normal;
    node.slip += bearing_part * (overlap.slips[k] - node.slip);
    node.elastic_slip += bearing_part * (overlap.held_slips[k] - node.elastic_slip);
  }
  overlaps_.push_back(std::move(overlap));
}

void WeightedGaps::find_tractions(const ContactStepContext& context) {
  for (WeightedNode& node : nodes_) {
    node.multiplier = context.multipliers->value_or(node.pair, node.row, 0.0);
    // What lies on the other side without pressure resists closing.
    constexpr double closed = 1e-6;
    if (!(node.depth() > -closed * std::sqrt(node.area))) continue;
    const double depth = std::max(node.depth(), 0.0);
    node.pressure = node.penalty.pressure_at(depth);
    node.slope = node.penalty.slope(depth);
    if (node.has_friction()) drag(context, node);
  }
}

/// What no load step has held yet, the pairs of faces have.
void WeightedGaps::drag(const ContactStepContext& context, WeightedNode& node) {
  if (!context.held_slips->empty())
    node.elastic_slip = context.held_slips->value_or(node.pair, node.row, Eigen::Vector3d::Zero());
  node.normal.normalize();
  const Eigen::Vector3d along = node.slip - node.normal.dot(node.slip) * node.normal;
  const double rate = context.dt > 0.0 ? along.norm() / context.dt : 0.0;
  const double pressure = context.slip_pressures == nullptr
                              ? node.pressure
                              : context.slip_pressures->of(node.pair, node.row, node.pressure);
  const double limit = node.rule->slip_limit(pressure, 1.0, rate);
  if (context.slip_pressures == nullptr)
    node.friction_slope = node.rule->slip_limit_slope(node.pressure, 1.0, rate);
  node.friction = step_friction(node.normal, node.elastic_slip, node.slip, node.slip_stiffness(), limit);
}

const WeightedOverlap* WeightedGaps::find(std::size_t candidate) const {
  const auto found = std::ranges::lower_bound(overlaps_, candidate, {}, &WeightedOverlap::candidate);
  return found != overlaps_.end() && found->candidate == candidate ? &*found : nullptr;
}

}  // namespace contactsim
