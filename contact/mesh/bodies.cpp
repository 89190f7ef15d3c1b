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
      for (const NodeIndex node : nodes) {
        const auto [low, high] = std::minmax({first_of(nodes[0].value), first_of(node.value)});
        body[high] = low;
      }
    }
  }
  for (std::uint32_t i = 0; i < body.size(); ++i) body[i] = first_of(i);
  return body;
}

}  // namespace contactsim
