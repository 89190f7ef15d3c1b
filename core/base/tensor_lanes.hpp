// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/lanes.hpp"

/// Vectors and tensors of eight elements.
namespace contactsim {

/// A vector at each of the n nodes of eight elements: [component][node].
template <std::size_t n>
using NodeVectors = std::array<std::array<Lanes, n>, 3>;

/// A tensor of each element, [i][j].
using TensorLanes = std::array<std::array<Lanes, 3>, 3>;

/// A symmetric tensor of each element: xx, yy, zz, xy, yz, zx.
struct SymmetricLanes {
  std::array<Lanes, 6> components;

  static SymmetricLanes zero() {
    SymmetricLanes tensor;
    for (Lanes& component : tensor.components) component.setZero();
    return tensor;
  }
  Lanes& operator[](std::size_t i) { return components[i]; }
  const Lanes& operator[](std::size_t i) const { return components[i]; }
};

/// Where component ij of a symmetric tensor stands.
inline constexpr std::size_t symmetric_place[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

inline Lanes trace(const SymmetricLanes& a) { return a[0] + a[1] + a[2]; }

/// The double contraction a : b, with the off-diagonal components twice.
inline Lanes contract(const SymmetricLanes& a, const SymmetricLanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// Sum of a_k b_k, over as many as a has.
template <std::size_t n, std::size_t m>
Lanes dot(const std::array<Lanes, n>& a, const std::array<Lanes, m>& b) {
  static_assert(n <= m);
  Lanes sum = a[0] * b[0];
  for (std::size_t k = 1; k < n; ++k) sum += a[k] * b[k];
  return sum;
}

/// A A^T of vectors at nodes, or of a tensor.
template <std::size_t n>
SymmetricLanes squares(const NodeVectors<n>& a) {
  return {
      {dot(a[0], a[0]), dot(a[1], a[1]), dot(a[2], a[2]), dot(a[0], a[1]), dot(a[1], a[2]), dot(a[2], a[0])}};
}

/// The tensor less a third of its trace on the diagonal.
inline SymmetricLanes deviator(SymmetricLanes a) {
  const Lanes mean = trace(a) * (1.0 / 3.0);
  for (std::size_t i = 0; i < 3; ++i) a[i] -= mean;
  return a;
}

/// F a F^T: a as a rotation turns it, or a deformation carries it along.
inline SymmetricLanes transformed(const SymmetricLanes& a, const TensorLanes& f) {
  TensorLanes fa;
  for (std::size_t i = 0; i < 3; ++i) {
    fa[i] = {f[i][0] * a[0] + f[i][1] * a[3] + f[i][2] * a[5],
             f[i][0] * a[3] + f[i][1] * a[1] + f[i][2] * a[4],
             f[i][0] * a[5] + f[i][1] * a[4] + f[i][2] * a[2]};
  }
  const auto component = [&](std::size_t i, std::size_t j) -> Lanes {
    return fa[i][0] * f[j][0] + fa[i][1] * f[j][1] + fa[i][2] * f[j][2];
  };
  return {
      {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)}};
}

/// At least the largest eigenvalue, which lies at most sqrt(2/3) times the deviator's norm above the mean;
/// at most the trace of a tensor without negative ones.
inline Lanes bound_of_eigenvalues(const SymmetricLanes& a) {
  const SymmetricLanes spread = deviator(a);
  return trace(a) * (1.0 / 3.0) + (2.0 / 3.0 * contract(spread, spread)).sqrt();
}

}  // namespace contactsim
