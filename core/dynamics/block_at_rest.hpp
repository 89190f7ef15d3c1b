// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_table.hpp"

namespace contactsim {

/// A block as it lies in the mesh, without motion or stress.
class BlockAtRest {
 public:
  /// Both must outlive it; masses of the block may change in between.
  BlockAtRest(const Mesh& mesh, const ModelBlock& block)
      : block_(block),
        state_(make_state(block)),
        still_(Eigen::Matrix3Xd::Zero(3, mesh.n_nodes())),
        motion_{0.0, 0.0, mesh.coordinates(), still_} {
    motion_.angular_velocity = &still_;
  }
  BlockAtRest(const BlockAtRest&) = delete;
  BlockAtRest& operator=(const BlockAtRest&) = delete;

  /// The smallest that the elements of the chunk allow [time].
  double stable_step(const BatchChunk& chunk) {
    return block_.element->advance(block_, chunk, motion_, state_).stable_step;
  }

 private:
  const ModelBlock& block_;
  ModelBlockState state_;
  Eigen::Matrix3Xd still_;
  Motion motion_;
};

}  // namespace contactsim
