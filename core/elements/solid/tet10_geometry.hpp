// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/tensor_lanes.hpp"

/// Ten-node tetrahedra as twelve linear ones: four at the corners, and eight around a point in the middle
/// that is the mean of the midside nodes.
namespace contactsim::tet10 {

inline constexpr std::size_t n_nodes = 10, n_points = 4;

/// Shares of the nodes in the mass: the volumes of the twelve, a quarter to each of their nodes, when all
/// edges are straight and halved; what the middle gets goes to the midside nodes.
inline constexpr std::array<double, n_nodes> mass_shares{1.0 / 32.0, 1.0 / 32.0, 1.0 / 32.0, 1.0 / 32.0,
                                                         7.0 / 48.0, 7.0 / 48.0, 7.0 / 48.0, 7.0 / 48.0,
                                                         7.0 / 48.0, 7.0 / 48.0};

/// The twelve tetrahedra, projected on the four points. A linear function psi_i that is 1 at point i and 0 at
/// the others belongs to each; c_is is its mean in tetrahedron s, V_s the volume of that and g_sa the
/// derivative of V_s by the coordinates of node a, which is V_s times the gradient of its shape function.
struct Projection {
  std::array<Lanes, n_points> volume;                   ///< sum of c_is V_s [length^3]
  std::array<NodeVectors<n_nodes>, n_points> gradient;  ///< sum of c_is g_sa [length^2]
  Lanes whole_volume;                                   ///< of the element [length^3]
  Lanes min_volume;  ///< the least of all V_s, and of the volumes of points [length^3]

  explicit Projection(const NodeVectors<n_nodes>& x);

  /// The volume, or one that is not positive if there is any.
  Lanes volume_or_worst() const { return (min_volume > 0.0).select(whole_volume, min_volume); }
};

/// At least the largest eigenvalue of sum_i L_i : L_i V_i over sum_a m_a |v_a|^2, for any velocities v and
/// the velocity gradients L_i at the points.
///   mass  of the elements [mass]; result [1/mass x length]
Lanes bound_of_gradients(const Projection& projection, const Lanes& mass);

/// Volume of eight elements [length^3].
Lanes volume(const NodeVectors<n_nodes>& x);

}  // namespace contactsim::tet10
