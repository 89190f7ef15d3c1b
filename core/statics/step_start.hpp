// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/dynamics/state.hpp"

namespace contactsim {

class RankShare;

/// What trials of a load step change of a state, as it is where the step begins. Rigid bodies are left out.
class StepStart {
 public:
  ///   share  of a rank, whose own elements alone restore_elements() brings back; must outlive this; null:
  ///   all
  explicit StepStart(const RankShare* share = nullptr) : share_(share) {}
  void remember(const State& state);
  /// Brings back what elements remember. Precondition: remember() was called, as for all that follows.
  void restore_elements(State& state) const;
  /// Brings back all.
  void restore(State& state) const;

  double time() const { return time_; }                                 ///< [time]
  const Eigen::Matrix3Xd& coordinates() const { return coordinates_; }  ///< [3 x n_nodes] [length]
  const NodalRotations& rotations() const { return rotations_; }
  const NodalForces& forces() const { return forces_; }

 private:
  const RankShare* share_;
  double time_ = 0.0;
  Eigen::Matrix3Xd coordinates_, velocity_;
  NodalRotations rotations_;
  NodalForces forces_;
  std::vector<std::vector<Lanes>> element_values_;  // of blocks
  std::vector<double> hourglass_work_;              // of blocks [energy]
};

}  // namespace contactsim
