// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/base/node_ranges.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

class RankShare;

/// Throws SolveError naming the first element without a positive volume.
///   chunks  of the block, one behind the other, that have one
[[noreturn]] void stop_at_inverted(const Mesh& mesh, const ModelBlock& block,
                                   std::span<const BatchChunk> chunks, const Motion& motion);

/// The forces of the elements' stresses, of those that are advanced once in a step.
class InternalForce final : public ForceTerm {
 public:
  /// All must outlive the term; it changes the elements' part of the state only.
  ///   share  of a rank, whose chunks alone it advances; null: it advances all
  InternalForce(const Model& model, State& state, RankShare* share = nullptr);

  /// Throws SolveError naming the element when one has no positive volume.
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override;
  void set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) override;

 private:
  void find_first_sums();
  void advance_chunks(const Motion& motion);
  std::span<const ChunkStep> steps_of(std::size_t block) const;

  const Model& model_;
  State& state_;
  RankShare* const share_;
  NodeRanges nodes_;                      ///< whose forces are summed
  std::vector<std::uint8_t> sets_;        ///< [n_blocks] whether no block before has nodes of it
  NodeRanges other_nodes_;                ///< those of nodes_ that no such block has
  std::vector<std::size_t> first_chunk_;  ///< [n_blocks + 1] of each block in chunks_
  std::vector<ChunkStep> chunks_;         ///< of all blocks, scratch
  /// Stable step at rest were the rigid elements elastic, or the dead ones alive: for when there are no
  /// others [time]
  double idle_step_;
};

}  // namespace contactsim
