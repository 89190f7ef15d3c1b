// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/piece_layout.hpp"

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Numbers = std::vector<std::int64_t>;

TEST_CASE("maps of a piece hold numbers of the whole, a further one the ids", "[io][decompose]") {
  MeshBuilder builder = row_of_hexes();
  builder.set_element_ids({80, 70, 60, 50, 40, 30, 20, 10});
  const SplitMesh mesh(builder.build(), 2);
  const NetcdfFile piece(mesh.piece(1));
  CHECK(integers_of(mesh.piece(1), "elem_num_map") == Numbers{5, 6, 7, 8});
  CHECK(integers_of(mesh.piece(1), "elem_map1") == Numbers{40, 30, 20, 10});
  CHECK(integers_of(mesh.piece(1), "em_prop1") == Numbers{1});
  CHECK(piece.read_texts(piece.find_variable("emap_names").value()) ==
        std::vector<std::string>{"original_global_id_map"});
  CHECK_FALSE(piece.find_variable("nmap_names"));
}

TEST_CASE("further maps of the file stay, and the ids come behind them", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  MeshBuilder builder = row_of_hexes();
  builder.set_element_ids({8, 7, 6, 5, 4, 3, 2, 1});
  write_exodus(path, builder.build());
  ExodusEditor(path)
      .add_dimension("num_elem_maps", 1)
      .add_integers("em_prop1", {"num_elem_maps"}, {17})
      .add_texts("emap_names", "num_elem_maps", {"mine"})
      .add_integers("elem_map1", {"num_elem"}, {1, 2, 3, 4, 5, 6, 7, 80});
  split_file(path, 2);
  const std::string piece = name_pieces(path, 2).path(1);
  CHECK(integers_of(piece, "em_prop1") == Numbers{17, 18});
  CHECK(integers_of(piece, "elem_map1") == Numbers{5, 6, 7, 80});
  CHECK(integers_of(piece, "elem_map2") == Numbers{4, 3, 2, 1});
  const ExodusFile joined(piece);
  CHECK(joined.dimension("num_elem_maps") == 1);
  CHECK(joined.read_texts(joined.find_variable("emap_names").value()) == std::vector<std::string>{"mine"});
  CHECK_FALSE(joined.find_variable("elem_map2"));
}

TEST_CASE("a short name leaves room for that of the further map", "[io][decompose]") {
  MeshBuilder builder = two_hexes();
  builder.set_node_ids({12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1});
  const SplitMesh mesh(builder.build(), 2, {.name_length = 8});
  check_same(mesh.read(), builder.build());
}

TEST_CASE("blocks and sets that a piece has nothing of are empty", "[io][decompose]") {
  MeshBuilder builder = row_of_hexes();
  builder.set_attributes(2, {"a"}, {1, 2, 3});
  const SplitMesh mesh(builder.build(), 4);
  const NetcdfFile piece(mesh.piece(0));
  CHECK(integers_of(mesh.piece(0), "eb_status") == Numbers{1, 0});
  for (const char* name : {"num_el_in_blk2", "num_nod_per_el2", "num_att_in_blk2"})
    CHECK(piece.dimension(name) == 0);
  CHECK_FALSE(piece.find_variable("connect2"));
  CHECK_FALSE(piece.find_variable("attrib2"));
  check_same(mesh.read(), builder.build());
}

TEST_CASE("the processing order of elements survives and is none of a piece", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  write_exodus(path, row_of_hexes().build());
  ExodusEditor(path).add_integers("elem_map", {"num_elem"}, {8, 7, 6, 5, 4, 3, 2, 1});
  split_file(path, 3);
  const std::string piece = name_pieces(path, 3).path(0);
  CHECK_FALSE(NetcdfFile(piece).find_variable("elem_map"));
  const ExodusFile joined(piece);
  Numbers order(8);
  joined.read_int64(joined.find_variable("elem_map").value(), order);
  CHECK(order == Numbers{8, 7, 6, 5, 4, 3, 2, 1});
}
