// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_batches.hpp"
#include "core/elements/shell/shell_advance.hpp"

/// Makes a row of the element table from a Geometry of shells; see shell_advance.hpp.
namespace contactsim {

namespace batches {

template <class Geometry>
void shell_volumes(const ModelBlock& block, const BatchChunk& chunk, const Eigen::Matrix3Xd& coordinates,
                   std::span<Lanes> volumes) {
  constexpr std::size_t n = Geometry::n_nodes;
  const ChunkVectors vectors(block.nodes_of(chunk), coordinates);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    NodeVectors<n> x;
    vectors.gather(block.nodes.data() + i * n * n_lanes, x);
    volumes[i] = Geometry(x).area() * block.thickness[i];
  }
}

/// Takes off what the dead and the dying do not give.
template <std::size_t n>
void apply_mask(ElementDeathMask& mask, std::span<Lanes> values, ShellStep<n>& step) {
  mask.apply(step.volume, values);
  mask.limit(step.stable_step);
  mask.scale(step.force);
  mask.scale(step.moment);
  mask.scale(step.stress_work);
  mask.scale(step.hourglass_work);
  mask.scale(step.viscous_work);
}

/// What the lanes in use add.
template <std::size_t n>
void add_lanes(const ShellStep<n>& step, std::size_t first_element, std::size_t n_used, ChunkStep& sums) {
  add_extremes(step.stable_step, step.volume, first_element, n_used, sums);
  sums.hourglass_work += step.hourglass_work.sum_of_first(n_used);
  sums.viscous_work += step.viscous_work.sum_of_first(n_used);
}

/// Nodes that do not turn are as if they had endless inertia.
template <class Geometry>
Lanes inertia_of_shells(const ModelBlock& block, std::size_t batch) {
  if constexpr (Geometry::has_rotations) return block.inertia[batch];
  return Lanes::Constant(std::numeric_limits<double>::infinity());
}

template <class Geometry>
ChunkStep advance_shells(const ModelBlock& block, const BatchChunk& chunk, const Motion& motion,
                         ModelBlockState& state) {
  constexpr std::size_t n = Geometry::n_nodes;
  const ChunkVectors vectors(block.nodes_of(chunk), motion.coordinates, motion.velocity,
                             Geometry::has_rotations ? *motion.angular_velocity : motion.velocity);
  NodeVector* forces = state.forces.data() + chunk.first_node;
  NodeVector* moments = Geometry::has_rotations ? state.moments.data() + chunk.first_node : nullptr;
  std::fill_n(forces, chunk.n_nodes, NodeVector::Zero());
  if (Geometry::has_rotations) std::fill_n(moments, chunk.n_nodes, NodeVector::Zero());
  ChunkStep sums = no_step();
  ElementDeathMask mask(block, state);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    if (!mask.begin(i)) continue;
    const ChunkNode* nodes = block.nodes.data() + i * n * n_lanes;
    const std::span<Lanes> values = state.batch(block.layout, i);
    ShellMotion<n> shell_motion;
    vectors.gather(nodes, shell_motion.x, shell_motion.v, shell_motion.w);
    shell_motion.mass = block.mass[i];
    shell_motion.inertia = inertia_of_shells<Geometry>(block, i);
    shell_motion.thickness = block.thickness[i] * (1.0 + values[block.thickness_growth()]);
    shell_motion.dt = motion.dt;
    mask.place(shell_motion.x);
    mask.stop(shell_motion.v);
    mask.stop(shell_motion.w);
    mask.keep(values);
    ShellStep<n> step;
    advance_shell<Geometry>(block.properties, block.shell, shell_motion, values.first(block.layout.energy()),
                            step);
    apply_mask(mask, values, step);
    values.back() += step.stress_work;
    const auto n_used = std::min<std::size_t>(n_lanes, block.n_elements - i * n_lanes);
    scatter_add(step.force, nodes, n_used, forces);
    if constexpr (Geometry::has_rotations) scatter_add(step.moment, nodes, n_used, moments);
    add_lanes(step, i * n_lanes, n_used, sums);
  }
  return sums;
}

/// Rows are the axes of an element's frame.
template <class Geometry>
Eigen::Matrix3d shell_frame(const ElementVectors& coordinates) {
  NodeVectors<Geometry::n_nodes> x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < Geometry::n_nodes; ++a)
      x[i][a].setConstant(coordinates(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a)));
  }
  const Geometry geometry(x);
  Eigen::Matrix3d frame;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      frame(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = geometry.frame()[i][j](0);
  }
  return frame;
}

}  // namespace batches

///   n_points  of the layout comes from the block's layers, not from the row
template <class Geometry>
constexpr ElementFormulation shell_element(Shape shape, std::string_view formulation) {
  return {shape,
          formulation,
          Geometry::n_nodes,
          0,
          Geometry::n_modes + 1,
          &batches::shell_volumes<Geometry>,
          &batches::advance_shells<Geometry>,
          Geometry::has_rotations,
          &batches::shell_frame<Geometry>};
}

}  // namespace contactsim
