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
  ///   ranges  ascending, apart; long ones are cut, so that threads share them
  explicit NodeRanges(std::span<const NodeRange> ranges) {
    constexpr std::int64_t max_size = 2048;
    are_all_ = false;
    for (const NodeRange& range : ranges) {
      all_.end += range.end - range.begin;
      for (std::int64_t begin = range.begin; begin < range.end; begin += max_size)
        some_.push_back({begin, std::min(begin + max_size, range.end)});
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
    parallel_for(some_.size(), n_threads, [&](std::size_t i) { function(some_[i].begin, some_[i].end); });
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

  /// Sets values to zero.
  ///   values  [3 x n_nodes]
  void set_zero(Eigen::Matrix3Xd& values) const {
    visit([&](std::int64_t begin, std::int64_t end) { values.middleCols(begin, end - begin).setZero(); });
  }

 private:
  NodeRange all_;  // or their number
  bool are_all_ = true;
  std::vector<NodeRange> some_;
};

}  // namespace contactsim
