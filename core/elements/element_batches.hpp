// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "core/elements/element_table.hpp"
#include "core/elements/gather.hpp"

/// Makes a row of the element table from an element type, which states
///   shape, formulation, n_nodes, n_points, n_own  as SolidElement
/// and has
///   volume(x)  of eight elements [length^3]
///   advance(properties, motion, state, step)      state: [layout.energy()]
namespace contactsim {

namespace batches {

/// What the lanes in use add.
template <std::size_t n>
void add_lanes(const SolidStep<n>& step, std::size_t first_element, Eigen::Index n_used, BatchesStep& sums) {
  Eigen::Index lane = 0;
  const double stable = step.stable_step.head(n_used).minCoeff(&lane);
  if (stable < sums.stable_step) {
    sums.stable_step = stable;
    sums.critical_element = first_element + static_cast<std::size_t>(lane);
  }
  const double volume = step.volume.head(n_used).minCoeff();
  if (!(volume >= sums.least_volume)) sums.least_volume = volume;
  sums.stress_work += step.stress_work.head(n_used).sum();
  sums.hourglass_work += step.hourglass_work.head(n_used).sum();
  sums.viscous_work += step.viscous_work.head(n_used).sum();
}

template <class Element>
Lanes volume(std::span<const std::uint32_t> nodes, const Eigen::Matrix3Xd& coordinates) {
  return Element::volume(gather<Element::n_nodes>(nodes, coordinates));
}

template <class Element>
BatchesStep advance(const SolidBlock& block, const Motion& motion, std::size_t begin, std::size_t end,
                    SolidBlockState& state) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::size_t n = Element::n_nodes;
  BatchesStep sums{infinity, 0, infinity, 0.0, 0.0, 0.0};
  for (std::size_t i = begin; i < end; ++i) {
    const auto nodes = block.batch_nodes(i);
    const SolidMotion<n> solid_motion{gather<n>(nodes, motion.coordinates), gather<n>(nodes, motion.velocity),
                                      block.mass[i], motion.dt};
    const std::span<Lanes> values = state.batch(block.layout, i);
    SolidStep<n> step;
    Element::advance(block.properties, solid_motion, values.first(block.layout.energy()), step);
    values.back() += step.stress_work;
    Lanes* force = state.forces.data() + i * 3 * n;
    for (std::size_t node = 0; node < n; ++node) {
      for (std::size_t component = 0; component < 3; ++component) *force++ = step.force[component][node];
    }
    const std::size_t first = i * n_lanes;
    add_lanes(step, first, static_cast<Eigen::Index>(std::min<std::size_t>(n_lanes, block.n_elements - first)),
              sums);
  }
  return sums;
}

}  // namespace batches

template <class Element>
constexpr SolidElement solid_element() {
  return {Element::shape,   Element::formulation, Element::n_nodes,         Element::n_points,
          Element::n_own, &batches::volume<Element>, &batches::advance<Element>};
}

}  // namespace contactsim
