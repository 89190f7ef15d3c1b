// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/indices.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// Nodes of the mesh from `begin` on, before `end`.
struct NodeRange {
  std::int64_t begin = 0, end = 0;
};

/// Nodes that loops over plain arrays go through: all, or some stretches of them.
class NodeRanges {
 public:
  explicit NodeRanges(std::int64_t n_nodes) : all_{0, n_nodes} {}
  ///   ranges  ascending, apart
  explicit NodeRanges(std::span<const NodeRange> ranges)
      : are_all_(false), some_(ranges.begin(), ranges.end()) {
    for (const NodeRange& range : ranges) {
      first_of_.push_back(all_.end);
      all_.end += range.end - range.begin;
    }
  }

  bool are_all() const { return are_all_; }
  /// How many nodes there are.
  std::int64_t size() const { return all_.end; }

  /// Calls function(begin, end) for stretches that make up all.
  template <class Function>
  void visit(const Function& function) const {
    const int n_threads = threads_for(static_cast<std::size_t>(size()));
    if (are_all_) return parallel_for_ranges(size(), n_threads, function);
    parallel_for_ranges(size(), n_threads,
                        [&](std::int64_t begin, std::int64_t end) { visit_between(begin, end, function); });
  }

  /// Calls function(k) for the positions of these nodes in a list.
  ///   list  ascending
  template <class Function>
  void visit_in(std::span<const NodeIndex> list, const Function& function) const {
    if (are_all_) return parallel_for(list.size(), threads_for(list.size()), function);
    visit([&](std::int64_t begin, std::int64_t end) {
      const auto first = std::ranges::lower_bound(list, NodeIndex{static_cast<std::uint32_t>(begin)});
      for (auto k = static_cast<std::size_t>(first - list.begin()); k < list.size() && list[k].value < end;
           ++k)
        function(k);
    });
  }

  /// The same of a stretch of nodes.
  template <class Function>
  void visit_in(const NodeRange& list, const Function& function) const {
    const auto n = static_cast<std::size_t>(list.end - list.begin);
    if (are_all_) return parallel_for(n, threads_for(n), function);
    visit([&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t node = std::max(begin, list.begin); node < std::min(end, list.end); ++node)
        function(static_cast<std::size_t>(node - list.begin));
    });
  }

  /// These nodes but those for which a condition holds.
  template <class Condition>
  NodeRanges without(const Condition& condition) const {
    std::vector<NodeRange> left;
    const auto look = [&](const NodeRange& range) {
      for (std::int64_t node = range.begin; node < range.end; ++node) {
        if (condition(node)) continue;
        if (left.empty() || left.back().end != node) left.push_back({node, node});
        left.back().end = node + 1;
      }
    };
    if (are_all_) look(all_);
    for (const NodeRange& range : some_) look(range);
    return NodeRanges(std::span<const NodeRange>(left));
  }

  /// Sets values to zero.
  ///   values  [3 x n_nodes]
  void set_zero(Eigen::Matrix3Xd& values) const {
    visit([&](std::int64_t begin, std::int64_t end) { values.middleCols(begin, end - begin).setZero(); });
  }

 private:
  /// The nodes that have these places among all, the first has place 0.
  template <class Function>
  void visit_between(std::int64_t begin, std::int64_t end, const Function& function) const {
    if (begin == end) return;
    const auto next = std::ranges::upper_bound(first_of_, begin);
    for (auto k = static_cast<std::size_t>(next - first_of_.begin()) - 1;
         k < some_.size() && first_of_[k] < end; ++k) {
      const std::int64_t to_node = some_[k].begin - first_of_[k];
      function(std::max(some_[k].begin, begin + to_node), std::min(some_[k].end, end + to_node));
    }
  }

  NodeRange all_;  // or their number
  bool are_all_ = true;
  std::vector<NodeRange> some_;
  std::vector<std::int64_t> first_of_;  // [some_] the place of its first node among all
};

}  // namespace contactsim
