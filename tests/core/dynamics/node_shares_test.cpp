// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/node_shares.hpp"

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A long bar of 8 x 8 x 40 hexahedra: five chunks of eight layers, 81 nodes a layer.
struct LongBar {
  LongBar() : mesh(MeshBuilder().add_hexes({.cells = {8, 8, 40}}).build()) {
    model.mesh = &mesh;
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, {ElasticLaw{}, 1.0}));
  }
  Mesh mesh;
  Model model;
};

std::int64_t count(const std::vector<NodeRange>& ranges) {
  std::int64_t n = 0;
  for (const NodeRange& range : ranges) n += range.end - range.begin;
  return n;
}

}  // namespace

TEST_CASE("a rank follows the nodes of its chunks and of its sums", "[core][node_shares]") {
  const LongBar bar;
  REQUIRE(bar.mesh.n_nodes() == 81 * 41);
  const ChunkShares chunks(bar.model.blocks, 2);
  REQUIRE(chunks.of(0, 0).size() == 2);  // 1024 of 2560 elements
  const NodeShares nodes(bar.model, chunks, {});
  REQUIRE(nodes.n_sums() == 2);
  // Of the first 2048 nodes rank 0 has layers 0 to 16 (1377 nodes), rank 1 those from 16 on.
  CHECK(nodes.rank_of_sum(0) == 0);
  CHECK(nodes.rank_of_sum(1) == 1);
  CHECK(nodes.nodes_of_sum(1).begin == 2048);
  CHECK(nodes.nodes_of_sum(1).end == 81 * 41);
  CHECK(count(nodes.followed(0)) == 2048);
  // From layer 16 on, 16 x 81 = 1296.
  CHECK(count(nodes.followed(1)) == 81 * 41 - 1296);
  CHECK(count(nodes.followed_for_others(1)) == 2048 - 1296);
  CHECK(nodes.followed_for_others(0).empty());
  CHECK_FALSE(nodes.follows(1, 1295));
  CHECK(nodes.follows(1, 1296));
}

TEST_CASE("a node of no element is followed by the first rank", "[core][node_shares]") {
  MeshBuilder builder;
  builder.add_hexes({.cells = {8, 8, 40}});
  builder.add_node({0, 0, 99});
  const Mesh mesh = builder.build();
  LongBar bar;
  bar.model.mesh = &mesh;
  const NodeShares nodes(bar.model, ChunkShares(bar.model.blocks, 2), {});
  CHECK(nodes.follows(0, 81 * 41));
}

TEST_CASE("nodes that all need are followed by all ranks", "[core][node_shares]") {
  LongBar bar;
  const ChunkShares chunks(bar.model.blocks, 4);
  const std::vector<NodeIndex> touched{{0}, {3000}};
  RigidBody body;
  body.nodes = {{500}};
  bar.model.rigid.bodies.push_back(body);
  const NodeShares nodes(bar.model, chunks, touched);
  for (int rank = 0; rank < 4; ++rank) {
    for (const std::uint32_t node : {0U, 500U, 3000U}) CHECK(nodes.follows(rank, node));
  }
  CHECK(nodes.follows(0, 1));  // beside a node that all need, only by the rank that has it
  CHECK_FALSE(nodes.follows(3, 1));
}
