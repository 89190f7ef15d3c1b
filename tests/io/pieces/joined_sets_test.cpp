// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/joined_sets.hpp"

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// row_of_hexes with sets in an order of their own, with repetitions and factors.
Mesh with_odd_sets() {
  MeshBuilder builder = row_of_hexes();
  builder.add_side_set(2, "odd", std::vector<ElementSide>{{{7}, 2}, {{0}, 6}, {{7}, 2}, {{3}, 1}});
  builder.add_node_set(2, "odd", std::vector<std::uint32_t>{35, 0, 4, 0, 17});
  MeshParts parts = builder.parts();
  for (int i = 0; i < 16; ++i) parts.side_sets[1].distribution_factors.push_back(0.5 * i);
  for (int i = 0; i < 5; ++i) parts.node_sets[1].distribution_factors.push_back(10.0 + i);
  return Mesh(std::move(parts));
}

}  // namespace

TEST_CASE("sets keep their order, repetitions and factors", "[io][pieces]") {
  const std::size_t n_pieces = GENERATE(1, 2, 3, 8);
  const SplitMesh mesh(with_odd_sets(), n_pieces);
  const Mesh joined = mesh.read();
  check_same(joined, with_odd_sets());
  CHECK(joined.node_sets()[1].distribution_factors == std::vector<double>{10, 11, 12, 13, 14});
}

TEST_CASE("sets of pieces that tell no order are in that of elements and nodes", "[io][pieces]") {
  const SplitMesh mesh(with_odd_sets(), 2);
  for (const std::size_t piece : {0u, 1u}) {
    ExodusEditor(mesh.piece(piece))
        .rename_variable("side_ss_order2", "a")
        .rename_variable("node_ns_order2", "b");
  }
  const Mesh joined = mesh.read();
  CHECK(joined.side_sets()[1].sides == std::vector<ElementSide>{{{0}, 6}, {{3}, 1}, {{7}, 2}, {{7}, 2}});
  CHECK(joined.side_sets()[1].distribution_factors ==
        std::vector<double>{2, 2.5, 3, 3.5, 6, 6.5, 7, 7.5, 0, 0.5, 1, 1.5, 4, 4.5, 5, 5.5});
  CHECK(joined.node_sets()[1].nodes == std::vector<NodeIndex>{{0}, {4}, {17}, {35}});
}

TEST_CASE("orders and members that do not match are refused", "[io][pieces]") {
  const SplitMesh order(with_odd_sets(), 2);
  ExodusEditor(order.piece(0)).rename_variable("side_ss_order2", "a");
  CHECK(order.refusal() ==
        "m.g.2.0: side set number 2: does not say where its entries stand in the whole set, "
        "as other pieces do");
  const SplitMesh gap(with_odd_sets(), 2);
  ExodusEditor(gap.piece(0)).set_value("side_ss_order2", 0, 1);
  CHECK(gap.refusal() == "m.g.2.0: side set number 2: entries of the whole set are in no piece");
  const SplitMesh far(with_odd_sets(), 2);
  ExodusEditor(far.piece(1)).set_value("side_ss_order2", 0, 2e9);
  CHECK(far.refusal() == "m.g.2.0: side set number 2: entries of the whole set are in no piece");
  const SplitMesh member(row_of_hexes().build(), 2);
  ExodusEditor(member.piece(1)).set_value("elem_ss1", 2, 5);
  CHECK(member.refusal() == "m.g.2.1: side set number 1: entry 3 is 5, which is not in 1 to 4");
  const SplitMesh node(row_of_hexes().build(), 2);
  ExodusEditor(node.piece(0)).set_value("node_ns1", 0, 0);
  CHECK(node.refusal() == "m.g.2.0: node set number 1: entry 1 is 0, which is not in 1 to 20");
}

TEST_CASE("factors that match no sides are refused", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  ExodusEditor(mesh.piece(1))
      .add_dimension("num_df_ss1", 3)
      .add_reals("dist_fact_ss1", {"num_df_ss1"}, {1.0, 1.0, 1.0});
  CHECK(mesh.refusal() == "m.g.2.1: side set number 1: 3 distribution factors do not match its 4 sides");
}
