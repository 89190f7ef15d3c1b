// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>

#include "core/dynamics/block_at_rest.hpp"

namespace contactsim {

/// Steps of single elements of a block at rest, and what makes them longer.
class ScaledBlock {
 public:
  ScaledBlock(const Mesh& mesh, ModelBlock& block) : block_(block), at_rest_(mesh, block) {}

  /// The least that the elements of a batch allow [time].
  double stable_step_of_batch(std::size_t batch) {
    const auto parent =
        std::prev(std::ranges::upper_bound(block_.chunks, batch, {}, &BatchChunk::first_batch));
    return at_rest_.stable_step({batch, 1, parent->first_node, parent->n_nodes});
  }

  /// The stable step that an element allows alone [time].
  double stable_step(std::size_t element) {
    const std::size_t batch = element / n_lanes;
    const auto lane = static_cast<Eigen::Index>(element % n_lanes);
    // The others of the batch are made so heavy that the least step is that of the element.
    constexpr double heavy = 1e12;
    Lanes factors = Lanes::Constant(heavy);
    factors(lane) = 1.0;
    const Lanes mass = block_.mass[batch];
    const std::optional<Lanes> inertia =
        block_.inertia.empty() ? std::nullopt : std::optional(block_.inertia[batch]);
    scale(batch, factors);
    const double step = stable_step_of_batch(batch);
    block_.mass[batch] = mass;
    if (inertia) block_.inertia[batch] = *inertia;
    return step;
  }

  /// Makes the elements of a batch heavier.
  void scale(std::size_t batch, const Lanes& factors) {
    block_.mass[batch] *= factors;
    if (!block_.inertia.empty()) block_.inertia[batch] *= factors;
  }

 private:
  ModelBlock& block_;
  BlockAtRest at_rest_;
};

}  // namespace contactsim
