// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "core/base/tensor_lanes.hpp"
#include "core/mesh/topology.hpp"

/// Volume gradients of elements from their faces: the volume is a third of the flux of the position, a sum
/// over the faces. A bilinear quadrilateral counts as the mean of its two cuts into triangles, which is
/// exact, so that the volumes of elements that share faces add up to that of the body.
namespace contactsim {

namespace face_gradient {

inline Lanes cross(const Lanes& y_a, const Lanes& z_a, const Lanes& y_b, const Lanes& z_b) {
  return y_a * z_b - z_a * y_b;
}

/// Adds twelve times the share of one side in one component, from the two other coordinates.
template <const auto& sides, std::size_t s, std::size_t n>
void add_side(const std::array<Lanes, n>& y, const std::array<Lanes, n>& z, std::array<Lanes, n>& gradient) {
  constexpr Side side = sides[s];
  constexpr std::size_t a = side.corners[0], b = side.corners[1], c = side.corners[2], d = side.corners[3];
  if constexpr (side.n_corners == 3) {
    gradient[a] += 2.0 * cross(y[b], z[b], y[c], z[c]);
    gradient[b] += 2.0 * cross(y[c], z[c], y[a], z[a]);
    gradient[c] += 2.0 * cross(y[a], z[a], y[b], z[b]);
  } else {
    const Lanes y_ac = y[c] - y[a], z_ac = z[c] - z[a], y_bd = y[d] - y[b], z_bd = z[d] - z[b];
    const Lanes bd = cross(y[b], z[b], y[d], z[d]), ac = cross(y[a], z[a], y[c], z[c]);
    gradient[a] += bd + cross(y[c], z[c], y_bd, z_bd);
    gradient[b] -= ac + cross(y[d], z[d], y_ac, z_ac);
    gradient[c] -= bd + cross(y[a], z[a], y_bd, z_bd);
    gradient[d] += ac + cross(y[b], z[b], y_ac, z_ac);
  }
}

/// One component of the gradient, from the two other coordinates.
template <const auto& sides, std::size_t n>
std::array<Lanes, n> component(std::array<Lanes, n> y, std::array<Lanes, n> z) {
  const Lanes y_0 = y[0], z_0 = z[0];
  std::array<Lanes, n> gradient;
  for (std::size_t a = 0; a < n; ++a) {
    y[a] = (y[a] - y_0) * (1.0 / 12.0);
    z[a] -= z_0;
    gradient[a].setZero();
  }
  [&]<std::size_t... s>(std::index_sequence<s...>) { (add_side<sides, s>(y, z, gradient), ...); }
  (std::make_index_sequence<sides.size()>());
  return gradient;
}

}  // namespace face_gradient

/// The derivatives of the volumes of eight elements by the coordinates of their nodes [length^2].
///   sides  the shape's, from core/mesh/side_tables.hpp
template <const auto& sides, std::size_t n>
NodeVectors<n> face_volume_gradient(const NodeVectors<n>& x) {
  return {face_gradient::component<sides>(x[1], x[2]), face_gradient::component<sides>(x[2], x[0]),
          face_gradient::component<sides>(x[0], x[1])};
}

}  // namespace contactsim
