// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/topology.hpp"
#include "io/netcdf/netcdf_file.hpp"
#include "io/netcdf/netcdf_layout.hpp"

namespace contactsim {

/// All nodes of a side, mid nodes included; absent for unknown shapes.
///   side  from 1, one that the shape has
std::optional<std::size_t> count_side_nodes(Shape shape, int side);

/// The shapes of the elements of a file, block by block.
class ElementShapes {
 public:
  ElementShapes(const NetcdfFile& file, const NetcdfLayout& layout);
  /// Unknown of what no block has.
  ///   element  position in the file
  Shape of(std::size_t element) const;

 private:
  std::vector<std::size_t> ends_;  ///< of each block, behind its last element
  std::vector<Shape> shapes_;
};

/// One side of a set: the shape of its element and its number, which the shape may not have.
struct ShapedSide {
  Shape shape = Shape::unknown;
  std::int64_t side = 0;
};

/// How many distribution factors each side of a set has: one for each of its nodes by the manual, else as
/// many for each side. Absent when the factors are divided in neither way.
std::optional<std::vector<std::size_t>> divide_factors(std::span<const ShapedSide> sides,
                                                       std::size_t n_factors);

}  // namespace contactsim
