// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstring>

#include "core/elements/gather.hpp"

namespace contactsim {

/// The components of the vectors of eight nodes that follow each other.
inline constexpr Eigen::Index nodes_per_group = 8, group_size = 3 * nodes_per_group;
using NodeGroup = Eigen::Array<double, group_size, 1>;

/// What eight nodes have each, once for every component of their vectors.
///   of_nodes  [nodes_per_group]
inline NodeGroup repeat_thrice(const double* of_nodes) {
  Eight each;
  std::memcpy(&each, of_nodes, sizeof each);
  const Eight thirds[3] = {__builtin_shufflevector(each, each, 0, 0, 0, 1, 1, 1, 2, 2),
                           __builtin_shufflevector(each, each, 2, 3, 3, 3, 4, 4, 4, 5),
                           __builtin_shufflevector(each, each, 5, 5, 6, 6, 6, 7, 7, 7)};
  NodeGroup group;
  std::memcpy(group.data(), thirds, sizeof thirds);
  return group;
}

}  // namespace contactsim
