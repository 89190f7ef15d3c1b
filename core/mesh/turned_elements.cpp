// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/turned_elements.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/element_checks.hpp"

namespace contactsim {

namespace {

/// Share of its volume, or area, below which an element counts as flat [1].
constexpr double flat_share = 1e-6;

/// Of a triangle by two edges, of a quadrilateral by its diagonals [length^2].
Eigen::Vector3d area_of(const Eigen::Matrix3Xd& x, std::span<const NodeIndex> nodes, std::size_t n_corners) {
  const Eigen::Vector3d first = x.col(nodes[2].value) - x.col(nodes[0].value);
  const auto from = n_corners == 3 ? nodes[0].value : nodes[1].value;
  // Of a triangle the second is the edge to its second node.
  const Eigen::Vector3d second = x.col(nodes[n_corners == 3 ? 1 : 3].value) - x.col(from);
  return n_corners == 3 ? 0.5 * second.cross(first) : 0.5 * first.cross(second);
}

/// Volumes of the three edges at each corner of a hexahedron [length^3].
std::array<double, 8> corner_volumes(const Eigen::Matrix3Xd& x, std::span<const NodeIndex> nodes) {
  constexpr std::array<std::array<std::size_t, 3>, 8> neighbours{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  std::array<double, 8> volumes{};
  for (std::size_t k = 0; k < 8; ++k) {
    const Eigen::Vector3d origin = x.col(nodes[k].value);
    const auto edge = [&](std::size_t i) -> Eigen::Vector3d {
      return x.col(nodes[neighbours[k][i]].value) - origin;
    };
    volumes[k] = edge(0).cross(edge(1)).dot(edge(2));
  }
  return volumes;
}

bool is_turned_solid(const Eigen::Matrix3Xd& before, const Eigen::Matrix3Xd& after,
                     std::span<const NodeIndex> nodes, const Topology& shape) {
  const double volume = solid_volume(before, nodes, shape);
  if (!(volume > 0.0)) return false;
  if (!(solid_volume(after, nodes, shape) > flat_share * volume)) return true;
  if (shape.n_corners != 8) return false;
  const auto had = corner_volumes(before, nodes), has = corner_volumes(after, nodes);
  for (std::size_t k = 0; k < 8; ++k) {
    if (had[k] > flat_share * volume && !(has[k] > 0.0)) return true;
  }
  return false;
}

bool is_turned_shell(const Eigen::Matrix3Xd& before, const Eigen::Matrix3Xd& after,
                     std::span<const NodeIndex> nodes, const Topology& shape) {
  const Eigen::Vector3d had = area_of(before, nodes, shape.n_corners);
  const Eigen::Vector3d has = area_of(after, nodes, shape.n_corners);
  return had.squaredNorm() > 0.0 && !(has.dot(had) > flat_share * had.squaredNorm());
}

}  // namespace

std::vector<ElementIndex> find_turned_elements(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates) {
  const Eigen::Matrix3Xd& before = mesh.coordinates();
  std::vector<ElementIndex> turned;
  for (const ElementBlock& block : mesh.blocks()) {
    const Topology& shape = topology(block.shape);
    if (shape.family != Family::solid && shape.family != Family::shell) continue;
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      const auto nodes = block.element_nodes(e);
      const auto has_moved = [&](NodeIndex node) {
        return coordinates.col(node.value) != before.col(node.value);
      };
      if (std::ranges::none_of(nodes, has_moved)) continue;
      const bool is_turned = shape.family == Family::solid
                                 ? is_turned_solid(before, coordinates, nodes, shape)
                                 : is_turned_shell(before, coordinates, nodes, shape);
      if (is_turned) turned.push_back({block.first_element.value + e});
    }
  }
  return turned;
}

}  // namespace contactsim
