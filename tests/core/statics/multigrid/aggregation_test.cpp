// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/aggregation.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

struct Joint {
  std::uint32_t a, b;
  double stiffness;
};

/// Nodes of unit stiffness with blocks of -stiffness between those that are joined.
BlockMatrix<3, 3> joined(std::uint32_t n_nodes, const std::vector<Joint>& joints) {
  BlockMatrix<3, 3> matrix;
  matrix.n_columns = n_nodes;
  matrix.first.push_back(0);
  for (std::uint32_t row = 0; row < n_nodes; ++row) {
    for (std::uint32_t column = 0; column < n_nodes; ++column) {
      double value = row == column ? 1.0 : 0.0;
      for (const auto& [a, b, stiffness] : joints) {
        if ((a == row && b == column) || (a == column && b == row)) value = -stiffness;
      }
      if (value == 0.0) continue;
      const Eigen::Matrix3d block = value * Eigen::Matrix3d::Identity();
      matrix.columns.push_back(column);
      matrix.values.insert(matrix.values.end(), block.data(), block.data() + 9);
    }
    matrix.first.push_back(matrix.columns.size());
  }
  return matrix;
}

using Groups = std::vector<OptionalIndex<std::uint32_t>>;

Groups groups_of(const BlockMatrix<3, 3>& matrix, double threshold) {
  return aggregate(matrix.first, matrix.columns, find_strengths(matrix, threshold)).of_node;
}

constexpr std::nullopt_t none = std::nullopt;

}  // namespace

TEST_CASE("nodes join those that they hang together with", "[core][statics]") {
  const auto chain = joined(6, {{0, 1, 0.5}, {1, 2, 0.5}, {2, 3, 0.5}, {3, 4, 0.5}});
  CHECK(groups_of(chain, 0.08) == Groups{0, 0, 1, 1, 1, none});
}

TEST_CASE("what is left over goes where it is joined most strongly", "[core][statics]") {
  // Along the chain 2 - 0 - 3 - 6 - 4 - 1 - 5 nodes 0 and 1 make groups of three; node 6 stands between them.
  for (const double left : {0.2, 0.4}) {
    const auto chain =
        joined(7, {{2, 0, 0.5}, {0, 3, 0.5}, {3, 6, left}, {6, 4, 0.6 - left}, {4, 1, 0.5}, {1, 5, 0.5}});
    const std::uint32_t stronger = left > 0.3 ? 0 : 1;
    CHECK(groups_of(chain, 0.08) == Groups{0, 1, 0, 0, 1, 1, stronger});
  }
}

TEST_CASE("weak blocks join nothing", "[core][statics]") {
  const auto chain = joined(4, {{0, 1, 0.05}, {1, 2, 0.5}, {2, 3, 0.5}});
  CHECK(groups_of(chain, 0.08) == Groups{none, 0, 0, 0});
  CHECK(groups_of(chain, 0.04) == Groups{0, 0, 1, 1});
  CHECK(groups_of(chain, 0.6) == Groups{none, none, none, none});
}
