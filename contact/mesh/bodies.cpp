// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/bodies.hpp"

#include <algorithm>
#include <numeric>

namespace contactsim {

std::vector<std::uint32_t> find_bodies(const Mesh& mesh) {
  std::vector<std::uint32_t> body(mesh.n_nodes());
  std::iota(body.begin(), body.end(), 0u);
  const auto first_of = [&](std::uint32_t node) {
    while (body[node] != node) node = body[node] = body[body[node]];
    return node;
  };
  for (const ElementBlock& block : mesh.blocks()) {
    const Family family = topology(block.shape).family;
    if (family != Family::solid && family != Family::shell) continue;
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      const auto nodes = block.element_nodes(e);
      std::uint32_t first = first_of(nodes[0].value);
      for (const NodeIndex node : nodes.subspan(1)) {
        const std::uint32_t other = first_of(node.value);
        body[std::max(first, other)] = std::min(first, other);
        first = std::min(first, other);
      }
    }
  }
  for (std::uint32_t i = 0; i < body.size(); ++i) body[i] = first_of(i);
  return body;
}

}  // namespace contactsim
