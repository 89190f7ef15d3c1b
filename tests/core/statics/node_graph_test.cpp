// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/node_graph.hpp"

#include <algorithm>
#include <set>

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

struct Blocks {
  Mesh mesh;
  std::vector<ModelBlock> blocks;

  explicit Blocks(std::array<int, 3> cells) : mesh(MeshBuilder().add_hexes({.cells = cells}).build()) {
    blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, {ElasticLaw{{160e9, 80e9}}, 7800.0}));
  }
  NodeGraph graph() const { return {mesh.n_nodes(), mesh, blocks}; }
};

}  // namespace

TEST_CASE("neighbours are the nodes of the elements around", "[core][statics]") {
  const Blocks two({2, 1, 1});
  const NodeGraph graph = two.graph();
  std::size_t n_all = 0;
  for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
    const auto neighbours = graph.neighbours(node);
    CHECK(std::ranges::is_sorted(neighbours));
    CHECK(std::ranges::binary_search(neighbours, node));
    const bool is_shared = two.mesh.coordinates()(0, node) == 0.5;
    CHECK(neighbours.size() == (is_shared ? 12 : 8));
    n_all += neighbours.size();
  }
  CHECK(n_all == 4 * 12 + 8 * 8);
}

TEST_CASE("rigid elements have no stiffness to look for", "[core][statics]") {
  Blocks one({1, 1, 1});
  one.blocks[0].is_rigid = true;
  CHECK(one.graph().neighbours(0).empty());
  const NodeColours colours = colour_nodes(one.graph(), ColourDistance::one_element);
  CHECK(colours.n_colours == 0);
  CHECK(colours.colour == std::vector<std::uint32_t>(8, 0));
}

TEST_CASE("nodes of one colour do not disturb each other", "[core][statics]") {
  const Blocks many({4, 3, 5});
  const NodeGraph graph = many.graph();
  const NodeColours near = colour_nodes(graph, ColourDistance::one_element);
  const NodeColours far = colour_nodes(graph, ColourDistance::two_elements);
  CHECK(near.n_colours == 8);  // of a regular grid
  CHECK(far.n_colours >= 27);
  CHECK(far.n_colours <= 40);
  for (std::uint32_t node = 0; node < graph.n_nodes(); ++node) {
    std::multiset<std::uint32_t> colours_around;
    for (const std::uint32_t other : graph.neighbours(node)) {
      if (other != node) CHECK(near.colour[other] != near.colour[node]);
      colours_around.insert(far.colour[other]);
    }
    for (const std::uint32_t colour : colours_around) CHECK(colours_around.count(colour) == 1);
  }
}
