// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid_block.hpp"

#include <algorithm>

#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

std::vector<std::uint32_t> batch_nodes(const ElementBlock& block, std::size_t n_batches) {
  const auto n_nodes = static_cast<std::size_t>(block.nodes_per_element);
  std::vector<std::uint32_t> nodes(n_batches * n_nodes * n_lanes);
  for (std::size_t i = 0; i < n_batches * n_lanes; ++i) {
    const std::size_t element = std::min<std::size_t>(i, block.n_elements - 1);
    const std::span<const NodeIndex> corners = block.element_nodes(static_cast<std::uint32_t>(element));
    for (std::size_t corner = 0; corner < n_nodes; ++corner)
      nodes[(i / n_lanes * n_nodes + corner) * n_lanes + i % n_lanes] = corners[corner].value;
  }
  return nodes;
}

}  // namespace

SolidBlock make_solid_block(const Mesh& mesh, std::uint32_t mesh_block, const SolidElement& element,
                            const SolidProperties& properties) {
  const ElementBlock& source = mesh.blocks()[mesh_block];
  const std::size_t n_batches = (source.n_elements + n_lanes - 1) / n_lanes;
  SolidBlock block{&element,
                   mesh_block,
                   source.first_element,
                   source.n_elements,
                   properties,
                   {},
                   {},
                   std::vector<Lanes>(n_batches),
                   {}};
  block.layout = {element.n_points, 6 + state_of(properties.law).n_state, element.n_own};
  block.nodes = batch_nodes(source, n_batches);
  block.sums = NodeSums(source.nodes, element.n_nodes, mesh.n_nodes());
  for (std::size_t i = 0; i < n_batches; ++i)
    block.mass[i] = properties.density * element.volume(block.batch_nodes(i), mesh.coordinates());
  return block;
}

SolidBlockState make_state(const SolidBlock& block) {
  SolidBlockState state;
  state.values.assign(block.n_batches() * block.layout.size(), Lanes::Zero());
  state.forces.assign(block.n_batches() * 3 * block.element->n_nodes, Lanes::Zero());
  for (std::size_t batch = 0; batch < block.n_batches(); ++batch) {
    for (std::size_t point = 0; point < block.layout.n_points; ++point) {
      const std::size_t size = block.layout.point_size;
      start_state(block.properties.law, state.batch(block.layout, batch).subspan(point * size + 6, size - 6));
    }
  }
  return state;
}

}  // namespace contactsim
