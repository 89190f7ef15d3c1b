// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/node_graph.hpp"

#include <algorithm>

#include "core/base/optional_index.hpp"

namespace contactsim {

namespace {

/// Calls do_one(nodes) for every element that is not rigid, and lives.
template <class Do>
void for_each_element(const Mesh& mesh, std::span<const ModelBlock> blocks,
                      std::span<const std::uint8_t> alive, const Do& do_one) {
  for (const ModelBlock& block : blocks) {
    if (block.is_rigid) continue;
    const ElementBlock& of_mesh = mesh.blocks()[block.mesh_block];
    for (std::uint32_t i = 0; i < of_mesh.n_elements; ++i) {
      if (alive.empty() || alive[block.first_element.value + i] != 0) do_one(of_mesh.element_nodes(i));
    }
  }
}

}  // namespace

NodeGraph::NodeGraph(std::uint32_t n_nodes, const Mesh& mesh, std::span<const ModelBlock> blocks,
                     std::uint32_t n_bodies, std::span<const std::uint8_t> alive)
    : first_(n_nodes + std::size_t{1}, 0) {
  // All pairs with their repetitions first, which are then taken out node by node.
  std::vector<std::size_t> end(n_nodes + std::size_t{1}, 0);
  for_each_element(mesh, blocks, alive, [&](std::span<const NodeIndex> nodes) {
    for (const NodeIndex node : nodes) end[node.value + std::size_t{1}] += nodes.size();
  });
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  std::vector<std::uint32_t> pairs(end.back());
  std::vector<std::size_t> place(end.begin(), end.end() - 1);
  for_each_element(mesh, blocks, alive, [&](std::span<const NodeIndex> nodes) {
    for (const NodeIndex node : nodes) {
      for (const NodeIndex other : nodes) pairs[place[node.value]++] = other.value;
    }
  });
  for (std::uint32_t node = 0; node < n_nodes; ++node) {
    const auto begin = pairs.begin() + static_cast<std::ptrdiff_t>(end[node]);
    const auto last = pairs.begin() + static_cast<std::ptrdiff_t>(end[node + std::size_t{1}]);
    std::sort(begin, last);
    neighbours_.insert(neighbours_.end(), begin, std::unique(begin, last));
    first_[node + std::size_t{1}] = neighbours_.size();
  }
  for (std::uint32_t node = n_nodes; node < n_nodes + 2 * n_bodies; ++node) {
    const std::uint32_t centre = node - (node - n_nodes) % 2;
    neighbours_.insert(neighbours_.end(), {centre, centre + 1});
    first_.push_back(neighbours_.size());
  }
}

NodeColours colour_nodes(const NodeGraph& graph, ColourDistance distance) {
  std::vector<OptionalIndex<std::uint32_t>> colours(graph.n_nodes());
  std::vector<OptionalIndex<std::uint32_t>>
      taken_by;  // [n_colours] the last node that may not have the colour
  const auto take = [&](std::uint32_t other, std::uint32_t node) {
    if (colours[other]) taken_by[*colours[other]] = node;
  };
  for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
    if (graph.neighbours(node).empty()) continue;
    for (const std::uint32_t other : graph.neighbours(node)) {
      take(other, node);
      if (distance == ColourDistance::one_element) continue;
      for (const std::uint32_t next : graph.neighbours(other)) take(next, node);
    }
    const auto left = std::find_if(taken_by.begin(), taken_by.end(),
                                   [node](OptionalIndex<std::uint32_t> by) { return by != node; });
    colours[node] = static_cast<std::uint32_t>(left - taken_by.begin());
    if (left == taken_by.end()) taken_by.emplace_back();
  }
  NodeColours made{{}, static_cast<std::uint32_t>(taken_by.size())};
  for (const OptionalIndex<std::uint32_t> colour : colours)
    made.colour.push_back(colour ? *colour : made.n_colours);
  return made;
}

}  // namespace contactsim
