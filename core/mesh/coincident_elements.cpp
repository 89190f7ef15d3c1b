// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/coincident_elements.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace contactsim {

namespace {

constexpr std::size_t max_corners = 8;
constexpr std::uint32_t behind_all_nodes = UINT32_MAX;

/// The corners of a solid or shell, ascending, then behind_all_nodes.
struct SortedCorners {
  Family family = Family::solid;
  std::array<std::uint32_t, max_corners> nodes{};

  auto operator<=>(const SortedCorners&) const = default;
};

bool has_corners(const ElementBlock& block) {
  const Family family = topology(block.shape).family;
  return family == Family::solid || family == Family::shell;
}

/// The same for elements on the same nodes, whatever their order.
std::uint64_t sum_of_corners(const Mesh& mesh, ElementIndex element) {
  const ElementBlock& block = mesh.blocks()[mesh.block_of(element)];
  std::uint64_t sum = 0;
  for (const NodeIndex node :
       block.element_nodes(element.value - block.first_element.value).first(topology(block.shape).n_corners))
    sum += node.value;
  return sum;
}

SortedCorners corners_of(const ElementBlock& block, std::uint32_t element) {
  const Topology& shape = topology(block.shape);
  const auto nodes = block.element_nodes(element).first(shape.n_corners);
  SortedCorners corners{shape.family, {}};
  corners.nodes.fill(behind_all_nodes);
  std::transform(nodes.begin(), nodes.end(), corners.nodes.begin(),
                 [](NodeIndex node) { return node.value; });
  std::sort(corners.nodes.begin(), corners.nodes.begin() + static_cast<std::ptrdiff_t>(nodes.size()));
  return corners;
}

/// Calls `visit(element, its smallest node)` for all solids and shells in their order.
template <class Visit>
void for_each_element(const Mesh& mesh, Visit&& visit) {
  for (const ElementBlock& block : mesh.blocks()) {
    if (!has_corners(block)) continue;
    const std::size_t n_corners = topology(block.shape).n_corners;
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      const auto nodes = block.element_nodes(e).first(n_corners);
      visit(ElementIndex{block.first_element.value + e}, std::min_element(nodes.begin(), nodes.end())->value);
    }
  }
}

/// The elements by their smallest node: bucket `node` is [begin[node], begin[node + 1]), each in mesh order.
struct NodeBuckets {
  std::vector<std::uint32_t> begin, elements;
};

NodeBuckets make_buckets(const Mesh& mesh) {
  NodeBuckets buckets{std::vector<std::uint32_t>(mesh.n_nodes() + 1, 0), {}};
  std::uint32_t n = 0;
  for_each_element(mesh, [&](ElementIndex, std::uint32_t node) { ++buckets.begin[node], ++n; });
  std::uint32_t total = 0;
  for (std::uint32_t& count : buckets.begin) total += std::exchange(count, total);
  buckets.elements.resize(n);
  std::vector<std::uint32_t> next(buckets.begin);
  for_each_element(mesh, [&](ElementIndex element, std::uint32_t node) {
    buckets.elements[next[node]++] = element.value;
  });
  return buckets;
}

}  // namespace

std::optional<CoincidentElements> find_coincident_elements(const Mesh& mesh) {
  const NodeBuckets buckets = make_buckets(mesh);
  CoincidentElements found;
  std::vector<std::pair<SortedCorners, std::uint32_t>> bucket;
  std::vector<std::uint64_t> sums;
  for (std::size_t node = 0; node + 1 < buckets.begin.size(); ++node) {
    const std::uint32_t begin = buckets.begin[node], end = buckets.begin[node + 1];
    if (end - begin < 2) continue;
    sums.clear();
    for (std::uint32_t i = begin; i < end; ++i) sums.push_back(sum_of_corners(mesh, {buckets.elements[i]}));
    std::ranges::sort(sums);
    if (std::ranges::adjacent_find(sums) == sums.end()) continue;
    bucket.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      const ElementBlock& block = mesh.blocks()[mesh.block_of({buckets.elements[i]})];
      bucket.emplace_back(corners_of(block, buckets.elements[i] - block.first_element.value),
                          buckets.elements[i]);
    }
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (bucket[i].first != bucket[i - 1].first) continue;
      const ElementIndex element{bucket[i].second};
      if (found.n++ == 0 || element < found.first) found = {found.n, element, {bucket[i - 1].second}};
    }
  }
  return found.n > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace contactsim
