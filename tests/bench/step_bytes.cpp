// SPDX-License-Identifier: BSD-3-Clause
#include "kernel.hpp"

namespace contactsim::bench {

namespace {

constexpr double vector_bytes = 3 * sizeof(double);

}  // namespace

double bytes_of_forces(const Model& model, const State& state) {
  double n_bytes = 0.0;
  const auto n_nodes = static_cast<double>(state.coordinates.cols());
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const ModelBlock& block = model.blocks[i];
    const ModelBlockState& values = state.blocks[i];
    const std::size_t read = block.mass.size() + block.thickness.size() + block.inertia.size();
    n_bytes += static_cast<double>((2 * values.values.size() + read) * sizeof(Lanes));
    n_bytes += static_cast<double>(block.nodes.size() * sizeof(ChunkNode));
    const std::size_t n_places = block.chunk_nodes.size();
    const bool turns = !values.moments.empty();
    // Written by the elements, read by the sums, once as forces and once as moments; places of the sums.
    n_bytes +=
        static_cast<double>((turns ? 2 : 1) * n_places * (2 * sizeof(NodeVector) + sizeof(std::uint32_t)));
    n_bytes += static_cast<double>(n_places * sizeof(std::uint32_t));
    // Position, velocity and, three times, force: set to zero, read, written; two numbers of the sums.
    n_bytes += n_nodes * (5.0 * vector_bytes + 2.0 * sizeof(std::uint32_t));
    if (turns) n_bytes += n_nodes * (4.0 * vector_bytes + 2.0 * sizeof(std::uint32_t));
  }
  return n_bytes;
}

double bytes_of_integration(const State& state) {
  // Motion: acceleration read, velocity and position read and written. Accelerations: two forces and mass
  // read, one written. Completion: acceleration, mass, two forces and velocity read, velocity written.
  constexpr double n_vectors = 5.0 + 4.0 + 6.0;
  return n_vectors * vector_bytes * static_cast<double>(state.coordinates.cols());
}

}  // namespace contactsim::bench
