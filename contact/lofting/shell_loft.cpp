// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/shell_loft.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// Shells that meet at a sharper angle keep their own normals: a mean normal would loft them inside out.
constexpr double smooth_cosine = 0.5;

/// A node with more shells is the hub of a fan. Each of them would be compared with all others.
constexpr std::ptrdiff_t max_smooth_shells = 256;

}  // namespace

ShellNeighbours::ShellNeighbours(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates,
                                 std::span<const ElementIndex> shells)
    : mesh_(mesh), shells_(shells) {
  for (std::uint32_t shell = 0; shell < shells.size(); ++shell) {
    const auto nodes = corners(shell);
    const auto x = [&](std::size_t corner) -> Eigen::Vector3d {
      return coordinates.col(nodes[corner].value);
    };
    area_vectors_.push_back(area_vector(x(0), x(1), x(2), x(nodes.size() - 1)));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto [low, high] = std::minmax(nodes[i], nodes[(i + 1) % nodes.size()]);
      shells_of_node_.emplace_back(nodes[i], shell);
      edges_.push_back({low, high, shell});
    }
  }
  std::sort(shells_of_node_.begin(), shells_of_node_.end());
  std::sort(edges_.begin(), edges_.end());
}

std::span<const NodeIndex> ShellNeighbours::corners(std::uint32_t shell) const {
  const ElementIndex element = shells_[shell];
  const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(element)].shape);
  return mesh_.element_nodes(element).first(shape.n_corners);
}

std::vector<TurnedShell> ShellNeighbours::around(std::uint32_t shell, int corner) const {
  const NodeIndex node = corners(shell)[static_cast<std::size_t>(corner)];
  const Eigen::Vector3d own = area_vectors_[shell].normalized();
  const auto first = std::lower_bound(shells_of_node_.begin(), shells_of_node_.end(), std::pair(node, 0u));
  const auto last = std::upper_bound(first, shells_of_node_.end(), std::pair(node, UINT32_MAX));
  if (last - first > max_smooth_shells) return {{shell, false}};
  const std::span shells(first, last);
  const auto place = std::ranges::find(shells, shell, &std::pair<NodeIndex, std::uint32_t>::second);
  const std::vector<int> oriented =
      orientations(node, shells, static_cast<std::size_t>(place - shells.begin()));
  std::vector<TurnedShell> around;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const std::uint32_t other = shells[i].second;
    const double cosine = own.dot(area_vectors_[other].normalized());
    const int sign = oriented[i] != 0 ? oriented[i] : cosine < 0.0 ? -1 : 1;
    if (sign * cosine > smooth_cosine) around.push_back({other, sign < 0});
  }
  return around;
}

std::vector<int> ShellNeighbours::orientations(NodeIndex node,
                                               std::span<const std::pair<NodeIndex, std::uint32_t>> shells,
                                               std::size_t own) const {
  struct Ends {
    NodeIndex before, after;  // of the shell's corners, next to the node
  };
  std::vector<Ends> ends;
  for (const auto& [at, shell] : shells) {
    const auto nodes = corners(shell);
    const auto k = static_cast<std::size_t>(std::ranges::find(nodes, node) - nodes.begin());
    ends.push_back({nodes[(k + nodes.size() - 1) % nodes.size()], nodes[(k + 1) % nodes.size()]});
  }
  std::vector<int> oriented(shells.size(), 0);
  std::vector<std::size_t> reached{own};
  oriented[own] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Ends& a = ends[reached[i]];
    for (std::size_t other = 0; other < ends.size(); ++other) {
      const Ends& b = ends[other];
      const bool goes_on = a.before == b.after || a.after == b.before;
      const bool turns = a.before == b.before || a.after == b.after;
      if (oriented[other] != 0 || !(goes_on || turns)) continue;
      oriented[other] = goes_on ? oriented[reached[i]] : -oriented[reached[i]];
      reached.push_back(other);
    }
  }
  return oriented;
}

Eigen::Vector3d ShellNeighbours::mean_normal(std::span<const TurnedShell> around) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const TurnedShell& one : around)
    sum += one.is_turned ? Eigen::Vector3d(-area_vectors_[one.shell]) : area_vectors_[one.shell];
  return sum.normalized();
}

bool ShellNeighbours::is_perimeter(std::uint32_t shell, int corner) const {
  const auto nodes = corners(shell);
  const auto i = static_cast<std::size_t>(corner);
  const auto [low, high] = std::minmax(nodes[i], nodes[(i + 1) % nodes.size()]);
  if (low == high) return false;
  const auto first = std::lower_bound(edges_.begin(), edges_.end(), Edge{low, high, 0});
  const auto last = std::upper_bound(first, edges_.end(), Edge{low, high, UINT32_MAX});
  return first->shell == std::prev(last)->shell;
}

}  // namespace contactsim
