// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/model_block.hpp"

#include <algorithm>
#include <array>

#include "core/materials/linear_hardening.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a block's last batch is filled up with copies of its last element", "[core][elements]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {3, 1, 1}}).build();
  const ElementFormulation& row = *find_solid_element(Shape::hex8, "MEAN_QUADRATURE");
  const ModelBlock block = make_solid_block(mesh, 0, row, undamped_elastic());
  CHECK(block.n_elements == 3);
  REQUIRE(block.n_batches() == 1);
  CHECK((block.mass[0] - 2600.0).abs().maxCoeff() < 1e-9);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const auto node = [&](std::size_t lane) {
      return block.chunk_nodes[block.nodes[corner * n_lanes + lane]];
    };
    for (std::uint32_t element = 0; element < 3; ++element)
      CHECK(node(element) == mesh.blocks()[0].element_nodes(element)[corner].value);
    for (std::size_t lane = 3; lane < n_lanes; ++lane) CHECK(node(lane) == node(2));
  }
}

TEST_CASE("a block stands in chunks, each with nodes of its own", "[core][elements]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {11, 10, 10}}).build();  // 1100 elements, 138 batches
  const ElementFormulation& row = *find_solid_element(Shape::hex8, "mean_quadrature");
  const ModelBlock block = make_solid_block(mesh, 0, row, undamped_elastic());
  REQUIRE(block.n_batches() == 138);
  REQUIRE(block.chunks.size() == 3);
  std::size_t batch = 0, node = 0;
  for (const BatchChunk& chunk : block.chunks) {
    CHECK(chunk.first_batch == batch);
    CHECK(chunk.first_node == node);
    batch += chunk.n_batches;
    node += chunk.n_nodes;
    std::vector<std::uint32_t> nodes(block.nodes_of(chunk).begin(), block.nodes_of(chunk).end());
    std::sort(nodes.begin(), nodes.end());
    CHECK(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
  }
  CHECK(batch == block.n_batches());
  CHECK(node == block.chunk_nodes.size());
}

TEST_CASE("chunks are split where subcycled batches begin and end", "[core][elements]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {11, 10, 10}}).build();
  const ElementFormulation& row = *find_solid_element(Shape::hex8, "mean_quadrature");
  ModelBlock block = make_solid_block(mesh, 0, row, undamped_elastic());
  const ModelBlock whole = block;
  std::vector<std::uint8_t> is_subcycled(138, 0);
  for (const std::size_t batch : {5, 6, 137}) is_subcycled[batch] = 1;
  split_chunks(mesh, is_subcycled, block);
  const std::vector<std::array<std::size_t, 3>> expected{{0, 5, 0},   {5, 2, 1},   {7, 64, 0},
                                                         {71, 64, 0}, {135, 2, 0}, {137, 1, 1}};
  REQUIRE(block.chunks.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(block.chunks[i].first_batch == expected[i][0]);
    CHECK(block.chunks[i].n_batches == expected[i][1]);
    CHECK(block.chunks[i].is_subcycled == (expected[i][2] != 0));
  }
  // The elements have the nodes that they had.
  for (const BatchChunk& chunk : block.chunks) {
    for (std::size_t k = 8 * n_lanes * chunk.first_batch;
         k < 8 * n_lanes * (chunk.first_batch + chunk.n_batches); ++k) {
      const std::size_t parent = k / (8 * n_lanes) / ModelBlock::batches_per_chunk;
      CHECK(block.nodes_of(chunk)[block.nodes[k]] == whole.nodes_of(whole.chunks[parent])[whole.nodes[k]]);
    }
  }
  // Places of both kinds are all there are, once.
  std::vector<std::uint32_t> places = find_places(block, false);
  for (const std::uint32_t place : find_places(block, true)) {
    CHECK(std::ranges::find(places, place) == places.end());
    places.push_back(place);
  }
  CHECK(places.size() == block.chunk_nodes.size());
  // None is, all are: as they were, and one kind of places.
  split_chunks(mesh, std::vector<std::uint8_t>(138, 0), block);
  CHECK(block.nodes == whole.nodes);
  CHECK(block.chunk_nodes == whole.chunk_nodes);
  split_chunks(mesh, std::vector<std::uint8_t>(138, 1), block);
  CHECK(block.sums.nodes().empty());
  CHECK(find_places(block, false).empty());
}

TEST_CASE("a state holds per point a stress and what the material remembers", "[core][elements]") {
  const ElementFormulation& row = *find_solid_element(Shape::hex8, "mean_quadrature");
  const MaterialLaw law = PlasticLaw<LinearHardening>{{160e9, 80e9}, {200e6, 1e9, 1e9}};
  LoneElement element(row, undamped(law), regular_element(Shape::hex8));
  const StateLayout& layout = element.block.layout;
  CHECK(layout.point_size == 13);  // stress, back stress, equivalent plastic strain
  CHECK(layout.energy() == 13 + 12);
  CHECK(layout.size() == 26);
  for (const Lanes& number : element.state.values) CHECK((number == 0.0).all());
  element.state.values[12](0) = 0.5;
  CHECK(element.state.at(layout, 0, 12) == 0.5);
}
