// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace contactsim {

class StateArchive;

/// Forces that something holds though it is not there, evenly less and less until a time: what is out of
/// balance in a state that load steps take over.
class FadingForces {
 public:
  /// Holds all of them from a time on and nothing from another on.
  void begin(Eigen::VectorXd forces, double from, double until);
  /// Whether begin() has never been called.
  bool empty() const { return forces_.size() == 0; }
  /// How much of them is still held [1].
  double share(double time) const {
    return empty() ? 0.0 : std::clamp((until_ - time) / (until_ - from_), 0.0, 1.0);
  }
  /// Takes a share of them off others.
  void take_off(double share, Eigen::VectorXd& others) const {
    if (share > 0.0) others -= share * forces_;
  }
  /// Saves or restores them, where there are any.
  ///   size  of the forces
  void archive(Eigen::Index size, StateArchive& saved);

 private:
  Eigen::VectorXd forces_;  // empty: none
  double from_ = 0.0, until_ = 0.0;
};

}  // namespace contactsim
