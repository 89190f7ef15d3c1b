// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/internal_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.hpp"
#include "core/base/threads.hpp"
#include "core/dynamics/block_at_rest.hpp"
#include "core/dynamics/discrete_steps.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/elements/element_batches.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/elements.hpp"

namespace contactsim {

namespace {

/// The first element of the chunks, which follow each other, whose volume is not positive.
std::size_t find_inverted(const ModelBlock& block, std::span<const BatchChunk> chunks,
                          const Eigen::Matrix3Xd& coordinates) {
  std::vector<Lanes> volumes(block.n_batches());
  for (const BatchChunk& chunk : chunks) block.element->volumes(block, chunk, coordinates, volumes);
  const std::size_t first = n_lanes * chunks.front().first_batch;
  const std::size_t end = n_lanes * (chunks.back().first_batch + chunks.back().n_batches);
  for (std::size_t element = first; element < std::min(end, block.n_elements); ++element) {
    if (!(volumes[element / n_lanes](static_cast<Eigen::Index>(element % n_lanes)) > 0.0)) return element;
  }
  return first;
}

/// As all elements, or those of rigid bodies, would be stable at rest in the mesh if they were elastic.
double find_step_at_rest(const Model& model, bool only_rigid) {
  double step = std::numeric_limits<double>::infinity();
  for (const ModelBlock& block : model.blocks) {
    if (only_rigid && !block.is_rigid) continue;
    BlockAtRest at_rest(*model.mesh, block);
    for (const BatchChunk& chunk : block.chunks) step = std::min(step, at_rest.stable_step(chunk));
  }
  return step;
}

/// The time that sound takes through the smallest particle: particles have no stress, but what they are made
/// of says how fast they may answer a hit.
double find_step_of_particles(const Model& model) {
  double step = std::numeric_limits<double>::infinity();
  for (const ModelBlock& block : model.blocks) {
    if (block.element != &sphere_particle) continue;
    const ElementProperties& properties = block.properties;
    const ElasticModuli moduli = properties.law.moduli();
    const double speed = std::sqrt((moduli.bulk + 4.0 / 3.0 * moduli.shear) / properties.density);
    for (std::size_t i = 0; i < block.n_elements; ++i) {
      const double radius = block.section[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes));
      step = std::min(step, 2.0 * radius / speed);
    }
  }
  return step;
}

}  // namespace

InternalForce::InternalForce(const Model& model, State& state, RankShare* share)
    : model_(model),
      state_(state),
      share_(share),
      nodes_(share != nullptr ? share->followed() : NodeRanges(model.mesh->n_nodes())),
      other_nodes_(std::span<const NodeRange>()),
      idle_step_(find_step_at_rest(model, true)) {
  find_first_sums();
  first_chunk_.push_back(0);
  for (const ModelBlock& block : model.blocks)
    first_chunk_.push_back(first_chunk_.back() + block.chunks.size());
  chunks_.assign(first_chunk_.back(), batches::no_step());
}

/// Forces are set by the first block that has a node, where that can be told of whole blocks, and only else
/// set to zero before.
void InternalForce::find_first_sums() {
  std::vector<std::uint8_t> is_summed(model_.mesh->n_nodes(), 0), is_set(is_summed);
  for (const ModelBlock& block : model_.blocks) {
    const std::vector<NodeIndex> of_block = block.is_rigid ? std::vector<NodeIndex>() : block.sums.nodes();
    const bool sets =
        std::ranges::none_of(of_block, [&](NodeIndex node) { return is_summed[node.value] != 0; });
    sets_.push_back(sets ? 1 : 0);
    for (const NodeIndex node : of_block) {
      is_summed[node.value] = 1;
      if (sets) is_set[node.value] = 1;
    }
  }
  other_nodes_ =
      nodes_.without([&](std::int64_t node) { return is_set[static_cast<std::size_t>(node)] != 0; });
}

std::span<const ChunkStep> InternalForce::steps_of(std::size_t block) const {
  return std::span(chunks_).subspan(first_chunk_[block], first_chunk_[block + 1] - first_chunk_[block]);
}

void InternalForce::advance_chunks(const Motion& motion) {
  for (std::size_t index = 0; index < model_.blocks.size(); ++index) {
    const ModelBlock& block = model_.blocks[index];
    if (block.is_rigid) continue;
    ModelBlockState& state = state_.blocks[index];
    const ChunkRange own = share_ != nullptr ? share_->own_chunks(index) : ChunkRange{0, block.chunks.size()};
    parallel_for(own.size(), threads_for(block.n_elements * 10), [&](std::size_t i) {
      const std::size_t chunk = own.begin + i;
      if (block.chunks[chunk].is_subcycled) return;
      chunks_[first_chunk_[index] + chunk] =
          block.element->advance(block, block.chunks[chunk], motion, state);
    });
  }
  if (share_ != nullptr) share_->exchange(chunks_, state_);
}

void stop_at_inverted(const Mesh& mesh, const ModelBlock& block, std::span<const BatchChunk> chunks,
                      const Motion& motion) {
  const std::size_t element = find_inverted(block, chunks, motion.coordinates);
  const auto position = block.first_element.value + static_cast<std::uint32_t>(element);
  throw SolveError(motion.time,
                   fmt::format("element {} of {} has turned inside out", mesh.element_id({position}),
                               mesh.name({EntityKind::block, block.mesh_block})));
}

namespace {

/// What each kind of elements would allow alone.
struct StableSteps {
  double material = infinity, stiffness = infinity, damping = infinity;  ///< [time]

  double& of(StepRule rule) {
    if (rule == StepRule::stiffness) return stiffness;
    return rule == StepRule::damping ? damping : material;
  }
  double min() const { return std::min({material, stiffness, damping}); }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

}  // namespace

ForceReport InternalForce::set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) {
  other_nodes_.set_zero(forces);
  advance_chunks(motion);
  ForceReport report;
  StableSteps steps;
  for (std::size_t index = 0; index < model_.blocks.size(); ++index) {
    const ModelBlock& block = model_.blocks[index];
    if (block.is_rigid) continue;
    for (const ChunkStep& chunk : steps_of(index)) {
      if (!(chunk.min_volume > 0.0)) {
        if (share_ != nullptr) share_->complete_nodes(state_);  // of which the motion has the coordinates
        stop_at_inverted(*model_.mesh, block, block.chunks, motion);
      }
      if (chunk.stable_step < steps.min()) {
        report.critical_element = {block.first_element.value +
                                   static_cast<std::uint32_t>(chunk.critical_element)};
      }
      double& step = steps.of(block.element->step_rule);
      step = std::min(step, chunk.stable_step);
      report.hourglass_work += chunk.hourglass_work;
      state_.blocks[index].hourglass_work += chunk.hourglass_work;
      report.viscous_work += chunk.viscous_work;
    }
    const std::span<const NodeVector> parts = state_.blocks[index].forces;
    sets_[index] != 0 ? block.sums.set(parts, nodes_, forces) : block.sums.add(parts, nodes_, forces);
  }
  report.stable_step = combined_step(steps.material, steps.stiffness, steps.damping);
  if (std::isinf(report.stable_step)) {
    if (std::isinf(idle_step_)) idle_step_ = find_step_at_rest(model_, false);
    if (std::isinf(idle_step_)) idle_step_ = find_step_of_particles(model_);
    report.stable_step = idle_step_;
  }
  return report;
}

void InternalForce::set_moments(const Motion& /*motion*/, Eigen::Matrix3Xd& moments) {
  nodes_.set_zero(moments);
  for (std::size_t index = 0; index < model_.blocks.size(); ++index) {
    const ModelBlock& block = model_.blocks[index];
    if (block.element->has_rotations && !block.is_rigid)
      block.sums.add(state_.blocks[index].moments, nodes_, moments);
  }
}

}  // namespace contactsim
