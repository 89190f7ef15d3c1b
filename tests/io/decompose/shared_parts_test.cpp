// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/shared_parts.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Numbers = std::vector<std::int64_t>;

TEST_CASE("a piece says what the whole has", "[io][decompose]") {
  const SplitMesh mesh(row_of_hexes().build(), 3);
  const std::string path = mesh.piece(1);
  const NetcdfFile piece(path);
  CHECK(piece.dimension("num_processors") == 3);
  CHECK(piece.dimension("num_procs_file") == 1);
  CHECK(piece.dimension("num_nodes_global") == 36);
  CHECK(piece.dimension("num_elems_global") == 8);
  CHECK(integers_of(path, "nem_ftype") == Numbers{0});
  CHECK(integers_of(path, "el_blk_ids_global") == Numbers{1, 2});
  CHECK(integers_of(path, "el_blk_cnt_global") == Numbers{5, 3});
  CHECK(integers_of(path, "ns_node_cnt_global") == Numbers{18});
  CHECK(integers_of(path, "ss_side_cnt_global") == Numbers{8});
  CHECK(integers_of(path, "ss_df_cnt_global") == Numbers{0});
  CHECK(piece.find_global_number("processor_info") == 3);
  CHECK(piece.find_global_number("nemesis_file_version").value() == Approx(2.6));
}

TEST_CASE("what is at other pieces and what is not is all of a piece", "[io][decompose]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  const std::string path = mesh.piece(0);
  CHECK(integers_of(path, "elem_mapi") == Numbers{1, 2, 3});
  CHECK(integers_of(path, "elem_mapb") == Numbers{4});
  Numbers nodes = integers_of(path, "node_mapi");
  CHECK(nodes.size() == 16);
  const Numbers border = integers_of(path, "node_mapb");
  nodes.insert(nodes.end(), border.begin(), border.end());
  std::ranges::sort(nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) CHECK(nodes[i] == static_cast<std::int64_t>(i + 1));
  CHECK(integers_of(path, "int_n_stat") == Numbers{1});
  CHECK(integers_of(path, "ext_n_stat") == Numbers{0});
  CHECK(integers_of(path, "n_comm_nids") == border);
  CHECK(integers_of(path, "n_comm_proc") == Numbers{1, 1, 1, 1});
  CHECK(integers_of(path, "n_comm_data_idx") == Numbers{4});
  CHECK(integers_of(path, "e_comm_eids") == Numbers{4});
  CHECK(integers_of(path, "e_comm_sids") == Numbers{2});
  CHECK(integers_of(path, "e_comm_proc") == Numbers{1});
}

TEST_CASE("pieces agree on what they share", "[io][decompose]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {4, 4, 4}});
  constexpr std::size_t n_pieces = 7;
  const SplitMesh mesh(builder.build(), n_pieces);
  // Of each two pieces, the nodes of the whole that one says it shares with the other.
  std::map<std::pair<std::int64_t, std::int64_t>, std::set<std::int64_t>> shared;
  for (std::size_t p = 0; p < n_pieces; ++p) {
    const Numbers whole = integers_of(mesh.piece(p), "node_num_map");
    const Numbers nodes = integers_of(mesh.piece(p), "n_comm_nids");
    const Numbers others = integers_of(mesh.piece(p), "n_comm_proc");
    for (std::size_t i = 0; i < nodes.size(); ++i)
      shared[{static_cast<std::int64_t>(p), others[i]}].insert(whole[static_cast<std::size_t>(nodes[i] - 1)]);
  }
  for (const auto& [pair, nodes] : shared) CHECK(nodes == shared[{pair.second, pair.first}]);
  CHECK(shared.size() >= 2 * (n_pieces - 1));
}
