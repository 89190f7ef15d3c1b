// SPDX-License-Identifier: BSD-3-Clause
#include "core/internal_force.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/elements/element_table.hpp"
#include "core/errors.hpp"
#include "core/threads.hpp"

namespace contactsim {

namespace {

/// Batches whose sums are made together. Fixed, so that the sums do not depend on the number of threads.
constexpr std::size_t batches_per_chunk = 64;

std::size_t n_chunks(const SolidBlock& block) {
  return (block.n_batches() + batches_per_chunk - 1) / batches_per_chunk;
}

/// The first element of the block whose volume is not positive.
std::size_t find_inverted(const SolidBlock& block, const Eigen::Matrix3Xd& coordinates) {
  for (std::size_t element = 0; element < block.n_elements; ++element) {
    const Lanes volume = block.element->volume(block.batch_nodes(element / n_lanes), coordinates);
    if (!(volume(static_cast<Eigen::Index>(element % n_lanes)) > 0.0)) return element;
  }
  return 0;
}

}  // namespace

InternalForce::InternalForce(const Model& model, State& state) : model_(model), state_(state) {
  std::size_t most = 0;
  for (const SolidBlock& block : model.blocks) most = std::max(most, n_chunks(block));
  chunks_.resize(most);
}

void InternalForce::advance_chunks(std::size_t index, const Motion& motion) {
  const SolidBlock& block = model_.blocks[index];
  SolidBlockState& state = state_.blocks[index];
#pragma omp parallel for schedule(static) num_threads(threads_for(block.n_elements * 10))
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(n_chunks(block)); ++i) {
    const std::size_t begin = static_cast<std::size_t>(i) * batches_per_chunk;
    const std::size_t end = std::min(begin + batches_per_chunk, block.n_batches());
    chunks_[static_cast<std::size_t>(i)] = block.element->advance(block, motion, begin, end, state);
  }
}

void InternalForce::stop_at_inverted(const SolidBlock& block, const Motion& motion) const {
  const std::size_t element = find_inverted(block, motion.coordinates);
  const auto position = block.first_element.value + static_cast<std::uint32_t>(element);
  throw SolveError(state_.step, motion.time,
                   fmt::format("element {} of {} has turned inside out", model_.mesh->element_id({position}),
                               model_.mesh->name({EntityKind::block, block.mesh_block})));
}

ForceReport InternalForce::set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) {
  forces.setZero();
  ForceReport report;
  for (std::size_t index = 0; index < model_.blocks.size(); ++index) {
    const SolidBlock& block = model_.blocks[index];
    advance_chunks(index, motion);
    for (std::size_t i = 0; i < n_chunks(block); ++i) {
      const BatchesStep& chunk = chunks_[i];
      if (!(chunk.least_volume > 0.0)) stop_at_inverted(block, motion);
      if (chunk.stable_step < report.stable_step) {
        report.stable_step = chunk.stable_step;
        report.critical_element = {block.first_element.value +
                                   static_cast<std::uint32_t>(chunk.critical_element)};
      }
      report.hourglass_work += chunk.hourglass_work;
      report.viscous_work += chunk.viscous_work;
    }
    block.sums.add(state_.blocks[index].forces, forces);
  }
  return report;
}

}  // namespace contactsim
