// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/block_energy_watch.hpp"

#include <algorithm>
#include <numeric>

#include "app/run/energy_watch.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// A negative energy is worth a warning when it is this share of the largest term of the balance.
constexpr double worrying_loss = 0.01;

/// Elastic energy of a stress, that of elements of several points taken as spread evenly; doubled, since the
/// points of shells and beams are not and laws differ from Hooke's at large strains.
constexpr double margin = 2.0;

/// Elements of a batch that are no copies.
std::size_t n_used(const ModelBlock& block, std::size_t batch) {
  return std::min<std::size_t>(n_lanes, block.n_elements - batch * n_lanes);
}

/// The work done on the stresses of a chunk [energy].
double stress_work(const ModelBlock& block, const ModelBlockState& state, const BatchChunk& chunk) {
  double sum = 0.0;
  for (std::size_t batch = chunk.first_batch; batch < chunk.first_batch + chunk.n_batches; ++batch) {
    const Lanes& work = state.values[batch * block.layout.size() + block.layout.energy()];
    sum += work.sum_of_first(n_used(block, batch));
  }
  return sum;
}

/// What its stresses hold now [energy].
double elastic_energy(const ModelBlock& block, const ModelBlockState& state, const BatchChunk& chunk) {
  const ElasticModuli moduli = block.properties.law.moduli();
  const StateLayout& layout = block.layout;
  double sum = 0.0;
  for (std::size_t batch = chunk.first_batch; batch < chunk.first_batch + chunk.n_batches; ++batch) {
    Lanes density = Lanes::Zero();
    for (std::size_t point = 0; point < layout.n_points; ++point) {
      SymmetricLanes stress;
      for (std::size_t i = 0; i < 6; ++i)
        stress[i] = state.values[batch * layout.size() + point * layout.point_size + i];
      const SymmetricLanes spread = deviator(stress);
      const Lanes mean = trace(stress) / 3.0;
      density += contract(spread, spread) / (4.0 * moduli.shear) + mean * mean / (2.0 * moduli.bulk);
    }
    sum += (density * block.mass[batch]).sum_of_first(n_used(block, batch));
  }
  return sum / (block.properties.density * static_cast<double>(layout.n_points));
}

bool has_stress(const ModelBlock& block) {
  return block.element->has_material() && !block.is_rigid && block.layout.n_points > 0;
}

}  // namespace

/// Of each block the sum of what its chunks have, in their order; 0 of blocks without stress.
template <class OfChunk>
std::vector<double> BlockEnergyWatch::sum_over_blocks(const OfChunk& of_chunk) const {
  std::vector<double> chunks, sums;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    const ModelBlock& block = model_.blocks[b];
    const std::size_t first = chunks.size();
    chunks.resize(first + block.chunks.size(), 0.0);
    if (!has_stress(block)) continue;
    const ChunkRange own = share_ != nullptr ? share_->own_chunks(b) : ChunkRange{0, block.chunks.size()};
    for (std::size_t c = own.begin; c < own.end; ++c) chunks[first + c] = of_chunk(b, block.chunks[c]);
  }
  if (share_ != nullptr) share_->complete_chunks(std::span(chunks));
  const double* next = chunks.data();
  for (const ModelBlock& block : model_.blocks) {
    sums.push_back(std::accumulate(next, next + block.chunks.size(), 0.0));
    next += block.chunks.size();
  }
  return sums;
}

void BlockEnergyWatch::begin(const State& state) {
  blocks_.clear();
  const std::vector<double> energies = sum_over_blocks([&](std::size_t b, const BatchChunk& chunk) {
    return elastic_energy(model_.blocks[b], state.blocks[b], chunk);
  });
  for (const double energy : energies) blocks_.push_back({margin * energy});
}

std::vector<NegativeEnergy> BlockEnergyWatch::look(const State& state) {
  std::vector<NegativeEnergy> found;
  const double largest = state.energies.largest;
  if (!(largest > energy_of_round_off(model_, state.dt))) return found;
  const std::vector<double> works = sum_over_blocks([&](std::size_t b, const BatchChunk& chunk) {
    return stress_work(model_.blocks[b], state.blocks[b], chunk);
  });
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    const ModelBlock& block = model_.blocks[i];
    if (blocks_[i].is_reported || !has_stress(block)) continue;
    const double stress_energy = works[i], hourglass_energy = state.blocks[i].hourglass_work;
    const bool is_of_hourglasses = hourglass_energy < -worrying_loss * largest;
    if (!is_of_hourglasses && stress_energy >= -blocks_[i].reserve - worrying_loss * largest) continue;
    blocks_[i].is_reported = true;
    found.push_back(
        {block.mesh_block, is_of_hourglasses ? hourglass_energy : stress_energy, is_of_hourglasses});
  }
  return found;
}

}  // namespace contactsim
