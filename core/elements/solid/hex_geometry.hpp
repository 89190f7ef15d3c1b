// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/tensor_lanes.hpp"

namespace contactsim {

/// Mean quadrature of eight-node hexahedra, nodes in Exodus order; see uniform_gradient.hpp.
struct HexGeometry {
  static constexpr std::size_t n_nodes = 8, n_modes = 4;
  static constexpr double mode_norm = 2.8284271247461903;  ///< sqrt(8): the entries are 1 and -1

  /// Source: Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679-706, eq. 79.
  static NodeVectors<8> volume_gradient(const NodeVectors<8>& x);

  /// The hourglass modes are eta zeta, xi zeta, xi eta and xi eta zeta.
  static std::array<Lanes, 4> mode_sums(const std::array<Lanes, 8>& values);
  static void add_modes(const std::array<Lanes, 4>& amounts, std::array<Lanes, 8>& values);
};

}  // namespace contactsim
