// SPDX-License-Identifier: BSD-3-Clause
#include "bench_meshes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "core/mesh/renumber_mesh.hpp"

namespace contactsim::bench {

namespace {

/// The corners of the cell i, j, k in a grid of n cells along each edge, in HEX8 order.
std::array<NodeIndex, 8> cell_corners(std::uint32_t n, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const auto node = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return NodeIndex{(i + a) + (n + 1) * ((j + b) + (n + 1) * (k + c))};
  };
  return {node(0, 0, 0), node(1, 0, 0), node(1, 1, 0), node(0, 1, 0),
          node(0, 0, 1), node(1, 0, 1), node(1, 1, 1), node(0, 1, 1)};
}

ElementBlock make_block(std::uint32_t n, std::array<std::uint32_t, 3> first, std::uint32_t n_cells,
                        bool shuffled) {
  ElementBlock block;
  block.shape = Shape::hex8;
  block.type_name = "HEX8";
  block.nodes_per_element = 8;
  block.n_elements = n_cells * n_cells * n_cells;
  block.nodes.reserve(std::size_t{8} * block.n_elements);
  std::vector<std::uint32_t> order(block.n_elements);
  std::iota(order.begin(), order.end(), 0u);
  if (shuffled) std::shuffle(order.begin(), order.end(), std::mt19937(1));
  for (const std::uint32_t cell : order) {
    const std::uint32_t i = cell % n_cells, j = cell / n_cells % n_cells, k = cell / n_cells / n_cells;
    const auto corners = cell_corners(n, first[0] + i, first[1] + j, first[2] + k);
    block.nodes.insert(block.nodes.end(), corners.begin(), corners.end());
  }
  return block;
}

/// The nodes of a grid of unit cells.
MeshParts make_grid(std::uint32_t n) {
  MeshParts parts;
  parts.path = "cube";
  parts.coordinates.resize(3, static_cast<Eigen::Index>(n + 1) * (n + 1) * (n + 1));
  for (Eigen::Index node = 0; node < parts.coordinates.cols(); ++node) {
    const Eigen::Index row = n + 1;
    parts.coordinates.col(node) =
        Eigen::Array<Eigen::Index, 3, 1>(node % row, node / row % row, node / row / row)
            .cast<double>()
            .matrix();
  }
  return parts;
}

/// Where the point (i, j, k) of an n x n x n cube's surface comes to lie on the unit sphere; equal angles
/// between neighbours make faces of nearly equal size.
Eigen::Vector3d on_unit_sphere(std::uint32_t n, std::array<std::uint32_t, 3> at) {
  Eigen::Vector3d point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = std::tan(std::numbers::pi / 4 * (2.0 * at[static_cast<std::size_t>(axis)] / n - 1.0));
  return point.normalized();
}

/// Numbers the points of an n x n x n cube's surface as they are asked for.
class CubeNodes {
 public:
  explicit CubeNodes(std::uint32_t n) : n_(n), numbers_(std::size_t{n + 1} * (n + 1) * 6, none) {}

  std::uint32_t number(std::array<std::uint32_t, 3> at) {
    std::uint32_t& number = numbers_[place(at)];
    if (number == none) {
      number = static_cast<std::uint32_t>(points_.size());
      points_.push_back(on_unit_sphere(n_, at));
    }
    return number;
  }
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// One place for each point, on the first side that has it.
  std::size_t place(std::array<std::uint32_t, 3> at) const {
    std::size_t axis = 0;
    while (at[axis] != 0 && at[axis] != n_) ++axis;
    const std::size_t side = 2 * axis + (at[axis] == n_), width = n_ + 1;
    return (side * width + at[(axis + 1) % 3]) * width + at[(axis + 2) % 3];
  }

  std::uint32_t n_;
  std::vector<std::uint32_t> numbers_;
  std::vector<Eigen::Vector3d> points_;
};

/// The quad i, j of one of the cube's six sides.
std::array<std::uint32_t, 4> side_quad(CubeNodes& nodes, std::uint32_t n, std::uint32_t side,
                                       std::array<std::uint32_t, 2> cell) {
  const std::uint32_t axis = side / 2;
  const bool is_far = side % 2 == 1;
  const auto corner = [&](std::uint32_t a, std::uint32_t b) {
    std::array<std::uint32_t, 3> at = {};
    at[axis] = is_far ? n : 0;
    at[(axis + 1) % 3] = cell[0] + a;
    at[(axis + 2) % 3] = cell[1] + b;
    return nodes.number(at);
  };
  if (is_far) return {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
  return {corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)};
}

}  // namespace

Mesh make_shell_sheet(std::uint32_t n) {
  MeshParts parts;
  parts.path = "sheet";
  const Eigen::Index row = n + 1;
  parts.coordinates.resize(3, row * row);
  for (Eigen::Index node = 0; node < row * row; ++node) {
    const auto x = static_cast<double>(node % row), y = static_cast<double>(node / row);
    parts.coordinates.col(node) = Eigen::Vector3d(x, y, 0.1 * std::sin(0.7 * x) * std::sin(0.9 * y));
  }
  ElementBlock block;
  block.id = 1;
  block.shape = Shape::shell4;
  block.type_name = "SHELL4";
  block.nodes_per_element = 4;
  block.n_elements = n * n;
  for (std::uint32_t cell = 0; cell < n * n; ++cell) {
    const std::uint32_t first = cell % n + (n + 1) * (cell / n);
    for (const std::uint32_t corner : {first, first + 1, first + n + 2, first + n + 1})
      block.nodes.push_back({corner});
  }
  parts.blocks.push_back(std::move(block));
  return renumber_mesh(Mesh(std::move(parts)));
}

Mesh make_tet_cube(std::uint32_t n) {
  // The six ways from corner 0 along edges to corner 6.
  constexpr std::size_t ways[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                      {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  MeshParts parts = make_grid(n);
  ElementBlock block;
  block.id = 1;
  block.shape = Shape::tet4;
  block.type_name = "TETRA4";
  block.nodes_per_element = 4;
  block.n_elements = 6 * n * n * n;
  for (std::uint32_t cell = 0; cell < n * n * n; ++cell) {
    const auto corners = cell_corners(n, cell % n, cell / n % n, cell / n / n);
    for (const auto& way : ways) {
      for (const std::size_t corner : way) block.nodes.push_back(corners[corner]);
    }
  }
  parts.blocks.push_back(std::move(block));
  return renumber_mesh(Mesh(std::move(parts)));
}

Mesh make_hex_cube(std::uint32_t n, std::uint32_t n_blocks, bool shuffled) {
  MeshParts parts = make_grid(n);
  const std::uint32_t n_cells = n / n_blocks;
  for (std::uint32_t b = 0; b < n_blocks * n_blocks * n_blocks; ++b) {
    const std::array<std::uint32_t, 3> first{b % n_blocks * n_cells, b / n_blocks % n_blocks * n_cells,
                                             b / n_blocks / n_blocks * n_cells};
    parts.blocks.push_back(make_block(n, first, n_cells, shuffled));
    parts.blocks.back().id = b + 1;
  }
  Mesh mesh(std::move(parts));
  return shuffled ? mesh : renumber_mesh(std::move(mesh));
}

QuadSurface make_cubed_sphere(std::uint32_t n, double radius, double noise) {
  QuadSurface surface;
  CubeNodes nodes(n);
  surface.quads.reserve(std::size_t{6} * n * n);
  for (std::uint32_t side = 0; side < 6; ++side) {
    for (std::uint32_t cell = 0; cell < n * n; ++cell)
      surface.quads.push_back(side_quad(nodes, n, side, {cell % n, cell / n}));
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> off(-noise, noise);
  surface.positions.resize(3, static_cast<Eigen::Index>(nodes.points().size()));
  for (Eigen::Index i = 0; i < surface.positions.cols(); ++i) {
    const Eigen::Vector3d moved = Eigen::Vector3d::NullaryExpr([&] { return off(random); });
    surface.positions.col(i) = radius * nodes.points()[static_cast<std::size_t>(i)] + moved;
  }
  return surface;
}

SpherePair make_sphere_pair(std::uint32_t n) {
  const double radius = n * std::sqrt(6.0 / (4.0 * std::numbers::pi));
  return {make_cubed_sphere(n, radius, 0.02), make_cubed_sphere(n, radius + 0.1, 0.02)};
}

void turn(QuadSurface& surface, double angle) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  surface.positions = (rotation * surface.positions).eval();
}

}  // namespace contactsim::bench
