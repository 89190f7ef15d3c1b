// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/node_sums.hpp"

#include <algorithm>

namespace contactsim {

NodeSums::NodeSums(std::span<const std::uint32_t> nodes, std::size_t n_nodes) : places_(nodes.size()) {
  std::vector<std::uint32_t> next(n_nodes + 1, 0);
  for (const std::uint32_t node : nodes) ++next[node + 1];
  const auto n_used = static_cast<std::size_t>(
      std::count_if(next.begin(), next.end(), [](std::uint32_t n_places) { return n_places > 0; }));
  nodes_.reserve(n_used);
  begin_.clear();
  begin_.reserve(n_used + 1);
  for (std::uint32_t node = 0; node < n_nodes; ++node) {
    if (next[node + 1] > 0) {
      nodes_.push_back({node});
      begin_.push_back(next[node]);
    }
    next[node + 1] += next[node];
  }
  begin_.push_back(static_cast<std::uint32_t>(nodes.size()));
  for (std::uint32_t place = 0; place < nodes.size(); ++place) places_[next[nodes[place]]++] = place;
  if (nodes_.empty() || nodes_.back().value - nodes_.front().value >= n_used) return;
  first_node_ = nodes_.front().value;
  nodes_ = std::vector<NodeIndex>();  // gives its memory back
}

namespace {

std::vector<std::uint32_t> nodes_at(std::span<const std::uint32_t> nodes,
                                    std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> picked;
  for (const std::uint32_t place : places) picked.push_back(nodes[place]);
  return picked;
}

}  // namespace

NodeSums::NodeSums(std::span<const std::uint32_t> nodes, std::size_t n_nodes,
                   std::span<const std::uint32_t> places)
    : NodeSums(nodes_at(nodes, places), n_nodes) {
  for (std::uint32_t& place : places_) place = places[place];
}

std::vector<NodeIndex> NodeSums::nodes() const {
  std::vector<NodeIndex> nodes;
  for (std::size_t k = 0; k < size(); ++k) nodes.push_back(node(k));
  return nodes;
}

void NodeSums::add(std::span<const NodeVector> parts, Eigen::Matrix3Xd& forces) const {
  add(parts, NodeRanges(forces.cols()), forces);
}

/// Calls take(node, sum of its parts).
template <class Take>
void NodeSums::visit(std::span<const NodeVector> parts, const NodeRanges& nodes, const Take& take) const {
  const auto part = [&, places = places_.data(),
                     n = places_.size()](std::uint32_t entry) -> const NodeVector& {
    constexpr std::size_t ahead = 32;  // parts that are fetched meanwhile, of other chunks from far away
    if (entry + ahead < n) __builtin_prefetch(&parts[places[entry + ahead]]);
    return parts[places[entry]];
  };
  const auto sum_at = [&](std::size_t k) {
    NodeVector sum = part(begin_[k]);
    for (std::uint32_t entry = begin_[k] + 1; entry < begin_[k + 1]; ++entry) sum += part(entry);
    take(node(k).value, sum);
  };
  if (follow_each_other()) {
    nodes.visit_in(NodeRange{first_node_, first_node_ + static_cast<std::int64_t>(size())}, sum_at);
  } else {
    nodes.visit_in(nodes_, sum_at);
  }
}

void NodeSums::add(std::span<const NodeVector> parts, const NodeRanges& nodes,
                   Eigen::Matrix3Xd& forces) const {
  visit(parts, nodes, [&](std::uint32_t node, const NodeVector& sum) { forces.col(node) += sum.head<3>(); });
}

void NodeSums::set(std::span<const NodeVector> parts, const NodeRanges& nodes,
                   Eigen::Matrix3Xd& forces) const {
  // 0 + -0 is 0.
  visit(parts, nodes,
        [&](std::uint32_t node, const NodeVector& sum) { forces.col(node) = sum.head<3>().array() + 0.0; });
}

}  // namespace contactsim
