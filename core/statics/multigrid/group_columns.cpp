// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/group_columns.hpp"

namespace contactsim {

Eigen::Matrix<double, 6, 6> orthonormalise(Modes& modes) {
  constexpr double nothing = 1e-8;  // of a mode that depends on others
  Eigen::Matrix<double, 6, 6> coefficients = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double whole = modes.col(i).norm();
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index j = 0; j < i; ++j) {
        const double share = modes.col(j).dot(modes.col(i));
        modes.col(i) -= share * modes.col(j);
        coefficients(j, i) += share;
      }
    }
    const double left = modes.col(i).norm();
    if (left > nothing * whole) {
      modes.col(i) /= left;
      coefficients(i, i) = left;
    } else {
      modes.col(i).setZero();
    }
  }
  return coefficients;
}

GroupNodes list_nodes(const Aggregates& groups) {
  GroupNodes list;
  list.first.assign(groups.n + std::size_t{1}, 0);
  for (const OptionalIndex<std::uint32_t> group : groups.of_node) {
    if (group) ++list.first[*group + std::size_t{1}];
  }
  for (std::size_t i = 1; i < list.first.size(); ++i) list.first[i] += list.first[i - 1];
  list.nodes.resize(list.first.back());
  std::vector<std::size_t> next(list.first.begin(), list.first.end() - 1);
  for (std::uint32_t node = 0; node < groups.of_node.size(); ++node) {
    if (groups.of_node[node]) list.nodes[next[*groups.of_node[node]]++] = node;
  }
  return list;
}

}  // namespace contactsim
