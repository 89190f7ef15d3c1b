// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/chunk_vectors.hpp"

#include <random>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Eight elements of n nodes in a chunk, whose nodes are any of it.
template <std::size_t n>
struct SomeElements {
  static constexpr std::size_t n_mesh_nodes = 90, n_chunk_nodes = 40;
  std::mt19937 random{n};
  std::vector<std::uint32_t> chunk_nodes;  // of the mesh
  std::vector<ChunkNode> nodes;            // [n x n_lanes]

  SomeElements() {
    for (std::size_t i = 0; i < n_chunk_nodes; ++i)
      chunk_nodes.push_back(static_cast<std::uint32_t>(random() % n_mesh_nodes));
    for (std::size_t i = 0; i < n * n_lanes; ++i)
      nodes.push_back(static_cast<ChunkNode>(random() % n_chunk_nodes));
  }
  double value() { return std::uniform_real_distribution(-1.0, 1.0)(random); }
  Eigen::Matrix3Xd field() {
    return Eigen::Matrix3Xd::NullaryExpr(3, n_mesh_nodes, [this] { return value(); });
  }
  /// What a node of an element has, by the mesh.
  double at(const Eigen::Matrix3Xd& field, std::size_t i, std::size_t node, std::size_t lane) const {
    return field(static_cast<Eigen::Index>(i), chunk_nodes[nodes[node * n_lanes + lane]]);
  }
  bool is_gathered(const NodeVectors<n>& gathered, const Eigen::Matrix3Xd& field) const {
    bool is = true;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t node = 0; node < n; ++node) {
        for (std::size_t lane = 0; lane < n_lanes; ++lane)
          is = is && gathered[i][node].data()[lane] == at(field, i, node, lane);
      }
    }
    return is;
  }
};

}  // namespace

TEST_CASE("the vectors of one field and of several are gathered from the nodes of a chunk",
          "[core][elements]") {
  SomeElements<8> hexahedra;
  const Eigen::Matrix3Xd x = hexahedra.field(), v = hexahedra.field(), w = hexahedra.field();
  NodeVectors<8> at_x, at_v, at_w;
  batches::ChunkVectors(hexahedra.chunk_nodes, x).gather(hexahedra.nodes.data(), at_x);
  CHECK(hexahedra.is_gathered(at_x, x));
  batches::ChunkVectors(hexahedra.chunk_nodes, w, x, v).gather(hexahedra.nodes.data(), at_w, at_x, at_v);
  CHECK(hexahedra.is_gathered(at_x, x));
  CHECK(hexahedra.is_gathered(at_v, v));
  CHECK(hexahedra.is_gathered(at_w, w));
  // Elements of more nodes than usual.
  SomeElements<20> large;
  const Eigen::Matrix3Xd y = large.field(), u = large.field();
  NodeVectors<20> at_y, at_u;
  batches::ChunkVectors<2, 20>(large.chunk_nodes, y, u).gather(large.nodes.data(), at_y, at_u);
  CHECK(large.is_gathered(at_y, y));
  CHECK(large.is_gathered(at_u, u));
}

TEST_CASE("the vectors of the elements in use are added up at the nodes, one element after another",
          "[core][elements]") {
  SomeElements<4> tetrahedra;
  NodeVectors<4> vectors;
  for (auto& component : vectors) {
    for (Lanes& lanes : component) {
      for (std::size_t lane = 0; lane < n_lanes; ++lane) lanes.data()[lane] = tetrahedra.value();
    }
  }
  for (std::size_t n_used = 0; n_used <= n_lanes; ++n_used) {
    std::vector<NodeVector> sums(SomeElements<4>::n_chunk_nodes, NodeVector(1, 2, 3, 0)), slow = sums;
    batches::scatter_add(vectors, tetrahedra.nodes.data(), n_used, sums.data());
    for (std::size_t node = 0; node < 4; ++node) {
      for (std::size_t lane = 0; lane < n_used; ++lane) {
        for (std::size_t i = 0; i < 3; ++i)
          slow[tetrahedra.nodes[node * n_lanes + lane]](static_cast<Eigen::Index>(i)) +=
              vectors[i][node].data()[lane];
      }
    }
    CHECK(sums == slow);
  }
}
