// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/hex_block.hpp"

#include <algorithm>
#include <limits>

namespace contactsim {

namespace {

/// Batches whose sums are made together. Fixed, so that the sums do not depend on the number of threads.
constexpr std::size_t batches_per_chunk = 64;

/// What each of the lanes in use adds.
void add_lanes(const HexStep& step, Eigen::Index n, BlockStep& sums) {
  sums.stable_step = std::min(sums.stable_step, step.stable_step.head(n).minCoeff());
  sums.least_volume = std::min(sums.least_volume, step.volume.head(n).minCoeff());
  sums.hourglass_work += step.hourglass_work.head(n).sum();
  sums.viscous_work += step.viscous_work.head(n).sum();
}

void add(const BlockStep& part, BlockStep& sums) {
  sums.stable_step = std::min(sums.stable_step, part.stable_step);
  sums.least_volume = std::min(sums.least_volume, part.least_volume);
  sums.hourglass_work += part.hourglass_work;
  sums.viscous_work += part.viscous_work;
}

BlockStep no_elements() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, infinity, 0.0, 0.0};
}

}  // namespace

template <class Law>
HexVectors HexBlock<Law>::gather(const Batch& batch, const Eigen::Matrix3Xd& values) {
  HexVectors gathered;
  const double* data = values.data();
  for (std::size_t node = 0; node < 8; ++node) {
    for (std::size_t lane = 0; lane < n_lanes; ++lane) {
      const double* vector = data + std::size_t{3} * batch.nodes[node][lane];
      for (std::size_t i = 0; i < 3; ++i) gathered[i][node](static_cast<Eigen::Index>(lane)) = vector[i];
    }
  }
  return gathered;
}

template <class Law>
void HexBlock<Law>::set_up(const ElementBlock& block, const Eigen::Matrix3Xd& coordinates,
                           std::size_t index) {
  Batch& batch = batches_[index];
  for (std::size_t lane = 0; lane < n_lanes; ++lane) {
    const auto element = static_cast<std::uint32_t>(std::min(index * n_lanes + lane, n_elements_ - 1));
    const auto nodes = block.element_nodes(element);
    for (std::size_t node = 0; node < 8; ++node) batch.nodes[node][lane] = nodes[node].value;
  }
  const HexVectors x = gather(batch, coordinates);
  batch.mass = parameters_.density * hex_volume(x, volume_gradient(x));
}

template <class Law>
BlockStep HexBlock<Law>::advance_batches(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double dt,
                                         std::size_t begin, std::size_t end) {
  BlockStep sums = no_elements();
  for (std::size_t i = begin; i < end; ++i) {
    Batch& batch = batches_[i];
    const HexMotion motion{gather(batch, x), gather(batch, v), batch.mass, dt};
    const HexStep step = advance_hex8(law_, parameters_, motion, batch.state);
    forces_[i] = step.force;
    add_lanes(step, static_cast<Eigen::Index>(std::min<std::size_t>(n_lanes, n_elements_ - i * n_lanes)),
              sums);
  }
  return sums;
}

template <class Law>
BlockStep HexBlock<Law>::advance(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double dt,
                                 Eigen::Matrix3Xd& forces) {
  const std::size_t n_chunks = (batches_.size() + batches_per_chunk - 1) / batches_per_chunk;
  std::vector<BlockStep> parts(n_chunks);
#pragma omp parallel for schedule(static) num_threads(threads_for(n_elements_ * 10))
  for (std::int64_t chunk = 0; chunk < static_cast<std::int64_t>(n_chunks); ++chunk) {
    const auto c = static_cast<std::size_t>(chunk);
    parts[c] = advance_batches(x, v, dt, c * batches_per_chunk,
                               std::min((c + 1) * batches_per_chunk, batches_.size()));
  }
  sums_.add({forces_.front()[0][0].data(), forces_.size() * 24 * n_lanes}, forces);
  BlockStep sums = no_elements();
  for (const BlockStep& part : parts) add(part, sums);
  return sums;
}

template class HexBlock<ElasticLaw>;
template class HexBlock<PlasticLaw<LinearHardening>>;
template class HexBlock<PlasticLaw<PowerHardening>>;
template class HexBlock<PlasticLaw<JohnsonCookHardening>>;

}  // namespace contactsim
