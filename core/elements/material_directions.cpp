// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/material_directions.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

Eigen::Matrix3d matrix_of(const AxisRotation& rotation) {
  const double angle = rotation.angle * std::numbers::pi / 180.0;
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(rotation.axis - 1)).toRotationMatrix();
}

/// The directions 1 and 2 of a shell in its own axes; nothing when the first is its normal.
///   frame  rows: its axes
std::optional<Eigen::Matrix3d> laid_into(const Eigen::Matrix3d& frame, const Eigen::Matrix3d& directions) {
  const Eigen::Vector3d first = frame * directions.col(0);
  const double length = first.head<2>().norm();
  constexpr double tolerance = 1e-6;  // sine of the angle to the normal
  if (!(length > tolerance)) return std::nullopt;
  const double c = first.x() / length, s = first.y() / length;
  return Eigen::Matrix3d{{c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
}

}  // namespace

Eigen::Matrix3d MaterialDirections::at(const Eigen::Vector3d& place) const {
  return system.directions_at(place) * matrix_of(first_rotation) * matrix_of(second_rotation);
}

std::optional<std::size_t> set_directions(const MaterialDirections& choice, const Mesh& mesh,
                                          ModelBlock& block) {
  const ElementBlock& source = mesh.blocks()[block.mesh_block];
  block.directions.resize(6 * block.n_batches());
  for (std::size_t lane = 0; lane < block.n_batches() * n_lanes; ++lane) {
    const std::size_t element = std::min(lane, block.n_elements - 1);
    const auto nodes = source.element_nodes(static_cast<std::uint32_t>(element));
    ElementVectors x(3, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t a = 0; a < nodes.size(); ++a)
      x.col(static_cast<Eigen::Index>(a)) = mesh.coordinates().col(nodes[a].value);
    Eigen::Matrix3d directions = choice.at(x.rowwise().mean());
    if (block.element->frame != nullptr) {
      const auto laid = laid_into(block.element->frame(x), directions);
      if (!laid) return element;
      directions = *laid;
    }
    for (Eigen::Index i = 0; i < 6; ++i)
      block.directions[lane / n_lanes * 6 + static_cast<std::size_t>(i)](
          static_cast<Eigen::Index>(lane % n_lanes)) = directions(i);
  }
  return std::nullopt;
}

}  // namespace contactsim
