// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/model_block.hpp"

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
