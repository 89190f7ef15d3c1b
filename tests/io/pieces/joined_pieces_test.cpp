// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/joined_pieces.hpp"

#include <cmath>

#include "io/exodus/exodus_variables.hpp"
#include "io/exodus/qa_records.hpp"
#include "io/exodus/run_records.hpp"
#include "io/exodus/sample_results.hpp"
#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("joined pieces are the mesh of before", "[io][pieces]") {
  const std::size_t n_pieces = GENERATE(1, 2, 3, 7, 16);
  const Mesh mesh = sample_mesh().build();
  check_same(SplitMesh(mesh, n_pieces).read(), mesh);
}

TEST_CASE("pieces of all formats and layouts are joined", "[io][pieces]") {
  const Mesh mesh = sample_mesh().build();
  for (const auto format :
       {FileFormat::cdf1, FileFormat::cdf5, FileFormat::netcdf4, FileFormat::netcdf4_classic})
    check_same(SplitMesh(mesh, 3, {.format = format}).read(), mesh);
  check_same(SplitMesh(mesh, 3, {.format = FileFormat::cdf5, .wide_integers = true}).read(), mesh);
  check_same(SplitMesh(mesh, 3, {.combined_coordinates = true}).read(), mesh);
  check_same(SplitMesh(mesh, 3, {.with_status = false}).read(), mesh);
}

TEST_CASE("nodes that two pieces have elsewhere are refused", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 2);
  const auto numbers = integers_of(mesh.piece(1), "node_num_map");
  const auto shared = integers_of(mesh.piece(1), "n_comm_nids").front();
  ExodusEditor(mesh.piece(1)).set_value("coordz", static_cast<std::size_t>(shared - 1), 0.25);
  CHECK(mesh.refusal() == "m.g.2.1: node " + std::to_string(numbers[static_cast<std::size_t>(shared - 1)]) +
                              " of the whole mesh: its coordz is 0.25, in another piece 0");
}

TEST_CASE("a variable that a piece lacks or has in another shape is refused", "[io][pieces]") {
  const SplitMesh lack(row_of_hexes().build(), 2);
  ExodusEditor(lack.piece(1)).rename_variable("coordy", "other");
  CHECK(lack.refusal() == "m.g.2.1: has no variable coordy, which other pieces have");
  const SplitMesh number(row_of_hexes().build(), 2);
  ExodusEditor(number.piece(1)).set_value("connect2", 5, 99);
  CHECK(number.refusal() == "m.g.2.1: variable connect2 holds 99, which is not in 1 to 20");
}

TEST_CASE("results, records and globals are read from pieces", "[io][pieces]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.e");
  SampleResults results(row_of_hexes().build());
  {
    ResultsWriter writer(path, results.mesh(), {"a title", {{"code", "1", "", ""}}, {"line 1", "line 2"}},
                         results.fields());
    for (int step = 0; step < 3; ++step) {
      results.set_step(step);
      writer.write_step(step, results.values());
    }
  }
  split_file(path, 5);
  const std::string pieces = name_pieces(path, 5).path(3);
  Diagnostics warnings;
  const Mesh mesh = read_mesh(pieces, warnings);
  CHECK(warnings.empty());
  const StoredVariables whole = read_stored_variables(path, results.mesh());
  const StoredVariables joined = read_stored_variables(pieces, mesh);
  CHECK(joined.times == whole.times);
  REQUIRE(joined.nodal.names == whole.nodal.names);
  REQUIRE(joined.element.names == whole.element.names);
  for (std::size_t time = 0; time < 3; ++time) {
    for (std::size_t v = 0; v < whole.nodal.names.size(); ++v)
      CHECK(joined.nodal.read(v, time) == whole.nodal.read(v, time));
    // eqps is in the last block alone: the others have none.
    CHECK(joined.element.read(0, time) == whole.element.read(0, time));
    const auto of_last = joined.element.read(6, time);
    CHECK(std::isnan(of_last[4]));
    CHECK(of_last[5] == whole.element.read(6, time)[5]);
  }
  CHECK(read_info_lines(pieces) == std::vector<std::string>{"line 1", "line 2"});
  CHECK(read_qa_records(pieces) == read_qa_records(path));
  CHECK(read_global_history(pieces).columns == read_global_history(path).columns);
}

TEST_CASE("rows of joined variables are read as of a file", "[io][pieces]") {
  const SplitMesh mesh(row_of_hexes().build(), 3);
  const ExodusFile file(mesh.base());
  const NetcdfVariable variable = file.find_variable("coordx").value();
  std::vector<double> some(4);
  file.read_double(variable, {3, 4}, some);
  const Mesh expected = row_of_hexes().build();
  for (std::uint32_t i = 0; i < 4; ++i) CHECK(some[i] == expected.coordinates()(0, 3 + i));
}
