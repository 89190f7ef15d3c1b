// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// Adds a sheet whose shells all have one thickness.
inline void add_plate(MeshBuilder& b, const Sheet& sheet, double thickness) {
  b.add_shells(sheet);
  const auto n = static_cast<std::size_t>(sheet.cells[0] * sheet.cells[1]);
  b.set_attributes(sheet.id, {"thickness"}, std::vector<double>(n, thickness));
}

/// Adds a beam of some elements whose radius is 0.1.
inline void add_rod(MeshBuilder& b, const Row& row) {
  b.add_beams(row);
  b.set_attributes(row.id, {"area"},
                   std::vector<double>(static_cast<std::size_t>(row.cells), 0.01 * std::numbers::pi));
}

/// Adds particles of one radius.
inline void add_balls(MeshBuilder& b, std::int64_t id, const std::vector<Eigen::Vector3d>& centres,
                      double radius) {
  b.add_spheres(id, "", centres);
  b.set_attributes(id, {"radius"}, std::vector<double>(centres.size(), radius));
}

/// A solid bar along x with a sharp edge up, and one across it with a sharp edge down, so far apart.
inline MeshBuilder crossed_bars(double gap) {
  MeshBuilder b;
  const auto add_bar = [&](std::int64_t id, const Eigen::Vector3d& way, double up, double z) {
    const Eigen::Vector3d aside = Eigen::Vector3d::UnitZ().cross(way);
    std::vector<std::uint32_t> nodes;
    for (const double end : {-1.0, 1.0}) {
      for (const auto& [a, h] : {std::pair(0.0, -1.0), {0.5, -0.5}, {0.0, 0.0}, {-0.5, -0.5}})
        nodes.push_back(b.add_node(end * way + a * aside + Eigen::Vector3d(0, 0, z + up * h)).value);
    }
    if (up < 0.0) std::rotate(nodes.begin(), nodes.begin() + 4, nodes.end());
    b.add_block(id, "", Shape::hex8, nodes);
  };
  add_bar(1, Eigen::Vector3d::UnitX(), 1.0, 0.0);
  add_bar(2, Eigen::Vector3d(0.1, 1, 0).normalized(), -1.0, gap);
  return b;
}

}  // namespace contactsim::test
