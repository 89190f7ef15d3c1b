// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

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

}  // namespace contactsim::test
