// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/node_elements.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// Calls visit(node, element) for every node of every element, each pair once.
template <class Visit>
void visit_nodes(const Mesh& mesh, const Visit& visit) {
  for (const ElementBlock& block : mesh.blocks()) {
    if (block.nodes.empty()) continue;
    for (std::uint32_t i = 0; i < block.n_elements; ++i) {
      const auto nodes = block.element_nodes(i);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto before = nodes.first(a);
        const bool is_repeated =
            block.has_repeated_nodes && std::find(before.begin(), before.end(), nodes[a]) != before.end();
        if (!is_repeated) visit(nodes[a], ElementIndex{block.first_element.value + i});
      }
    }
  }
}

}  // namespace

NodeElements::NodeElements(const Mesh& mesh) : begin_(mesh.n_nodes() + 1, 0) {
  visit_nodes(mesh, [&](NodeIndex node, ElementIndex) { ++begin_[node.value + 1]; });
  for (std::size_t i = 0; i < mesh.n_nodes(); ++i) begin_[i + 1] += begin_[i];
  elements_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  visit_nodes(mesh, [&](NodeIndex node, ElementIndex element) { elements_[next[node.value]++] = element; });
}

}  // namespace contactsim
