// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/split_file.hpp"

#include <filesystem>

#include "io/decompose/join_file.hpp"
#include "io/exodus/sample_results.hpp"
#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

TEST_CASE("pieces are told and have the same bytes each time", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  write_exodus(path, sample_mesh().build());
  const std::vector<WrittenPiece> pieces = split_file(path, 3);
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[2].path == path + ".3.2");
  std::size_t n_elements = 0;
  std::vector<std::string> bytes;
  for (const WrittenPiece& piece : pieces) {
    n_elements += piece.n_elements;
    bytes.push_back(read_bytes(piece.path));
    std::filesystem::remove(piece.path);
  }
  CHECK(n_elements == sample_mesh().build().n_elements());
  split_file(path, 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(read_bytes(pieces[i].path) == bytes[i]);
}

TEST_CASE("no piece is written over", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  write_exodus(path, two_hexes().build());
  write_bytes(path + ".2.1", "kept");
  CHECK_THROWS_WITH(split_file(path, 2), Contains("m.g.2.1: is there already"));
  CHECK(read_bytes(path + ".2.1") == "kept");
  CHECK_FALSE(std::filesystem::exists(path + ".2.0"));
}

TEST_CASE("a file is divided among no more pieces than it has elements", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  write_exodus(path, two_hexes().build());
  CHECK_THROWS_WITH(split_file(path, 3), Contains("has 2 elements, which cannot be divided among 3 pieces"));
  CHECK_THROWS_WITH(split_file(path, 0), Contains("among 0 pieces"));
  CHECK(split_file(path, 2).size() == 2);
}

TEST_CASE("a file of nodes alone is one piece", "[io][decompose]") {
  MeshBuilder builder;
  builder.add_node({1, 2, 3});
  builder.add_node({4, 5, 6});
  const SplitMesh mesh(builder.build(), 1);
  CHECK(mesh.read().coordinates() == builder.build().coordinates());
}

TEST_CASE("what cannot be divided is refused", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  write_exodus(path, two_hexes().build());
  ExodusEditor(path).add_dimension("num_fa_blk", 2);
  CHECK_THROWS_WITH(split_file(path, 2), Contains("has 2 face blocks, which cannot be divided"));
  const std::string factors = directory.file("f.g");
  write_exodus(factors, two_hexes().build());
  ExodusEditor(factors).add_dimension("num_df_ss1", 3).add_reals("dist_fact_ss1", {"num_df_ss1"}, {1, 2, 3});
  CHECK_THROWS_WITH(split_file(factors, 2),
                    Contains("side set number 1: 3 distribution factors cannot be divided among 2 sides"));
}

TEST_CASE("element sets are divided in their order", "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g");
  write_exodus(path, row_of_hexes().build());
  ExodusEditor(path)
      .add_dimension("num_elem_sets", 1)
      .add_integers("els_prop1", {"num_elem_sets"}, {5})
      .add_dimension("num_ele_els1", 4)
      .add_integers("elem_els1", {"num_ele_els1"}, {7, 2, 2, 5})
      .add_dimension("num_df_els1", 4)
      .add_reals("dist_fact_els1", {"num_df_els1"}, {1, 2, 3, 4});
  split_file(path, 3);
  join_file(path + ".3.0", directory.file("j.g"));
  CHECK(integers_of(directory.file("j.g"), "elem_els1") == std::vector<std::int64_t>{7, 2, 2, 5});
  CHECK(integers_of(directory.file("j.g"), "dist_fact_els1") == std::vector<std::int64_t>{1, 2, 3, 4});
}

TEST_CASE("pieces are divided anew", "[io][decompose]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  const std::vector<WrittenPiece> pieces = split_file(mesh.piece(1), 5);
  CHECK(pieces[0].path == mesh.base() + ".5.0");
  Diagnostics warnings;
  check_same(read_mesh(pieces[4].path, warnings), row_of_hexes().build());
}

// Written here and looked at by pieces_in_vtk.py, which CTest runs afterwards where VTK is installed.
TEST_CASE("pieces for VTK to read", "[.][vtk]") {
  const std::string path = std::string(CONTACTSIM_BINARY_DIR) + "/pieces_for_vtk.e";
  for (int piece = 0; piece < 3; ++piece) std::filesystem::remove(path + ".3." + std::to_string(piece));
  // Each reader of VTK has its own order of bars and particles: solids and shells are compared.
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "lower", .cells = {3, 3, 2}})
      .add_tets({.id = 7, .name = "upper", .origin = {0, 0, 1}})
      .add_shells({.id = 3, .name = "skin", .cells = {2, 2}, .origin = {0, 0, 3}});
  std::vector<std::int64_t> ids(builder.build().n_nodes());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int64_t>(1000 - 3 * i);
  builder.set_node_ids(ids);
  SampleResults results(builder.build());
  {
    ResultsWriter writer(path, results.mesh(), {"for VTK", {}, {}}, results.fields());
    results.set_step(1);
    writer.write_step(0.5, results.values());
  }
  CHECK(split_file(path, 3).size() == 3);
}
