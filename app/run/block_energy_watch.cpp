// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/block_energy_watch.hpp"

#include <algorithm>

#include "app/run/energy_watch.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// A negative energy is worth a warning when it is this share of the largest term of the balance.
constexpr double worrying_loss = 0.01;

/// Elastic energy of a stress, that of elements of several points taken as spread evenly; doubled, since the
/// points of shells and beams are not and laws differ from Hooke's at large strains.
constexpr double margin = 2.0;

double stress_work(const ModelBlock& block, const ModelBlockState& state) {
  double sum = 0.0;
  for (std::size_t element = 0; element < block.n_elements; ++element)
    sum += state.at(block.layout, element, block.layout.energy());
  return sum;
}

/// What the stresses hold now [energy].
double elastic_energy(const ModelBlock& block, const ModelBlockState& state) {
  const ElasticModuli moduli = block.properties.law.moduli();
  const StateLayout& layout = block.layout;
  double sum = 0.0;
  for (std::size_t batch = 0; batch < block.n_batches(); ++batch) {
    Lanes density = Lanes::Zero();
    for (std::size_t point = 0; point < layout.n_points; ++point) {
      SymmetricLanes stress;
      for (std::size_t i = 0; i < 6; ++i)
        stress[i] = state.values[batch * layout.size() + point * layout.point_size + i];
      const SymmetricLanes spread = deviator(stress);
      const Lanes mean = trace(stress) / 3.0;
      density += contract(spread, spread) / (4.0 * moduli.shear) + mean * mean / (2.0 * moduli.bulk);
    }
    const auto n_used = std::min<std::size_t>(n_lanes, block.n_elements - batch * n_lanes);
    sum += (density * block.mass[batch]).sum_of_first(n_used);
  }
  return sum / (block.properties.density * static_cast<double>(layout.n_points));
}

bool has_stress(const ModelBlock& block) {
  return block.element->has_material() && !block.is_rigid && block.layout.n_points > 0;
}

}  // namespace

void BlockEnergyWatch::begin(const State& state) {
  blocks_.clear();
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    const ModelBlock& block = model_.blocks[i];
    blocks_.push_back({has_stress(block) ? margin * elastic_energy(block, state.blocks[i]) : 0.0});
  }
}

std::vector<NegativeEnergy> BlockEnergyWatch::look(const State& state) {
  std::vector<NegativeEnergy> found;
  const double largest = state.energies.largest;
  if (!(largest > energy_of_round_off(model_, state.dt))) return found;
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    const ModelBlock& block = model_.blocks[i];
    if (blocks_[i].is_reported || !has_stress(block)) continue;
    const double stress_energy = stress_work(block, state.blocks[i]);
    const double hourglass_energy = state.blocks[i].hourglass_work;
    const bool is_of_hourglasses = hourglass_energy < -worrying_loss * largest;
    if (!is_of_hourglasses && stress_energy >= -blocks_[i].reserve - worrying_loss * largest) continue;
    blocks_[i].is_reported = true;
    found.push_back(
        {block.mesh_block, is_of_hourglasses ? hourglass_energy : stress_energy, is_of_hourglasses});
  }
  return found;
}

}  // namespace contactsim
