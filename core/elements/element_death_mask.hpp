// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/elements/model_block.hpp"

namespace contactsim {

/// Element death as the kernels see it, batch by batch of a chunk. The dead of a batch are moved along with a
/// living element of it at rest, so that they make no numbers that are none, and what they give counts
/// nowhere. Without death every call does nothing.
class ElementDeathMask {
 public:
  ElementDeathMask(const ModelBlock& block, ModelBlockState& state)
      : block_(block), life_(state.life), is_on_(!state.life.empty()) {}

  /// Goes on to a batch. False when all of it is dead.
  bool begin(std::size_t batch) {
    if (!is_on_) return true;
    now_ = &life_[batch];
    lives_ = *now_ > 0.0;
    if (!lives_.any()) return false;
    is_mixed_ = !lives_.all();
    living_ = 0;
    while (!lives_(living_)) ++living_;
    may_invert_ = LaneMask(false);
    if (!block_.dies_inverted.empty()) may_invert_ = LaneMask::of_bits(block_.dies_inverted[batch]) && lives_;
    return true;
  }

  /// The dead stand where a living element stands.
  template <std::size_t n>
  void place(NodeVectors<n>& x) const {
    if (is_mixed_) visit(x, [this](Lanes& values) { values = lives_.select(values, values(living_)); });
  }
  /// The dead do not move.
  template <std::size_t n>
  void stop(NodeVectors<n>& v) const {
    if (is_mixed_) visit(v, [this](Lanes& values) { values = lives_.select(values, 0.0); });
  }
  /// To be called before the batch remembers anything new: the dead keep what they had when they died.
  void keep(std::span<const Lanes> values) {
    if (is_mixed_ || may_invert_.any()) kept_.assign(values.begin(), values.end());
  }

  /// To be called first of all after a step: kills what has turned inside out and may die of it.
  ///   volume  of the elements; infinite of dead ones then [length^3]
  ///   values  as in keep()
  void apply(Lanes& volume, std::span<Lanes> values) {
    if (!is_on_) return;
    const LaneMask inverted = may_invert_ && !(volume > 0.0);
    if (inverted.any()) {
      *now_ = inverted.select(0.0, *now_);
      lives_ = lives_ && !inverted;
      is_mixed_ = true;
    }
    limit(volume);
    if (!is_mixed_) return;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = lives_.select(values[i], kept_[i]);
  }
  /// The dead set no limit.
  void limit(Lanes& values) const {
    if (is_mixed_) values = lives_.select(values, std::numeric_limits<double>::infinity());
  }
  /// What a batch gives, times what is left of its elements.
  void scale(Lanes& values) const {
    if (is_on_) values = lives_.select(*now_ * values, 0.0);
  }
  template <std::size_t n>
  void scale(NodeVectors<n>& vectors) const {
    if (is_on_) visit(vectors, [this](Lanes& values) { scale(values); });
  }

 private:
  template <std::size_t n, class Visit>
  static void visit(NodeVectors<n>& vectors, const Visit& act) {
    for (auto& component : vectors) {
      for (Lanes& values : component) act(values);
    }
  }

  const ModelBlock& block_;
  std::vector<Lanes>& life_;
  bool is_on_, is_mixed_ = false;
  Lanes* now_ = nullptr;     // of the batch
  Eigen::Index living_ = 0;  // a lane that lives
  LaneMask lives_{true}, may_invert_{false};
  std::vector<Lanes> kept_;
};

}  // namespace contactsim
