// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/shell_kernel.hpp"

/// What tension does to the warp of four-node membranes, which one point does not see.
namespace contactsim::shells {

/// The warp of a surface: the nodes' heights over the plane, summed with the hourglass mode.
struct SurfaceWarp {
  Lanes height;                 ///< [length]
  std::array<Lanes, 4> mode;    ///< without linear motions; at right angles to the surface [1]
  std::array<Lanes, 3> slopes;  ///< of natural coordinates, squared: xx, yy, xy [1/length^2]
};

/// Stiffness of the warp, by the tension integrated over the surface; compression has none.
///   tension  stress xx, yy, xy [force/length^2]
///   volume   [length^3]
inline Lanes warp_stiffness(const SurfaceWarp& warp, const std::array<Lanes, 3>& tension,
                            const Lanes& volume) {
  const Lanes along =
      tension[0] * warp.slopes[0] + tension[1] * warp.slopes[1] + 2.0 * tension[2] * warp.slopes[2];
  return volume / 48.0 * along.max(0.0);
}

/// What tension does in a step.
struct WarpStep {
  Lanes work;               ///< done on it [energy]
  Lanes frequency_squared;  ///< to be added to the bound [1/time^2]
};

/// Work and frequencies of a warp in the middle of a step.
template <class Geometry>
WarpStep warp_step(const Geometry& geometry, const ShellMotion<4>& motion,
                   const std::array<Lanes, 3>& tension) {
  const SurfaceWarp warp = geometry.warp();
  const Lanes stiffness = warp_stiffness(warp, tension, geometry.area() * motion.thickness);
  Lanes rate = Lanes::Zero();
  for (std::size_t i = 0; i < 3; ++i) rate += geometry.frame()[2][i] * dot(warp.mode, motion.v[i]);
  return {motion.dt * stiffness * warp.height * rate,
          4.0 * stiffness * dot(warp.mode, warp.mode) / motion.mass};
}

/// Adds what flattens the surface at the end of a step. It neither moves nor turns it as a whole.
template <class Geometry>
void add_warp_forces(const Geometry& geometry, const std::array<Lanes, 3>& tension, const Lanes& volume,
                     NodeVectors<4>& force) {
  const SurfaceWarp warp = geometry.warp();
  const Lanes amount = warp_stiffness(warp, tension, volume) * warp.height;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < 4; ++a) force[i][a] -= amount * geometry.frame()[2][i] * warp.mode[a];
  }
}

}  // namespace contactsim::shells
