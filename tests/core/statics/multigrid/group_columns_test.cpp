// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/multigrid/group_columns.hpp"

#include "core/statics/multigrid/rigid_modes.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

Eigen::Matrix3Xd scattered_places(Eigen::Index n) {
  Eigen::Matrix3Xd places(3, n);
  for (Eigen::Index i = 0; i < places.size(); ++i) places(i) = std::sin(2.3 * static_cast<double>(i * i));
  return places;
}

}  // namespace

TEST_CASE("columns are orthonormal and come to the modes by their coefficients", "[core][statics]") {
  const Modes modes = make_rigid_modes(scattered_places(5));
  Modes columns = modes;
  const Eigen::Matrix<double, 6, 6> coefficients = orthonormalise(columns);
  CHECK((columns.transpose() * columns).isIdentity(1e-14));
  CHECK((columns * coefficients).isApprox(modes, 1e-14));
  CHECK(coefficients.isUpperTriangular(0.0));
}

TEST_CASE("modes that depend on others have no column", "[core][statics]") {
  // One node does not turn; two do not about the line between them.
  for (const Eigen::Index n : {1, 2}) {
    Eigen::Matrix3Xd places = scattered_places(9).leftCols(n);
    Modes modes = make_rigid_modes(scattered_places(9)).topRows(3 * n);
    Modes columns = modes;
    const Eigen::Matrix<double, 6, 6> coefficients = orthonormalise(columns);
    const Eigen::MatrixXd squares = columns.transpose() * columns;
    CHECK(squares.diagonal().sum() == Approx(n == 1 ? 3.0 : 5.0));
    CHECK((squares - Eigen::MatrixXd(squares.diagonal().asDiagonal())).norm() < 1e-7);
    CHECK((columns * coefficients - modes).norm() < 1e-7 * modes.norm());
    CHECK(places.allFinite());
  }
  Modes nothing = Modes::Zero(6, 6);
  CHECK(orthonormalise(nothing).isZero(0.0));
  CHECK(nothing.isZero(0.0));
}

TEST_CASE("nearly parallel modes are distinguished all the same", "[core][statics]") {
  Modes modes = make_rigid_modes(scattered_places(5));
  modes.col(1) = modes.col(0) + 1e-6 * modes.col(1);
  orthonormalise(modes);
  CHECK((modes.transpose() * modes).isIdentity(1e-12));  // once over would leave 1e-10
}

TEST_CASE("nodes are listed group by group, those without one left out", "[core][statics]") {
  constexpr std::nullopt_t none = std::nullopt;
  const GroupNodes list = list_nodes({{1, none, 0, 1, 0, none, 3}, 4});
  CHECK(list.first == std::vector<std::size_t>{0, 2, 4, 4, 5});
  CHECK(list.nodes == std::vector<std::uint32_t>{2, 4, 0, 3, 6});
  CHECK(list_nodes({{}, 0}).nodes.empty());
  CHECK(list_nodes({{none, none}, 0}).first == std::vector<std::size_t>{0});
}

TEST_CASE("every group has the columns of its own nodes and hands its modes on", "[core][statics]") {
  const Aggregates groups{{0, 1, 1, std::nullopt, 0, 1, 0}, 2};
  const Modes modes = make_rigid_modes(scattered_places(7));
  const GroupColumns<3> columns = make_group_columns<3>(groups, modes);
  REQUIRE(columns.of_node.size() == 7);
  REQUIRE(columns.coarse_modes.rows() == 12);
  CHECK(columns.of_node[3].isZero(0.0));
  for (std::uint32_t node = 0; node < 7; ++node) {
    if (node == 3) continue;
    const auto coarse = columns.coarse_modes.middleRows<6>(6 * Eigen::Index{*groups.of_node[node]});
    CHECK((columns.of_node[node] * coarse).isApprox(modes.middleRows<3>(3 * Eigen::Index{node}), 1e-13));
  }
}
