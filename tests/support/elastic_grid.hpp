// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/statics/multigrid/multigrid.hpp"
#include "core/statics/multigrid/rigid_modes.hpp"

namespace contactsim::test {

/// The stiffness of a block of elastic hexahedra of eight points, of E = 1.
struct ElasticGrid {
  std::array<std::uint32_t, 3> cells = {4, 4, 4};
  Eigen::Vector3d cell_size = Eigen::Vector3d::Ones();
  double poisson = 0.3;
  bool is_held = true;  ///< the nodes of z = 0

  std::uint32_t n_nodes() const { return (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1); }
  std::array<std::uint32_t, 3> place(std::uint32_t node) const {
    const std::uint32_t nx = cells[0] + 1, ny = cells[1] + 1;
    return {node % nx, node / nx % ny, node / nx / ny};
  }
  Eigen::Matrix3Xd coordinates() const {
    Eigen::Matrix3Xd all(3, n_nodes());
    for (std::uint32_t node = 0; node < n_nodes(); ++node) {
      for (Eigen::Index i = 0; i < 3; ++i)
        all(i, node) = place(node)[static_cast<std::size_t>(i)] * cell_size(i);
    }
    return all;
  }
  bool holds(std::uint32_t node) const { return is_held && place(node)[2] == 0; }

  /// Modes of a rigid body, 0 of held nodes.
  Modes modes() const {
    Modes all = make_rigid_modes(coordinates());
    for (std::uint32_t node = 0; node < n_nodes(); ++node) {
      if (holds(node)) all.middleRows<3>(3 * Eigen::Index{node}).setZero();
    }
    return all;
  }

  /// A force of 1 on every node that is not held, obliquely.
  Eigen::VectorXd load() const {
    Eigen::VectorXd all(3 * Eigen::Index{n_nodes()});
    for (std::uint32_t node = 0; node < n_nodes(); ++node)
      part_of<3>(all, node) = holds(node) ? Eigen::Vector3d::Zero() : Eigen::Vector3d(0.6, 0.0, -0.8);
    return all;
  }

  /// Of one element, nodes numbered by x, then y, then z.
  Eigen::Matrix<double, 24, 24> element_stiffness() const {
    const double lambda = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)), shear = 0.5 / (1.0 + poisson);
    Eigen::Matrix<double, 24, 24> stiffness = Eigen::Matrix<double, 24, 24>::Zero();
    for (int point = 0; point < 8; ++point) {
      Eigen::Matrix<double, 3, 8> gradients;
      for (int node = 0; node < 8; ++node) {
        for (int i = 0; i < 3; ++i) {
          double value = (node >> i & 1) != 0 ? 1.0 / cell_size(i) : -1.0 / cell_size(i);
          for (const int j : {(i + 1) % 3, (i + 2) % 3})
            value *= 0.5 * (1.0 + ((node >> j & 1) == (point >> j & 1) ? 1.0 : -1.0) / std::sqrt(3.0));
          gradients(i, node) = value;
        }
      }
      for (int a = 0; a < 8; ++a) {
        for (int b = 0; b < 8; ++b) {
          const Eigen::Vector3d of_a = gradients.col(a), of_b = gradients.col(b);
          stiffness.block<3, 3>(3 * a, 3 * b) +=
              cell_size.prod() / 8.0 *
              (lambda * of_a * of_b.transpose() + shear * of_b * of_a.transpose() +
               shear * of_a.dot(of_b) * Eigen::Matrix3d::Identity());
        }
      }
    }
    return stiffness;
  }

  BlockMatrix<3, 3> stiffness() const {
    const Eigen::Matrix<double, 24, 24> of_element = element_stiffness();
    BlockMatrix<3, 3> matrix;
    matrix.n_columns = n_nodes();
    matrix.first.push_back(0);
    for (std::uint32_t row = 0; row < n_nodes(); ++row) {
      for (const std::uint32_t column : neighbours(row)) {
        matrix.columns.push_back(column);
        const Eigen::Matrix3d block = block_of(of_element, row, column);
        matrix.values.insert(matrix.values.end(), block.data(), block.data() + 9);
      }
      matrix.first.push_back(matrix.columns.size());
    }
    return matrix;
  }

 private:
  /// The nodes of the cells around a node, ascending.
  std::vector<std::uint32_t> neighbours(std::uint32_t node) const {
    const auto [x, y, z] = place(node);
    const std::uint32_t nx = cells[0] + 1, ny = cells[1] + 1, nz = cells[2] + 1;
    const auto before = [](std::uint32_t i) { return i == 0 ? 0 : i - 1; };
    std::vector<std::uint32_t> all;
    for (std::uint32_t k = before(z); k < std::min(z + 2, nz); ++k) {
      for (std::uint32_t j = before(y); j < std::min(y + 2, ny); ++j) {
        for (std::uint32_t i = before(x); i < std::min(x + 2, nx); ++i) all.push_back(i + nx * (j + ny * k));
      }
    }
    return all;
  }

  /// The sum over the elements that both nodes are in; of a held node what keeps it where it is.
  Eigen::Matrix3d block_of(const Eigen::Matrix<double, 24, 24>& of_element, std::uint32_t row,
                           std::uint32_t column) const {
    if (holds(row) || holds(column)) return (row == column ? 1.0 : 0.0) * Eigen::Matrix3d::Identity();
    const auto r = place(row), c = place(column);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int a = 0; a < 8; ++a) {
      int b = 0;
      bool is_inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t of_a = static_cast<std::uint32_t>(a) >> i & 1U;
        const std::uint32_t of_b = c[i] + of_a - r[i];  // wraps round below 0
        is_inside = is_inside && of_b <= 1 && r[i] >= of_a && r[i] - of_a < cells[i];
        b |= static_cast<int>((of_b & 1U) << i);
      }
      if (is_inside) sum += of_element.block<3, 3>(3 * a, 3 * b);
    }
    return sum;
  }
};

}  // namespace contactsim::test
