// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "core/base/tensor_lanes.hpp"

namespace contactsim {

/// Values at the eight nodes of hexahedra, Exodus order, summed with the signs that xi, eta, zeta, eta zeta,
/// xi zeta, xi eta and xi eta zeta have there. The eighth sum, all of them, is not needed: a shift of all
/// nodes does nothing.
using HexSums = std::array<Lanes, 7>;

/// Mean quadrature of eight-node hexahedra in their volumetric and hourglass base vectors, which are
/// orthogonal; see base_vectors.hpp. Source: Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981)
/// 679-706, eq. 26.
struct HexGeometry {
  static constexpr std::size_t n_nodes = 8, n_base = 7, n_gradient = 6, n_modes = 4;
  static constexpr double base_norm = 8.0, mode_norm = 2.8284271247461903;

  // Sums and differences of pairs are shared: first along zeta (nodes 0..3 below 4..7), then within the two
  // quadrilaterals.
  static HexSums base_sums(const std::array<Lanes, 8>& v) {
    const Lanes s0 = v[0] + v[4], s1 = v[1] + v[5], s2 = v[2] + v[6], s3 = v[3] + v[7];
    const Lanes d0 = v[4] - v[0], d1 = v[5] - v[1], d2 = v[6] - v[2], d3 = v[7] - v[3];
    const Lanes s10 = s1 - s0, s23 = s2 - s3, d10 = d1 - d0, d23 = d2 - d3, d01 = d0 + d1, d32 = d3 + d2;
    return {s10 + s23, (s2 + s3) - (s0 + s1), d01 + d32, d32 - d01, d10 + d23, s23 - s10, d23 - d10};
  }
  static std::array<Lanes, 8> at_nodes(const HexSums& f) {
    const Lanes sum = f[0] + f[1], difference = f[0] - f[1];
    const Lanes even_0 = f[5] - sum, even_1 = difference - f[5], even_2 = sum + f[5],
                even_3 = difference + f[5];
    const Lanes plus = f[2] + f[6], minus = f[2] - f[6], odd_sum = f[3] + f[4], odd_difference = f[4] - f[3];
    const Lanes odd_0 = plus - odd_sum, odd_1 = minus + odd_difference, odd_2 = plus + odd_sum,
                odd_3 = minus - odd_difference;
    return {even_0 - odd_0, even_1 - odd_1, even_2 - odd_2, -even_3 - odd_3,
            even_0 + odd_0, even_1 + odd_1, even_2 + odd_2, odd_3 - even_3};
  }

  /// The volume is the integral of the determinant of the map from natural coordinates. With s_k the sums of
  /// the coordinates it is, after the odd powers have dropped out,
  ///   (det(s_0, s_1, s_2) + (det(s_0, s_5, s_4) + det(s_5, s_1, s_3) + det(s_4, s_3, s_2)) / 3) / 64:
  /// the sum with xi eta zeta is not in it.
  static NodeVectors<6> volume_gradient(const NodeVectors<7>& x) {
    return {component(x[1], x[2]), component(x[2], x[0]), component(x[0], x[1])};
  }
  static std::array<Lanes, 4> mode_sums(const HexSums& sums) { return {sums[3], sums[4], sums[5], sums[6]}; }
  static void add_modes(const std::array<Lanes, 4>& amounts, HexSums& forces) {
    for (std::size_t k = 0; k < 4; ++k) forces[3 + k] += amounts[k];
  }

 private:
  /// One component of the gradient, from the sums of the two other coordinates.
  static std::array<Lanes, 6> component(const HexSums& y, const HexSums& z) {
    const auto cross = [&](std::size_t a, std::size_t b) { return y[a] * z[b] - z[a] * y[b]; };
    constexpr double linear = 1.0 / 64.0, bilinear = 1.0 / 192.0;
    return {linear * cross(1, 2) + bilinear * cross(5, 4), linear * cross(2, 0) + bilinear * cross(3, 5),
            linear * cross(0, 1) + bilinear * cross(4, 3), bilinear * (cross(5, 1) + cross(2, 4)),
            bilinear * (cross(0, 5) + cross(3, 2)),        bilinear * (cross(4, 0) + cross(1, 3))};
  }
};

}  // namespace contactsim
