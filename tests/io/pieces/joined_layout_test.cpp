// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/joined_layout.hpp"

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("the whole has no trace of its pieces", "[io][pieces]") {
  MeshBuilder builder = row_of_hexes();
  builder.set_element_ids({8, 7, 6, 5, 4, 3, 2, 1});
  const SplitMesh mesh(builder.build(), 3);
  const NetcdfLayout layout = ExodusFile(mesh.base()).layout();
  CHECK(layout.length("num_nodes") == 36);
  CHECK(layout.length("num_el_in_blk2") == 3);
  CHECK(layout.find_variable("elem_num_map") != nullptr);
  // The file had none.
  CHECK(layout.find_variable("node_num_map") == nullptr);
  for (const char* name : {"num_processors", "num_nodes_global", "num_elem_maps", "num_n_cmaps"})
    CHECK(layout.find_dimension(name) == nullptr);
  for (const char* name : {"elem_map1", "emap_names", "em_prop1", "node_mapi", "nem_ftype", "n_comm_nids"})
    CHECK(layout.find_variable(name) == nullptr);
  for (const char* name : {"processor_info", "nemesis_api_version", "nemesis_file_version"})
    CHECK(find_attribute(layout.attributes, name) == nullptr);
}

TEST_CASE("pieces that differ in what an element has are refused", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  for (const std::size_t piece : {0u, 1u})
    ExodusEditor(mesh.piece(piece)).add_dimension("num_att_in_blk1", piece + 1);
  CHECK(mesh.refusal() == "m.g.2.1: does not go with m.g.2.0: num_att_in_blk1 is 2, there 1");
}

TEST_CASE("a block is empty only where it is in all pieces", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 8);
  CHECK(integers_of(mesh.piece(0), "eb_status") == std::vector<std::int64_t>{1, 0});
  CHECK(integers_of(mesh.piece(7), "eb_status") == std::vector<std::int64_t>{0, 1});
  const ExodusFile file(mesh.base());
  std::vector<std::int64_t> status(2);
  file.read_int64(file.find_variable("eb_status").value(), status);
  CHECK(status == std::vector<std::int64_t>{1, 1});
}
