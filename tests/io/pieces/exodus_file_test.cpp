// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/exodus_file.hpp"

#include <filesystem>

#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a file and its pieces are read alike", "[io][pieces]") {
  const Mesh mesh = sample_mesh().build();
  const TemporaryDirectory directory;
  write_exodus(directory.file("m.g"), mesh);
  const SplitMesh split(mesh, 3);
  const ExodusFile whole(directory.file("m.g")), joined(split.piece(1));
  CHECK_FALSE(whole.n_pieces());
  CHECK(joined.n_pieces() == 3);
  CHECK(joined.path() == split.piece(0));
  for (const char* name : {"num_dim", "num_nodes", "num_elem", "num_el_blk", "num_att_in_blk4", "no_such"})
    CHECK(joined.dimension(name) == whole.dimension(name));
  CHECK(joined.variable_names("assembly_entity") == whole.variable_names("assembly_entity"));
  CHECK(joined.n_groups() == 0);
  CHECK(joined.find_global_number("version") == whole.find_global_number("version"));
  CHECK_FALSE(joined.find_global_number("title"));
  CHECK(joined.find_global_text("title") == whole.find_global_text("title"));
  const NetcdfVariable connectivity = joined.find_variable("connect1").value();
  CHECK(connectivity.shape == whole.find_variable("connect1")->shape);
  CHECK(joined.find_text(connectivity, "elem_type") == "HEX8");
  CHECK_FALSE(joined.find_text(connectivity, "other"));
  CHECK(joined.read_texts(joined.find_variable("eb_names").value()) ==
        whole.read_texts(whole.find_variable("eb_names").value()));
  std::vector<std::int32_t> numbers(connectivity.size());
  CHECK(joined.read_int32(connectivity, {0, connectivity.shape[0]}, numbers));
  CHECK(numbers[7] == static_cast<std::int32_t>(mesh.blocks()[0].nodes[7].value) + 1);
  CHECK_FALSE(joined.find_variable("no_such"));
}

TEST_CASE("values of every type are read from files and pieces", "[io][pieces]") {
  const TemporaryDirectory directory;
  write_exodus(directory.file("m.g"), two_hexes().build());
  const SplitMesh split(two_hexes().build(), 2);
  const ExodusFile whole(directory.file("m.g")), joined(split.base());
  for (const auto& [name, type] : {std::pair("eb_names", NetcdfType::text),
                                   {"connect2", NetcdfType::int32},
                                   {"coordy", NetcdfType::float64}}) {
    const NetcdfVariable of_whole = whole.find_variable(name).value();
    const Rows all{0, of_whole.shape[0]};
    CHECK(joined.read_values(joined.find_variable(name).value(), type, all) ==
          whole.read_values(of_whole, type, all));
  }
}

TEST_CASE("one file that is named like a piece is whole unless it says otherwise", "[io][pieces]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("m.g.8.0");
  write_exodus(path, two_hexes().build());
  CHECK_FALSE(find_pieces(path));
  CHECK_FALSE(ExodusFile(path).n_pieces());
  ExodusEditor(path).add_dimension("num_processors", 8);
  CHECK(find_pieces(path)->count == 8);
}
