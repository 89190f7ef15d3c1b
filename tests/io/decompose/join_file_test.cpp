// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/join_file.hpp"

#include <filesystem>

#include "io/exodus/sample_results.hpp"
#include "io/netcdf/read_layout.hpp"
#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Requires that two files define the same variables with the same values.
void check_same_variables(const std::string& found, const std::string& expected) {
  const ExodusFile a(found), b(expected);
  const NetcdfLayout of_a = a.layout(), of_b = b.layout();
  CHECK(of_a.variables.size() == of_b.variables.size());
  for (const NetcdfDefinition& variable : of_b.variables) {
    INFO(variable.name);
    const auto there = a.find_variable(variable.name);
    REQUIRE(there);
    const NetcdfDefinition& definition = *of_a.find_variable(variable.name);
    CHECK(definition.type == variable.type);
    CHECK(definition.dimensions == variable.dimensions);
    CHECK(definition.attributes.size() == variable.attributes.size());
    const NetcdfVariable here = b.find_variable(variable.name).value();
    REQUIRE(there->shape == here.shape);
    const Rows all{0, here.shape.empty() ? 1 : here.shape[0]};
    CHECK(a.read_values(*there, variable.type, all) == b.read_values(here, variable.type, all));
  }
}

}  // namespace

TEST_CASE("split and joined, every variable is as before", "[io][decompose]") {
  const std::size_t n_pieces = GENERATE(1, 2, 5, 16);
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.e");
  SampleResults results(sample_mesh().build());
  {
    ResultsWriter writer(path, results.mesh(), {"title", {{"code", "1", "", ""}}, {"deck"}},
                         results.fields());
    for (int step = 0; step < 2; ++step) {
      results.set_step(step);
      writer.write_step(step, results.values());
    }
  }
  split_file(path, n_pieces);
  const JoinedFile joined = join_file(name_pieces(path, n_pieces).path(0), directory.file("j.e"));
  CHECK(joined.n_pieces == n_pieces);
  CHECK(joined.n_nodes == results.mesh().n_nodes());
  CHECK(joined.n_steps == 2);
  check_same_variables(directory.file("j.e"), path);
}

TEST_CASE("reals of single precision and wide integers keep their types", "[io][decompose]") {
  const TemporaryDirectory directory;
  for (const ExodusLayout& layout : {ExodusLayout{.single_precision = true},
                                     ExodusLayout{.format = FileFormat::cdf5, .wide_integers = true},
                                     ExodusLayout{.combined_coordinates = true}}) {
    const std::string path = directory.file("m.g");
    write_exodus(path, sample_mesh().build(), layout);
    split_file(path, 3);
    join_file(path + ".3.0", directory.file("j.g"));
    check_same_variables(directory.file("j.g"), path);
    for (int piece = 0; piece < 3; ++piece) std::filesystem::remove(path + ".3." + std::to_string(piece));
  }
}

TEST_CASE("the file takes the name of its pieces, if that is free", "[io][decompose]") {
  const SplitMesh mesh(two_hexes().build(), 2);
  CHECK(join_file(mesh.base(), {}).path == mesh.base());
  CHECK(std::filesystem::exists(mesh.base()));
  const std::string bytes = read_bytes(mesh.base());
  CHECK_THROWS_WITH(join_file(mesh.piece(0), {}), Contains("m.g: is there already"));
  CHECK(read_bytes(mesh.base()) == bytes);
  CHECK_THROWS_WITH(join_file(mesh.piece(0), mesh.piece(1)), Contains("would overwrite"));
  CHECK(join_file(mesh.piece(0), mesh.base() + ".other").n_elements == 2);
}

TEST_CASE("a whole file is not joined", "[io][decompose]") {
  const TemporaryDirectory directory;
  write_exodus(directory.file("m.g"), two_hexes().build());
  CHECK_THROWS_WITH(join_file(directory.file("m.g"), {}), Contains("is no piece of a decomposed file"));
  CHECK_THROWS_WITH(join_file(directory.file("none.g"), {}), Contains("no such file"));
}
