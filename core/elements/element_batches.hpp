// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elements/chunk_vectors.hpp"
#include "core/elements/element_death_mask.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/fetch_ahead.hpp"
#include "core/elements/solid_kernel.hpp"

/// Makes a row of the element table from an element type, which states
///   shape, formulation, n_nodes, n_points, n_own  as ElementFormulation, mass_shares if it has any
/// and has
///   volume(x)  of eight elements [length^3]
///   advance(properties, motion, state, step)      state: [layout.energy()]
namespace contactsim {

namespace batches {

/// The step of no element.
inline ChunkStep no_step() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, 0, infinity, 0.0, 0.0};
}

/// What the first lanes, those in use, have for the extremes. A volume that is no number is one.
inline void add_extremes(const Lanes& stable_step, const Lanes& volumes, std::size_t first_element,
                         std::size_t n_used, ChunkStep& sums) {
  const LaneMask is_used = first_lanes(n_used);
  if ((is_used && stable_step < sums.stable_step).any()) {
    for (std::size_t lane = 0; lane < n_used; ++lane) {
      const double stable = stable_step.data()[lane];
      if (!(stable < sums.stable_step)) continue;
      sums.stable_step = stable;
      sums.critical_element = first_element + lane;
    }
  }
  if ((is_used && !(volumes >= sums.min_volume)).any()) {
    for (std::size_t lane = 0; lane < n_used; ++lane) {
      const double volume = volumes.data()[lane];
      if (volume < sums.min_volume || std::isnan(volume)) sums.min_volume = volume;
    }
  }
}

/// Takes off what the dead and the dying do not give.
template <std::size_t n>
void apply_mask(ElementDeathMask& mask, std::span<Lanes> values, SolidStep<n>& step) {
  mask.apply(step.volume, values);
  mask.limit(step.stable_step);
  mask.scale(step.force);
  mask.scale(step.stress_work);
  mask.scale(step.hourglass_work);
  mask.scale(step.viscous_work);
}

/// What the lanes in use add.
template <std::size_t n>
void add_lanes(const SolidStep<n>& step, std::size_t first_element, std::size_t n_used, ChunkStep& sums) {
  add_extremes(step.stable_step, step.volume, first_element, n_used, sums);
  sums.hourglass_work += step.hourglass_work.sum_of_first(n_used);
  sums.viscous_work += step.viscous_work.sum_of_first(n_used);
}

template <class Element>
void volumes(const ModelBlock& block, const BatchChunk& chunk, const Eigen::Matrix3Xd& coordinates,
             std::span<Lanes> volumes) {
  constexpr std::size_t n = Element::n_nodes;
  const ChunkVectors<1, std::max<std::size_t>(8, n)> vectors(block.nodes_of(chunk), coordinates);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    NodeVectors<n> x;
    vectors.gather(block.nodes.data() + i * n * n_lanes, x);
    volumes[i] = Element::volume(x);
  }
}

template <class Element>
ChunkStep advance(const ModelBlock& block, const BatchChunk& chunk, const Motion& motion,
                  ModelBlockState& state) {
  constexpr std::size_t n = Element::n_nodes;
  const ChunkVectors<2, std::max<std::size_t>(8, n)> vectors(block.nodes_of(chunk), motion.coordinates,
                                                             motion.velocity);
  NodeVector* forces = state.forces.data() + chunk.first_node;
  std::fill_n(forces, chunk.n_nodes, NodeVector::Zero());
  ChunkStep sums = no_step();
  ElementDeathMask mask(block, state);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    if (!mask.begin(i)) continue;
    fetch_ahead(block, chunk, i, state, {&motion.coordinates, &motion.velocity});
    const ChunkNode* nodes = block.nodes.data() + i * n * n_lanes;
    SolidMotion<n> solid_motion;
    vectors.gather(nodes, solid_motion.x, solid_motion.v);
    solid_motion.mass = block.mass[i];
    solid_motion.dt = motion.dt;
    mask.place(solid_motion.x);
    mask.stop(solid_motion.v);
    const std::span<Lanes> values = state.batch(block.layout, i);
    mask.keep(values);
    SolidStep<n> step;
    Element::advance(block.properties, solid_motion, values.first(block.layout.energy()), step);
    apply_mask(mask, values, step);
    values.back() += step.stress_work;
    const auto n_used = std::min<std::size_t>(n_lanes, block.n_elements - i * n_lanes);
    scatter_add(step.force, nodes, n_used, forces);
    add_lanes(step, i * n_lanes, n_used, sums);
  }
  return sums;
}

}  // namespace batches

template <class Element>
constexpr ElementFormulation solid_element() {
  ElementFormulation row{
      Element::shape, Element::formulation,       Element::n_nodes,          Element::n_points,
      Element::n_own, &batches::volumes<Element>, &batches::advance<Element>};
  if constexpr (requires { Element::mass_shares; }) row.mass_shares = Element::mass_shares;
  return row;
}

}  // namespace contactsim
