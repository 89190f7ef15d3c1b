// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/node_ranges.hpp"

#include <atomic>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// How often each node is visited.
std::vector<int> visits(const NodeRanges& nodes, std::size_t n_nodes) {
  std::vector<std::atomic<int>> counts(n_nodes);
  nodes.visit([&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) ++counts[static_cast<std::size_t>(i)];
  });
  return {counts.begin(), counts.end()};
}

}  // namespace

TEST_CASE("ranges of nodes are visited once each, long ones too", "[core][node_ranges]") {
  CHECK(visits(NodeRanges(5), 6) == std::vector<int>{1, 1, 1, 1, 1, 0});
  const std::vector<NodeRange> some{{2, 3}, {5, 5005}};
  const NodeRanges nodes(some);
  CHECK(nodes.size() == 5001);
  std::vector<int> expected(5010, 0);
  expected[2] = 1;
  std::fill(expected.begin() + 5, expected.begin() + 5005, 1);
  CHECK(visits(nodes, 5010) == expected);
  CHECK(visits(NodeRanges(std::span<const NodeRange>{}), 3) == std::vector<int>{0, 0, 0});
  // A long range beside many of one node: threads begin and end inside of both.
  std::vector<NodeRange> uneven{{0, 5000}};
  for (std::int64_t i = 0; i < 3001; ++i) uneven.push_back({5001 + 2 * i, 5002 + 2 * i});
  std::vector<int> each(11003, 0);
  for (const NodeRange& range : uneven) std::fill(each.begin() + range.begin, each.begin() + range.end, 1);
  CHECK(visits(NodeRanges(uneven), each.size()) == each);
}

TEST_CASE("the members of a list are those in the ranges", "[core][node_ranges]") {
  const std::vector<NodeIndex> list{{1}, {4}, {5}, {9}, {10}};
  const std::vector<NodeRange> some{{0, 2}, {5, 10}};
  std::vector<int> found(list.size(), 0);
  NodeRanges(some).visit_in(list, [&](std::size_t k) { ++found[k]; });
  CHECK(found == std::vector<int>{1, 0, 1, 1, 0});
  NodeRanges(20).visit_in(list, [&](std::size_t k) { ++found[k]; });
  CHECK(found == std::vector<int>{2, 1, 2, 2, 1});
}

TEST_CASE("nodes are left out of ranges by a condition", "[core][node_ranges]") {
  const auto is_third = [](std::int64_t node) { return node % 3 == 0; };
  CHECK(visits(NodeRanges(6).without(is_third), 6) == std::vector<int>{0, 1, 1, 0, 1, 1});
  const std::vector<NodeRange> some{{0, 2}, {3, 5}};
  CHECK(visits(NodeRanges(some).without(is_third), 6) == std::vector<int>{0, 1, 0, 0, 1, 0});
  CHECK(NodeRanges(6).without([](std::int64_t) { return true; }).size() == 0);
}

TEST_CASE("zeros are set in the ranges alone", "[core][node_ranges]") {
  Eigen::Matrix3Xd values = Eigen::Matrix3Xd::Ones(3, 4);
  const std::vector<NodeRange> some{{1, 2}, {3, 4}};
  NodeRanges(some).set_zero(values);
  CHECK(values.row(1) == Eigen::RowVector4d(1, 0, 1, 0));
}
