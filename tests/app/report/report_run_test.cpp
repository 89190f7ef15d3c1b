// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_run.hpp"

#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/report_region.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Results of a cube over two times, with a variable of this name at its element.
std::unique_ptr<const ReportMesh> drawn_results(const std::string& variable, const std::string& region) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.e");
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .name = "cube"}).build();
  write_exodus(path, mesh);
  ExodusEditor(path)
      .add_dimension("time_step", 0)
      .add_records("time_whole", {"time_step"}, {0, 1})
      .add_dimension("num_elem_var", 1)
      .add_texts("name_elem_var", "num_elem_var", {variable})
      .add_reals("vals_elem_var1eb1", {"time_step", "num_el_in_blk1"}, {1, 0});
  const SimulationDefinition deck = deck_of_region(region);
  return make_report_mesh(path, mesh, ReportRegion{deck, region_of(deck)});
}

const std::string dying = "begin element death\nblock = cube\ndeath on inversion = on\nend";

}  // namespace

TEST_CASE("a definition calls itself by its title, else by its name", "[app][report]") {
  SimulationDefinition definition;
  CHECK(title_of(definition) == "");
  definition.name.text = "drop test";
  CHECK(title_of(definition) == "drop test");
  definition.title = "A drop test";
  CHECK(title_of(definition) == "A drop test");
}

TEST_CASE("a mesh is drawn with what is stored about it", "[app][report]") {
  const auto made = drawn_results("heat", "");
  CHECK(made->stored.times == std::vector<double>{0.0, 1.0});
  CHECK(made->geometry.faces.size() == 6);
  REQUIRE(made->fields.fields.size() == 1);
  CHECK(made->fields.fields[0].name == "heat");
  CHECK(made->fields.fields[0].read(1) == std::vector<double>{0.0});
}

TEST_CASE("elements that die are hidden from then on, where results tell which do", "[app][report]") {
  const auto reported = drawn_results("death_status", dying);
  CHECK(reported->geometry.faces.at(0).hidden_from == OptionalIndex<std::uint32_t>{1});
  for (const std::string& sentence : reported->fields.not_found)
    CHECK_THAT(sentence, !Contains("death_status"));
  const auto unreported = drawn_results("heat", dying);
  CHECK_FALSE(unreported->geometry.faces.at(0).hidden_from);
  REQUIRE_FALSE(unreported->fields.not_found.empty());
  CHECK(unreported->fields.not_found.back() ==
        "Elements may die, but the results do not say which did, so dead ones are drawn too: output element "
        "death_status.");
}

TEST_CASE("a mesh of results that are gone is a file error", "[app][report]") {
  CHECK_THROWS_AS(make_report_mesh("/no/such/r.e", MeshBuilder().add_hexes({.id = 1}).build(), std::nullopt),
                  FileError);
}
