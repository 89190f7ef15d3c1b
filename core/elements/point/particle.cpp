// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"

namespace contactsim {

namespace {

/// Spheres about one node: mass and size, no stress.
void sphere_volumes(const ModelBlock& block, const BatchChunk& chunk, const Eigen::Matrix3Xd&,
                    std::span<Lanes> volumes) {
  constexpr double unit_sphere = 4.18879020478639098;  // 4/3 pi
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    const Lanes& radius = block.section[i];
    volumes[i] = unit_sphere * radius * radius * radius;
  }
}

ChunkStep advance_particle(const ModelBlock&, const BatchChunk&, const Motion&, ModelBlockState&) {
  return batches::no_step();
}

}  // namespace

const ElementFormulation sphere_particle{Shape::sphere,   "particle",       1, 0, 0,
                                         &sphere_volumes, &advance_particle};

}  // namespace contactsim
