// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/open_pieces.hpp"

#include <filesystem>

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a piece that is missing is named", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 4);
  std::filesystem::remove(mesh.piece(2));
  CHECK(mesh.refusal() == "m.g.4.2: there is no such file; it is one of the 4 pieces of m.g");
}

TEST_CASE("pieces of another mesh or decomposition are refused", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  CHECK(mesh.refusal() == "");
  MeshBuilder longer = row_of_hexes();
  longer.add_hexes({.id = 3, .origin = {8, 0, 0}});
  const SplitMesh other(longer.build(), 2);
  std::filesystem::copy_file(other.piece(1), mesh.piece(1),
                             std::filesystem::copy_options::overwrite_existing);
  CHECK(mesh.refusal() ==
        "m.g.2.1: is a piece of another file than m.g.2.0: num_nodes_global is 40, there 36");
  const SplitMesh finer(row_of_hexes().build(), 4);
  std::filesystem::copy_file(finer.piece(1), mesh.piece(1),
                             std::filesystem::copy_options::overwrite_existing);
  CHECK(mesh.refusal() == "m.g.2.1: is one of 4 pieces, but its name says one of 2");
}

TEST_CASE("pieces with other blocks or times are refused", "[io][pieces]") {
  const SplitMesh blocks(row_of_hexes().build(), 2);
  ExodusEditor(blocks.piece(1)).set_value("eb_prop1", 1, 5);
  CHECK(blocks.refusal() ==
        "m.g.2.1: is a piece of another file than m.g.2.0: the ids of its blocks are others");
  const SplitMesh times(row_of_hexes().build(), 2);
  for (const std::size_t piece : {0u, 1u}) {
    ExodusEditor file(times.piece(piece));
    file.add_dimension("time_step", 2).add_reals("time_whole", {"time_step"}, {0.0, piece == 0 ? 1.0 : 2.0});
  }
  CHECK(times.refusal() == "m.g.2.1: is a piece of another file than m.g.2.0: its times are others");
  const SplitMesh fewer(row_of_hexes().build(), 2);
  ExodusEditor(fewer.piece(0)).add_dimension("time_step", 1).add_reals("time_whole", {"time_step"}, {0.0});
  CHECK(fewer.refusal() == "m.g.2.1: is a piece of another file than m.g.2.0: its times are others");
}

TEST_CASE("a piece that does not say what the whole is, is refused", "[io][pieces]") {
  const SplitMesh nodes(row_of_hexes().build(), 2);
  ExodusEditor(nodes.piece(0)).rename_dimension("num_nodes_global", "n");
  CHECK(
      nodes.refusal() ==
      "m.g.2.0: is named as a piece, but does not say how many nodes the whole mesh has (num_nodes_global)");
  const SplitMesh elements(row_of_hexes().build(), 2);
  ExodusEditor(elements.piece(1)).rename_dimension("num_elems_global", "n");
  CHECK(elements.refusal() ==
        "m.g.2.1: is named as a piece, but does not say how many elements the whole "
        "mesh has (num_elems_global)");
}

TEST_CASE("files that were never pieces are refused when they stand as such", "[io][pieces]") {
  const TemporaryDirectory directory;
  for (const char* name : {"m.g.2.0", "m.g.2.1"}) write_exodus(directory.file(name), two_hexes().build());
  Diagnostics warnings;
  CHECK_THROWS_WITH(read_mesh(directory.file("m.g"), warnings),
                    Catch::Matchers::Contains("m.g.2.0: is named as a piece, but does not say"));
}
