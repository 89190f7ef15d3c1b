// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/indices.hpp"

namespace contactsim {

struct ConditionScope;
struct Model;

/// What of a model moves in parts of each step. BatchChunk::is_subcycled says which elements those are.
struct Subcycles {
  std::vector<NodeIndex> nodes;  ///< of their elements, ascending; empty without subcycling
  std::size_t n_elements = 0;    ///< that are subcycled
  std::size_t n_others = 0;      ///< elements with a stress that are not
  std::size_t n_parts = 1;       ///< of a step, as sizes in the mesh say

  bool empty() const { return nodes.empty(); }
  /// Elements that a run without subcycling advances for each that this one does [1].
  double saving() const;
};

/// Elements that are small, and the others as far as resonance wants them to be subcycled too.
///
/// Forces that act once in a step of size D can feed vibrations of the subcycled part whose half period is D:
/// those of frequencies w >= pi / D. Elements that are advanced once in a step cannot carry them, since
/// w <= 2 / (stable step) <= 1.8 / D; such vibrations die out within some layers of large elements. Three
/// layers around each small one are subcycled: of 2,235 random chains of elements, with size ratios from 1 to
/// 20 and no damping, all are stable then by the eigenvalues of a step; with two layers 4 are not, and grow
/// by up to 1e-4 in a step, with one 82, by up to 1e-2, with none by up to 0.4.
/// Source: for the resonance, Bishop, Skeel and Schlick, J. Comput. Phys. 126 (1997) 287-306.
class SubcycledSet {
 public:
  static constexpr int n_layers = 3;

  /// What an element may allow less than the large step without being small, of it: round-off [1].
  static constexpr double round_off = 1e-6;

  /// The model must outlive it.
  ///   steps  [n_elements of the mesh] each element's stable step; infinite where it has no stress [time]
  SubcycledSet(const Model& model, std::span<const double> steps, double large_step);

  /// [n_blocks of the model][n_batches] whole batches are subcycled or not.
  const std::vector<std::vector<std::uint8_t>>& batches() const { return batches_; }
  const Subcycles& sums() const { return sums_; }

 private:
  void add_layer(std::vector<std::uint8_t>& is_near) const;
  void sum(std::span<const double> steps);

  const Model& model_;
  std::vector<std::vector<std::uint8_t>> batches_;
  Subcycles sums_;
};

/// Finds what the region's SUBCYCLE BLOCKS wants subcycled, from sizes in the mesh, and makes the chunks of
/// the model such that none has elements of both kinds. Nothing without the line.
/// Named blocks: the least stable step of all other blocks is the large step, and what of the named blocks
/// allows less is small. ALL: the large step is chosen such that the fewest elements are advanced.
/// Errors: every block is named; rigid bodies, springs, dampers or cohesive elements at subcycled nodes.
/// Warnings: nothing is small, or little is won.
void set_subcycles(const ConditionScope& scope, Model& model);

}  // namespace contactsim
