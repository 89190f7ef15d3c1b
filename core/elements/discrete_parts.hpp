// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <vector>

#include "core/base/lanes.hpp"
#include "core/functions/function.hpp"

namespace contactsim {

/// What springs, dampers and point masses have in place of a material.
struct DiscreteParts {
  std::optional<Function> force_of_strain;  ///< of springs; without one they are linear [force]
  std::vector<Lanes> length;                ///< [n_batches] of springs and dampers in the mesh [length]
  /// [n_batches] of springs, the steepest [force/length], or of dampers the resistance [force time/length]
  std::vector<Lanes> stiffness;
  std::vector<Lanes> stable_step;  ///< [n_batches] that their ends allow, see set_discrete_steps [time]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< of every point mass [mass length^2]
};

/// The axial force that trusses have before they are stretched: INITIAL LOAD, brought on in PERIOD.
struct Preload {
  double load = 0.0;    ///< [force]
  double period = 0.0;  ///< from time 0 on; 0: it is there at the start [time]

  /// Which part of it is there.
  double share(double time) const { return period > 0.0 ? std::clamp(time / period, 0.0, 1.0) : 1.0; }
};

}  // namespace contactsim
