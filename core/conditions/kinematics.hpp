// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/mesh/indices.hpp"

namespace contactsim {

/// A moment between two steps, as kinematic conditions see it.
struct BetweenSteps {
  double time;                          ///< now [time]
  double dt_before;                     ///< of the step that ends now; 0 at the start [time]
  double dt_after;                      ///< of the step that begins now, > 0 [time]
  const Eigen::Matrix3Xd& coordinates;  ///< [3 x n_nodes] now [length]
  const Eigen::Matrix3Xd&
      velocity;  ///< [3 x n_nodes] at the middle of the step before; at the start, now [length/time]
};

/// The nodes that conditions hold or drive. Conditions act through the acceleration alone: it is set such
/// that the coming half step,
///   v(middle of the step after) = v(middle of the step before) + (dt_before + dt_after) / 2 * acceleration,
/// has the velocity that the condition wants.
class Kinematics {
 public:
  /// The nodes that any condition may act on, ascending, each once.
  std::span<const NodeIndex> nodes() const { return nodes_; }

  /// Overwrites the accelerations of what is held or driven now.
  ///   acceleration  [3 x n_nodes] of free motion [length/time^2]
  void constrain(const BetweenSteps& now, Eigen::Matrix3Xd& acceleration) const;

 private:
  std::vector<NodeIndex> nodes_;
};

}  // namespace contactsim
