// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/lanes.hpp"

namespace contactsim {

/// The vectors at the nodes of eight elements.
///   nodes   [n x n_lanes]
///   values  [3 x n_nodes]
template <std::size_t n>
NodeVectors<n> gather(std::span<const std::uint32_t> nodes, const Eigen::Matrix3Xd& values) {
  NodeVectors<n> gathered;
  const double* data = values.data();
  for (std::size_t node = 0; node < n; ++node) {
    for (std::size_t lane = 0; lane < n_lanes; ++lane) {
      const double* vector = data + std::size_t{3} * nodes[node * n_lanes + lane];
      for (std::size_t i = 0; i < 3; ++i) gathered[i][node](static_cast<Eigen::Index>(lane)) = vector[i];
    }
  }
  return gathered;
}

}  // namespace contactsim
