// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/base/fours.hpp"

namespace contactsim {

/// The components of the vectors of eight nodes that follow each other.
inline constexpr Eigen::Index nodes_per_group = 8, group_size = 3 * nodes_per_group;
using NodeGroup = Eigen::Array<double, group_size, 1>;

/// What eight nodes have each, once for every component of their vectors.
///   of_nodes  [nodes_per_group]
inline NodeGroup repeat_thrice(const double* of_nodes) {
  NodeGroup group;
  for (Eigen::Index half = 0; half < 2; ++half, of_nodes += 4) {
    const Four each = load_four(of_nodes);
    double* const thrice = group.data() + half * group_size / 2;
    store_four(thrice, __builtin_shufflevector(each, each, 0, 0, 0, 1));
    store_four(thrice + 4, __builtin_shufflevector(each, each, 1, 1, 2, 2));
    store_four(thrice + 8, __builtin_shufflevector(each, each, 2, 3, 3, 3));
  }
  return group;
}

}  // namespace contactsim
