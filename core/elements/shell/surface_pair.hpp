// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell_frame.hpp"

namespace contactsim {

/// Components along the two axes of a frame that lie in a shell's surface.
using SurfacePair = std::array<Lanes, 2>;

inline Lanes dot(const SurfacePair& a, const SurfacePair& b) { return a[0] * b[0] + a[1] * b[1]; }

/// In the frame, angular velocities as velocities of the normal's tip: w x e_z.
inline SurfacePair tip(const VectorLanes& w) { return {w[1], -w[0]}; }

/// The moments that go with forces on the normal's tip: e_z x f, and one about the normal.
inline VectorLanes moment_of(const SurfacePair& tip_force, const Lanes& about_normal) {
  return {-tip_force[1], tip_force[0], about_normal};
}

}  // namespace contactsim
