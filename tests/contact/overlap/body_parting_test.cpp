// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/body_parting.hpp"

#include "support/catch.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::OverlappingBodies;

namespace {

/// Plain blocks of unit cells, each lowered into the one below it by a depth.
test::MeshBuilder stacked(std::vector<double> depths) {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 3}, .size = {4, 4, 3}});
  double top = 3.0;
  std::int64_t id = 2;
  for (const double depth : depths) {
    b.add_hexes({.id = id++,
                 .cells = {2, 2, 3},
                 .origin = {1, 1, top - depth},
                 .size = {2, 2, 3},
                 .share_nodes = false});
    top += 3.0 - depth;
  }
  return b;
}

std::vector<BodyMove> moves_of(const OverlappingBodies& bodies, std::span<const std::uint8_t> is_held = {}) {
  return BodyParting(bodies.model, bodies.mesh, bodies.parts)
      .find_moves(bodies.points.coordinates(), bodies.points.renewed(), is_held);
}

}  // namespace

TEST_CASE("bodies that are deep in each other go half the way each", "[contact][overlap]") {
  const OverlappingBodies blocks(stacked({0.8}));
  const std::vector<BodyMove> moves = moves_of(blocks);
  REQUIRE(moves.size() == 2);
  CHECK(moves[0].body == 0);
  CHECK(moves[0].way.isApprox(Vector3d(0, 0, -0.4)));
  CHECK(moves[1].body == 100);  // after the 5 x 5 x 4 nodes of the lower one
  CHECK(moves[1].way.isApprox(Vector3d(0, 0, 0.4)));
  CHECK(moves[1].depth == Approx(0.8));
  CHECK(moves[1].pair == PairIndex{0});
  const BodyParting parting(blocks.model, blocks.mesh, blocks.parts);
  CHECK(parting.nodes_of(0).size() == 100);
  CHECK(parting.nodes_of(100).size() == 36);
  CHECK(parting.nodes_of(100).front() == NodeIndex{100});
  CHECK(parting.nodes_of(1).empty());  // no body's first node
}

TEST_CASE("what is no deeper than half an element moves no body", "[contact][overlap]") {
  CHECK(moves_of(OverlappingBodies(stacked({0.4}))).empty());
  CHECK(moves_of(OverlappingBodies(stacked({-0.4}))).empty());
}

TEST_CASE("a body with a node that is held stays, and the other one goes all the way", "[contact][overlap]") {
  const OverlappingBodies blocks(stacked({0.8}));
  std::vector<std::uint8_t> is_held(blocks.mesh.n_nodes(), 0);
  is_held[3] = GENERATE(held_fully, held_in_part);
  const std::vector<BodyMove> moves = moves_of(blocks, is_held);
  REQUIRE(moves.size() == 1);
  CHECK(moves[0].body == 100);
  CHECK(moves[0].way.isApprox(Vector3d(0, 0, 0.8)));
  is_held[120] = held_in_part;
  CHECK(moves_of(blocks, is_held).empty());
}

TEST_CASE("overlap that is deeper than the pair says stays", "[contact][overlap]") {
  const auto lines = [](const std::string& tolerance) {
    return test::general_contact("overlap normal tolerance = " + tolerance + "\n");
  };
  CHECK(moves_of(OverlappingBodies(stacked({0.8}), lines("0.75"))).empty());
  CHECK(moves_of(OverlappingBodies(stacked({0.8}), lines("0.85"))).size() == 2);
}

TEST_CASE("a body goes once in a pass", "[contact][overlap]") {
  const OverlappingBodies blocks(stacked({0.8, 0.7}));
  const std::vector<BodyMove> moves = moves_of(blocks);
  REQUIRE(moves.size() == 2);  // of the first pair; the third body waits
  CHECK(moves[0].body == 0);
  CHECK(moves[1].body == 100);
}

TEST_CASE("nodes that are deep are those that find_deep() lists", "[contact][overlap]") {
  const OverlappingBodies blocks(stacked({0.8}));
  const BodyParting parting(blocks.model, blocks.mesh, blocks.parts);
  for (const DeepOverlap& overlap : parting.find_deep(blocks.points.coordinates(), blocks.points.renewed())) {
    CHECK(overlap.is_deep);
    CHECK(overlap.depth > 0.5);
  }
  CHECK(parting.find_deep(blocks.points.coordinates(), blocks.points.renewed()).size() >= 9);
}
