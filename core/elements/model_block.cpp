// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/model_block.hpp"

#include <algorithm>

#include "core/base/memory_pages.hpp"
#include "core/base/optional_index.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

static_assert(ModelBlock::batches_per_chunk * n_lanes * 10 <= std::numeric_limits<ChunkNode>::max() + 1,
              "the nodes of a chunk of ten-node tetrahedra have numbers");

/// Numbers the nodes of a block chunk by chunk, in the order in which its elements name them first.
class ChunkNumbering {
 public:
  ChunkNumbering(const Mesh& mesh, const ElementBlock& source) : source_(source), number_(mesh.n_nodes()) {}

  /// To be called before the first chunk.
  void begin(ModelBlock& block) const {
    block.chunks.clear();
    block.chunk_nodes.clear();
    block.nodes.clear();
    block.nodes.reserve(block.n_batches() * n_lanes * static_cast<std::size_t>(source_.nodes_per_element));
  }
  /// To be called after the last one: how many nodes chunks have is not known before.
  static void end(ModelBlock& block) { block.chunk_nodes.shrink_to_fit(); }

  void add_chunk(std::size_t first_batch, std::size_t n_batches, ModelBlock& block) {
    const std::size_t first_node = block.chunk_nodes.size();
    for (std::size_t batch = first_batch; batch < first_batch + n_batches; ++batch)
      add_batch(batch, first_node, block);
    const BatchChunk chunk{first_batch, n_batches, first_node, block.chunk_nodes.size() - first_node};
    for (const std::uint32_t node : block.nodes_of(chunk)) number_[node] = std::nullopt;
    block.chunks.push_back(chunk);
  }

 private:
  void add_batch(std::size_t batch, std::size_t first_node, ModelBlock& block) {
    for (int corner = 0; corner < source_.nodes_per_element; ++corner) {
      for (std::size_t lane = 0; lane < n_lanes; ++lane) {
        const std::size_t element = std::min<std::size_t>(batch * n_lanes + lane, source_.n_elements - 1);
        const NodeIndex node =
            source_.element_nodes(static_cast<std::uint32_t>(element))[static_cast<std::size_t>(corner)];
        OptionalIndex<std::uint32_t>& number = number_[node.value];
        if (!number) {
          number = static_cast<std::uint32_t>(block.chunk_nodes.size() - first_node);
          block.chunk_nodes.push_back(node.value);
        }
        block.nodes.push_back(static_cast<ChunkNode>(*number));
      }
    }
  }

  const ElementBlock& source_;
  std::vector<OptionalIndex<std::uint32_t>> number_;  ///< [n_nodes] in the chunk at hand
};

}  // namespace

namespace {

/// All but the masses.
ModelBlock make_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                      const ElementProperties& properties) {
  const ElementBlock& source = mesh.blocks()[mesh_block];
  ModelBlock block;
  block.element = &element;
  block.mesh_block = mesh_block;
  block.first_element = source.first_element;
  block.n_elements = source.n_elements;
  block.properties = properties;
  block.layout = {element.n_points, 6 + properties.law.kind().n_state, element.n_own};
  block.mass.resize((source.n_elements + n_lanes - 1) / n_lanes);
  ChunkNumbering numbering(mesh, source);
  numbering.begin(block);
  for (std::size_t batch = 0; batch < block.n_batches(); batch += ModelBlock::batches_per_chunk)
    numbering.add_chunk(batch, std::min(ModelBlock::batches_per_chunk, block.n_batches() - batch), block);
  ChunkNumbering::end(block);
  block.sums = NodeSums(block.chunk_nodes, mesh.n_nodes());
  return block;
}

/// How many batches from one on go into a chunk.
std::size_t find_chunk_size(std::span<const std::uint8_t> is_subcycled, std::size_t first) {
  std::size_t end = first + 1;
  const std::size_t last = std::min(first + ModelBlock::batches_per_chunk, is_subcycled.size());
  while (end < last && is_subcycled[end] == is_subcycled[first]) ++end;
  return end - first;
}

std::vector<Lanes> in_lanes(std::span<const double> numbers, std::size_t n_batches) {
  std::vector<Lanes> lanes(n_batches);
  for (std::size_t i = 0; i < n_batches * n_lanes; ++i)
    lanes[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes)) = numbers[std::min(i, numbers.size() - 1)];
  return lanes;
}

void set_masses(const Mesh& mesh, ModelBlock& block) {
  for (const BatchChunk& chunk : block.chunks)
    block.element->volumes(block, chunk, mesh.coordinates(), block.mass);
  for (Lanes& mass : block.mass) mass *= block.properties.density;
}

}  // namespace

ModelBlock make_solid_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                            const ElementProperties& properties) {
  ModelBlock block = make_block(mesh, mesh_block, element, properties);
  set_masses(mesh, block);
  return block;
}

ModelBlock make_shell_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                            const ElementProperties& properties, const ShellSettings& settings,
                            std::span<const double> thickness) {
  ModelBlock block = make_block(mesh, mesh_block, element, properties);
  block.layout.n_points = settings.layers.size();
  if (settings.drilling > 0.0) block.layout.n_own += element.n_nodes;
  block.shell = settings;
  block.thickness = in_lanes(thickness, block.n_batches());
  set_masses(mesh, block);
  if (!element.has_rotations) return block;
  const double across = 1.0 / 12.0 + settings.offset * settings.offset;
  for (std::size_t i = 0; i < block.n_batches(); ++i) {
    const Lanes& t = block.thickness[i];
    const Lanes area = block.mass[i] / (properties.density * t);
    block.inertia.push_back(block.mass[i] * (across * t * t).max(area / 8.0));
  }
  return block;
}

ModelBlock make_line_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                           const ElementProperties& properties, const BeamShapeSettings& beam,
                           std::span<const double> sizes) {
  ModelBlock block = make_block(mesh, mesh_block, element, properties);
  block.layout.n_points = beam.fibres.size();
  block.beam = beam;
  block.section = in_lanes(sizes, block.n_batches());
  set_masses(mesh, block);
  if (!element.has_rotations) return block;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  // moment of area about the nodes
  for (const BeamFibre& fibre : beam.fibres) first += fibre.area * Eigen::Vector2d(fibre.t, fibre.s);
  const double radius_squared = 2.0 * std::max(beam.second_t, beam.second_s) / beam.area +
                                first.squaredNorm() / (beam.area * beam.area);
  for (const Lanes& mass : block.mass) block.inertia.push_back(mass * radius_squared);
  return block;
}

ModelBlock make_discrete_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                               double density, std::span<const double> sizes) {
  ModelBlock block = make_block(mesh, mesh_block, element, ElementProperties{{}, density});
  block.layout.n_points = 1;
  block.section = in_lanes(sizes, block.n_batches());
  set_masses(mesh, block);
  return block;
}

void split_chunks(const Mesh& mesh, std::span<const std::uint8_t> is_subcycled, ModelBlock& block) {
  ChunkNumbering numbering(mesh, mesh.blocks()[block.mesh_block]);
  numbering.begin(block);
  for (std::size_t first = 0; first < block.n_batches();) {
    const std::size_t n_batches = find_chunk_size(is_subcycled, first);
    numbering.add_chunk(first, n_batches, block);
    block.chunks.back().is_subcycled = is_subcycled[first] != 0;
    first += n_batches;
  }
  ChunkNumbering::end(block);
  block.sums = NodeSums(block.chunk_nodes, mesh.n_nodes(), find_places(block, false));
}

std::vector<std::uint32_t> find_places(const ModelBlock& block, bool is_subcycled) {
  std::vector<std::uint32_t> places;
  for (const BatchChunk& chunk : block.chunks) {
    if (chunk.is_subcycled != is_subcycled) continue;
    for (std::size_t i = 0; i < chunk.n_nodes; ++i)
      places.push_back(static_cast<std::uint32_t>(chunk.first_node + i));
  }
  return places;
}

ModelBlockState make_state(const ModelBlock& block) {
  ModelBlockState state;
  assign_in_huge_pages<Lanes>(block.n_batches() * block.layout.size(), Lanes::Zero(), state.values);
  assign_in_huge_pages<NodeVector>(block.chunk_nodes.size(), NodeVector::Zero(), state.forces);
  if (block.element->has_rotations) state.moments = state.forces;
  for (std::size_t batch = 0; batch < block.n_batches(); ++batch) {
    for (std::size_t point = 0; point < block.layout.n_points; ++point) {
      const std::size_t size = block.layout.point_size;
      const auto material = state.batch(block.layout, batch).subspan(point * size + 6, size - 6);
      block.properties.law.start(material);
      if (block.preload.load != 0.0 && block.preload.period == 0.0)
        state.batch(block.layout, batch)[point * size] = block.preload.load / block.section[batch];
      if (block.directions.empty()) continue;
      const std::size_t place = 6 * block.properties.law.kind().n_tensors;
      std::copy_n(block.directions.begin() + static_cast<std::ptrdiff_t>(6 * batch), 6,
                  material.begin() + static_cast<std::ptrdiff_t>(place));
    }
  }
  return state;
}

}  // namespace contactsim
