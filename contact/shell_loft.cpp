// SPDX-License-Identifier: BSD-3-Clause
#include "contact/shell_loft.hpp"

#include <algorithm>

#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// Shells that meet at a sharper angle keep their own normals: a mean normal would loft them inside out.
constexpr double smooth_cosine = 0.5;

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
    for (const NodeIndex node : nodes) shells_of_node_.emplace_back(node, shell);
  }
  std::sort(shells_of_node_.begin(), shells_of_node_.end());
}

std::span<const NodeIndex> ShellNeighbours::corners(std::uint32_t shell) const {
  const ElementIndex element = shells_[shell];
  const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(element)].shape);
  return mesh_.element_nodes(element).first(shape.n_corners);
}

Eigen::Vector3d ShellNeighbours::corner_normal(std::uint32_t shell, int corner) const {
  const NodeIndex node = corners(shell)[static_cast<std::size_t>(corner)];
  const Eigen::Vector3d own = area_vectors_[shell].normalized();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  auto entry = std::lower_bound(shells_of_node_.begin(), shells_of_node_.end(), std::pair(node, 0u));
  for (; entry != shells_of_node_.end() && entry->first == node; ++entry) {
    const Eigen::Vector3d& other = area_vectors_[entry->second];
    const double cosine = own.dot(other.normalized());
    if (std::abs(cosine) > smooth_cosine) sum += cosine > 0.0 ? other : Eigen::Vector3d(-other);
  }
  return sum.normalized();
}

bool ShellNeighbours::is_perimeter(std::uint32_t shell, int corner) const {
  const auto nodes = corners(shell);
  const auto first = static_cast<std::size_t>(corner);
  const NodeIndex from = nodes[first], to = nodes[(first + 1) % nodes.size()];
  auto entry = std::lower_bound(shells_of_node_.begin(), shells_of_node_.end(), std::pair(from, 0u));
  for (; entry != shells_of_node_.end() && entry->first == from; ++entry) {
    if (entry->second == shell) continue;
    const auto others = corners(entry->second);
    for (std::size_t i = 0; i < others.size(); ++i) {
      const NodeIndex a = others[i], b = others[(i + 1) % others.size()];
      if ((a == from && b == to) || (a == to && b == from)) return false;
    }
  }
  return true;
}

}  // namespace contactsim
