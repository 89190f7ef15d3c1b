// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/divided_axis.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("dimensions that pieces differ in are known by their names", "[io][pieces]") {
  CHECK(find_divided("num_nodes")->kind == DividedKind::node);
  CHECK(find_divided("num_el_in_blk12")->kind == DividedKind::block);
  CHECK(find_divided("num_el_in_blk12")->number == 12);
  CHECK(find_divided("num_df_ss3")->kind == DividedKind::side_factor);
  for (const char* other : {"num_el_blk", "num_nod_var", "num_nodes_global", "num_el_in_blk", "num_side_ssx"})
    CHECK_FALSE(find_divided(other));
}

TEST_CASE("numbers of nodes and elements are known by their variables", "[io][pieces]") {
  CHECK(dimension_of_numbers("connect1") == "num_nodes");
  CHECK(dimension_of_numbers("node_ns2") == "num_nodes");
  CHECK(dimension_of_numbers("elem_ss10") == "num_elem");
  CHECK(dimension_of_numbers("elem_els1") == "num_elem");
  for (const char* other : {"connect", "side_ss1", "node_num_map", "node_ns_order1", "attrib1"})
    CHECK(dimension_of_numbers(other).empty());
}

TEST_CASE("what only describes a decomposition is known", "[io][pieces]") {
  for (const char* own : {"num_processors", "n_comm_nids", "node_mapi", "side_ss_order3"})
    CHECK(describes_decomposition(own));
  for (const char* other : {"num_nodes", "node_map1", "elem_map", "node_ns1"})
    CHECK_FALSE(describes_decomposition(other));
}

TEST_CASE("items go to their places and come from them in any dimension", "[io][pieces]") {
  // Two rows of four items of two values; the piece has the items 3 and 1.
  const std::vector<int> whole{0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 12, 13, 14, 15, 16, 17};
  const std::vector<std::uint32_t> positions{3, 1};
  const AxisPlace place{2, 4, 2};
  const std::vector<int> part = gather<int>(whole, positions, place);
  CHECK(part == std::vector<int>{6, 7, 2, 3, 16, 17, 12, 13});
  std::vector<int> put(whole.size(), -1);
  scatter<int>(part, positions, place, put);
  CHECK(put == std::vector<int>{-1, -1, 2, 3, -1, -1, 6, 7, -1, -1, 12, 13, -1, -1, 16, 17});
}
