// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

/// The forces of the elements' stresses.
class InternalForce final : public ForceTerm {
 public:
  /// Both must outlive the term; it changes the elements' part of the state only.
  InternalForce(const Model& model, State& state);

  /// Throws SolveError naming the element when one has no positive volume.
  ForceReport set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) override;
  void set_moments(const Motion& motion, Eigen::Matrix3Xd& moments) override;

 private:
  void advance_chunks(std::size_t index, const Motion& motion);
  [[noreturn]] void stop_at_inverted(const ModelBlock& block, const Motion& motion) const;

  const Model& model_;
  State& state_;
  std::vector<ChunkStep> chunks_;  ///< of the largest block, scratch
  /// Stable step at rest were the rigid elements elastic, or the dead ones alive: for when there are no
  /// others [time]
  double idle_step_;
};

}  // namespace contactsim
