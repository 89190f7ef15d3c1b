// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The elements of every node of a mesh. Time and memory O(n).
class NodeElements {
 public:
  explicit NodeElements(const Mesh& mesh);

  /// Ascending, each once. Elements of unknown shapes have no nodes.
  std::span<const ElementIndex> of(NodeIndex node) const {
    return std::span(elements_).subspan(begin_[node.value], begin_[node.value + 1] - begin_[node.value]);
  }

 private:
  std::vector<std::uint32_t> begin_;    ///< [n_nodes + 1]
  std::vector<ElementIndex> elements_;  ///< by node
};

}  // namespace contactsim
