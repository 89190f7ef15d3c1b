// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/statics/multigrid/aggregation.hpp"

namespace contactsim {

/// Motions that cost next to no energy, those of rigid bodies [n x 6], and on coarser levels their
/// coefficients.
using Modes = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// What every group does with its nodes before smoothing: orthonormal columns that hold the modes of the
/// group's nodes. A group of few nodes has columns of 0 for those that depend on others.
template <int N>
struct GroupColumns {
  std::vector<Eigen::Matrix<double, N, 6>> of_node;  ///< [n_nodes]
  Modes coarse_modes;                                ///< [6 n_groups x 6] the modes by the columns
};

/// Makes the columns of one group of its modes, by Gram and Schmidt twice over. Returns the modes by the
/// columns.
///   modes  [n x 6] in: modes; out: columns
Eigen::Matrix<double, 6, 6> orthonormalise(Modes& modes);

/// Nodes group by group, those of group i at first[i] to first[i + 1].
struct GroupNodes {
  std::vector<std::size_t> first;    ///< [n_groups + 1]
  std::vector<std::uint32_t> nodes;  ///< ascending in a group
};
GroupNodes list_nodes(const Aggregates& groups);

///   modes  [N n_nodes x 6]
template <int N>
GroupColumns<N> make_group_columns(const Aggregates& groups, const Modes& modes) {
  const GroupNodes list = list_nodes(groups);
  const auto rows_of = [](auto& of, std::size_t node) {
    return of.template middleRows<N>(N * static_cast<Eigen::Index>(node));
  };
  GroupColumns<N> columns;
  columns.of_node.resize(groups.of_node.size(), Eigen::Matrix<double, N, 6>::Zero());
  columns.coarse_modes.resize(6 * Eigen::Index{groups.n}, 6);
  parallel_for(groups.n, threads_for(10 * groups.of_node.size()), [&](std::uint32_t group) {
    const std::size_t begin = list.first[group], n = list.first[group + std::size_t{1}] - begin;
    Modes own(N * static_cast<Eigen::Index>(n), 6);
    for (std::size_t i = 0; i < n; ++i) rows_of(own, i) = rows_of(modes, list.nodes[begin + i]);
    columns.coarse_modes.template middleRows<6>(6 * Eigen::Index{group}) = orthonormalise(own);
    for (std::size_t i = 0; i < n; ++i) columns.of_node[list.nodes[begin + i]] = rows_of(own, i);
  });
  return columns;
}

}  // namespace contactsim
