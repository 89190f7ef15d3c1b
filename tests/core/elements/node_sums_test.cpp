// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/node_sums.hpp"

#include <omp.h>

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("what stands in several places is added at its node, in their order", "[core][elements]") {
  const std::vector<std::uint32_t> nodes{4, 1, 4, 1, 4};
  const NodeSums sums(nodes, 6);
  REQUIRE(sums.nodes().size() == 2);
  CHECK(sums.nodes()[0] == NodeIndex{1});
  CHECK(sums.nodes()[1] == NodeIndex{4});
  std::vector<NodeVector> parts(5, NodeVector::Zero());
  // 1e16 + 1 - 1e16 is 0 in this order and 1 in another.
  for (const auto& [place, value] : {std::pair{0, 1e16}, {2, 1.0}, {4, -1e16}, {1, 2.0}, {3, 3.0}})
    parts[static_cast<std::size_t>(place)].head<3>() = value * Eigen::Vector3d(1, 2, 4);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Constant(3, 6, 0.5);
  sums.add(parts, forces);
  CHECK(forces.col(1) == Eigen::Vector3d(5.5, 10.5, 20.5));  // added to what is there
  CHECK(forces.col(4) == Eigen::Vector3d(0.5, 0.5, 0.5));
  for (const Eigen::Index other : {0, 2, 3, 5}) CHECK(forces.col(other) == Eigen::Vector3d(0.5, 0.5, 0.5));
}

TEST_CASE("some of the places are added alone", "[core][elements]") {
  const std::vector<std::uint32_t> nodes{4, 1, 4, 1, 4}, places{0, 3, 4};
  const NodeSums sums(nodes, 6, places);
  std::vector<NodeVector> parts;
  for (int i = 1; i <= 5; ++i) parts.push_back(NodeVector::Constant(i));
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, 6);
  sums.add(parts, forces);
  CHECK(forces.row(0) == Eigen::RowVectorXd{{0, 4, 0, 0, 6, 0}});
}

TEST_CASE("nodes that follow each other have sums as others have, among all nodes and among some",
          "[core][elements]") {
  // 3, 4 and 5 of seven, and with 1 or without 4 such as do not follow each other.
  for (const std::vector<std::uint32_t>& nodes :
       {std::vector<std::uint32_t>{5, 3, 4, 3}, {5, 3, 4, 1}, {5, 3, 3, 3}}) {
    const NodeSums sums(nodes, 7);
    std::vector<NodeVector> parts;
    for (int i = 1; i <= 4; ++i) parts.push_back(NodeVector::Constant(i));
    Eigen::Matrix3Xd slow = Eigen::Matrix3Xd::Zero(3, 7);
    for (std::size_t i = 0; i < 4; ++i) slow.col(nodes[i]) += parts[i].head<3>();
    std::vector<NodeIndex> those;
    for (std::uint32_t node = 0; node < 7; ++node) {
      if (slow(0, node) != 0.0) those.push_back({node});
    }
    CHECK(sums.nodes() == those);
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, 7);
    sums.add(parts, forces);
    CHECK(forces == slow);
    Eigen::Matrix3Xd set = Eigen::Matrix3Xd::Constant(3, 7, 9.0);
    sums.set(parts, NodeRanges(7), set);
    for (Eigen::Index node = 0; node < 7; ++node)
      CHECK(set.col(node) ==
            (slow(0, node) != 0.0 ? Eigen::Vector3d(slow.col(node)) : Eigen::Vector3d::Constant(9.0)));
    const NodeRange some[] = {{0, 2}, {4, 7}};
    forces.setZero();
    sums.add(parts, NodeRanges(std::span(some)), forces);
    slow.middleCols(2, 2).setZero();
    CHECK(forces == slow);
  }
}

TEST_CASE("a force that is set to nothing is no negative zero", "[core][elements]") {
  const NodeSums sums(std::vector<std::uint32_t>{0}, 1);
  const std::vector<NodeVector> parts{NodeVector::Constant(-0.0)};
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Ones(3, 1);
  sums.set(parts, NodeRanges(1), forces);
  CHECK(forces.isZero(0.0));
  CHECK_FALSE(std::signbit(forces(0, 0)));
}

TEST_CASE("no places, no nodes", "[core][elements]") {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Ones(3, 2);
  NodeSums().add({}, forces);
  const NodeSums none({}, 2);
  CHECK(none.nodes().empty());
  none.add({}, forces);
  CHECK(forces == Eigen::Matrix3Xd::Ones(3, 2));
}

TEST_CASE("sums at nodes have the same bits for any number of threads", "[core][elements]") {
  constexpr std::uint32_t n_nodes = 30000;
  std::vector<std::uint32_t> nodes;
  std::vector<NodeVector> parts;
  for (std::uint32_t i = 0; i < 3 * n_nodes; ++i) {
    nodes.push_back(i * 7919u % n_nodes);
    parts.push_back(NodeVector::Constant(std::sin(static_cast<double>(i))));
  }
  const NodeSums sums(nodes, n_nodes);
  const int n_threads = omp_get_max_threads();
  std::vector<Eigen::Matrix3Xd> found;
  for (const int n : {1, 3}) {
    omp_set_num_threads(n);
    found.push_back(Eigen::Matrix3Xd::Zero(3, n_nodes));
    sums.add(parts, found.back());
  }
  omp_set_num_threads(n_threads);
  CHECK(found[0] == found[1]);
  double whole = 0.0;
  for (const NodeVector& part : parts) whole += part(0);
  CHECK(found[0].row(0).sum() == Approx(whole).margin(1e-9));
}
