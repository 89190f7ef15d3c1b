// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/tensor_lanes.hpp"

/// Vectors of eight elements.
namespace contactsim {

using VectorLanes = std::array<Lanes, 3>;

inline VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Lanes dot(const VectorLanes& a, const VectorLanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline VectorLanes scaled(const VectorLanes& a, const Lanes& factor) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

inline VectorLanes unit(const VectorLanes& a) { return scaled(a, 1.0 / dot(a, a).sqrt()); }

/// Components along the rows of a frame.
inline VectorLanes to_local(const TensorLanes& frame, const VectorLanes& a) {
  return {dot(frame[0], a), dot(frame[1], a), dot(frame[2], a)};
}

/// The vector whose components along the rows of a frame these are.
inline VectorLanes to_global(const TensorLanes& frame, const VectorLanes& a) {
  VectorLanes sum;
  for (std::size_t i = 0; i < 3; ++i) sum[i] = frame[0][i] * a[0] + frame[1][i] * a[1] + frame[2][i] * a[2];
  return sum;
}

}  // namespace contactsim
