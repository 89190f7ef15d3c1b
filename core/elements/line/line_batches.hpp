// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_batches.hpp"
#include "core/elements/shell_frame.hpp"

/// Makes a row of the element table from a kind of lines of two nodes, which states n_own and has_rotations
/// and has
///   advance(block, batch, motion, state, step)   state: [layout.energy()]
namespace contactsim {

/// How eight lines move in a step.
struct LineMotion {
  NodeVectors<2> x;     ///< coordinates at the end of the step [length]
  NodeVectors<2> v;     ///< velocities at its middle [length/time]
  NodeVectors<2> w;     ///< angular velocities at its middle, of lines with rotations [1/time]
  Lanes mass, inertia;  ///< of the elements [mass], [mass length^2]
  double dt = 0.0;      ///< size of the step; 0: forces at the start are asked for [time]
  double time = 0.0;    ///< at its end [time]

  VectorLanes velocity_difference() const {
    return {v[0][1] - v[0][0], v[1][1] - v[1][0], v[2][1] - v[2][0]};
  }
};

/// What a step gives. The second node feels -pull, the first pull; of moments the second -bend - mean_moment
/// / 2, the first bend - mean_moment / 2.
struct LineStep {
  VectorLanes pull;               ///< [force]
  VectorLanes bend, mean_moment;  ///< of lines with rotations [force length]
  Lanes volume, stable_step, stress_work;
};

/// Where lines lie some time before the end of a step.
struct LineGeometry {
  VectorLanes axis;  ///< unit, from the first node to the second
  Lanes length;

  explicit LineGeometry(const NodeVectors<2>& x) {
    VectorLanes way;
    for (std::size_t i = 0; i < 3; ++i) way[i] = x[i][1] - x[i][0];
    set(way);
  }
  ///   before  [time]
  LineGeometry(const NodeVectors<2>& x, const NodeVectors<2>& v, double before) {
    VectorLanes way;
    for (std::size_t i = 0; i < 3; ++i) way[i] = x[i][1] - x[i][0] - before * (v[i][1] - v[i][0]);
    set(way);
  }

 private:
  void set(const VectorLanes& way) {
    length = dot(way, way).sqrt();
    axis = scaled(way, 1.0 / length);
  }
};

namespace batches {

inline void line_volumes(const ModelBlock& block, const BatchChunk& chunk,
                         const Eigen::Matrix3Xd& coordinates, std::span<Lanes> volumes) {
  const ChunkVectors vectors(block.nodes_of(chunk), coordinates);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    NodeVectors<2> x;
    vectors.gather(block.nodes.data() + i * 2 * n_lanes, x);
    volumes[i] = LineGeometry(x).length * block.section[i];
  }
}

/// Takes off what the dead and the dying do not give.
inline void apply_mask(bool has_rotations, ElementDeathMask& mask, std::span<Lanes> values, LineStep& step) {
  mask.apply(step.volume, values);
  mask.limit(step.stable_step);
  mask.scale(step.stress_work);
  for (std::size_t k = 0; k < 3; ++k) {
    mask.scale(step.pull[k]);
    if (!has_rotations) continue;
    mask.scale(step.bend[k]);
    mask.scale(step.mean_moment[k]);
  }
}

template <class Line>
ChunkStep advance_lines(const ModelBlock& block, const BatchChunk& chunk, const Motion& motion,
                        ModelBlockState& state) {
  const ChunkVectors vectors(block.nodes_of(chunk), motion.coordinates, motion.velocity,
                             Line::has_rotations ? *motion.angular_velocity : motion.velocity);
  NodeVector* forces = state.forces.data() + chunk.first_node;
  std::fill_n(forces, chunk.n_nodes, NodeVector::Zero());
  if (Line::has_rotations)
    std::fill_n(state.moments.data() + chunk.first_node, chunk.n_nodes, NodeVector::Zero());
  ChunkStep sums = no_step();
  ElementDeathMask mask(block, state);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    if (!mask.begin(i)) continue;
    const ChunkNode* nodes = block.nodes.data() + i * 2 * n_lanes;
    LineMotion line_motion;
    vectors.gather(nodes, line_motion.x, line_motion.v, line_motion.w);
    line_motion.mass = block.mass[i];
    line_motion.inertia = Line::has_rotations ? block.inertia[i] : Lanes::Zero();
    line_motion.dt = motion.dt;
    line_motion.time = motion.time;
    mask.place(line_motion.x);
    mask.stop(line_motion.v);
    mask.stop(line_motion.w);
    const std::span<Lanes> values = state.batch(block.layout, i);
    mask.keep(values);
    LineStep step;
    Line::advance(block, i, line_motion, values.first(block.layout.energy()), step);
    apply_mask(Line::has_rotations, mask, values, step);
    values.back() += step.stress_work;
    const auto n_used = std::min<std::size_t>(n_lanes, block.n_elements - i * n_lanes);
    NodeVectors<2> at_nodes;
    for (std::size_t k = 0; k < 3; ++k) at_nodes[k] = {step.pull[k], -step.pull[k]};
    scatter_add(at_nodes, nodes, n_used, forces);
    if constexpr (Line::has_rotations) {
      for (std::size_t k = 0; k < 3; ++k)
        at_nodes[k] = {step.bend[k] - 0.5 * step.mean_moment[k], -step.bend[k] - 0.5 * step.mean_moment[k]};
      scatter_add(at_nodes, nodes, n_used, state.moments.data() + chunk.first_node);
    }
    add_extremes(step.stable_step, step.volume, i * n_lanes, n_used, sums);
  }
  return sums;
}

}  // namespace batches

///   n_points  of the layout comes from the block
template <class Line>
constexpr ElementFormulation line_element(Shape shape, std::string_view formulation) {
  return {shape,
          formulation,
          2,
          1,
          Line::n_own,
          &batches::line_volumes,
          &batches::advance_lines<Line>,
          Line::has_rotations};
}

}  // namespace contactsim
