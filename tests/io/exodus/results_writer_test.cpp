// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_writer.hpp"

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "core/base/errors.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "io/exodus/sample_results.hpp"
#include "io/netcdf/netcdf_file.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

// What a results file says for a mesh: everything has a name.
Mesh with_names(const Mesh& mesh, MeshParts parts) {
  for (std::uint32_t i = 0; i < parts.blocks.size(); ++i)
    parts.blocks[i].name = mesh.name({EntityKind::block, i});
  for (std::uint32_t i = 0; i < parts.side_sets.size(); ++i)
    parts.side_sets[i].name = mesh.name({EntityKind::side_set, i});
  for (std::uint32_t i = 0; i < parts.node_sets.size(); ++i)
    parts.node_sets[i].name = mesh.name({EntityKind::node_set, i});
  return Mesh(std::move(parts));
}

Mesh write_and_read(const Mesh& mesh, const ResultsText& text = {}) {
  const TemporaryDirectory directory;
  ResultsWriter(directory.file("r.e"), mesh, text, {});
  Diagnostics warnings;
  Mesh found = read_mesh(directory.file("r.e"), warnings);
  CHECK(warnings.empty());
  return found;
}

Names texts(const NetcdfFile& file, const std::string& variable) {
  const auto found = file.find_variable(variable);
  return found ? file.read_texts(*found) : Names{};
}

}  // namespace

TEST_CASE("the mesh of a results file is the mesh of the run", "[io][results]") {
  MeshParts parts = sample_mesh().parts();
  parts.title = "plate";
  parts.side_sets[0].distribution_factors.assign(parts.side_sets[0].sides.size(), 0.5);
  parts.node_sets[0].distribution_factors.assign(parts.node_sets[0].nodes.size(), 0.25);
  const Mesh mesh(parts);
  const Mesh found = write_and_read(mesh, {"plate", {}, {}});
  check_same(found, with_names(mesh, parts));
  CHECK(found.node_sets()[0].distribution_factors == parts.node_sets[0].distribution_factors);
}

TEST_CASE("a mesh without anything is a legal results file", "[io][results]") {
  const Mesh found = write_and_read(Mesh());
  CHECK(found.n_nodes() == 0);
  CHECK(found.blocks().empty());
}

TEST_CASE("ids beyond 32 bits survive", "[io][results]") {
  const std::int64_t large = std::int64_t{1} << 40;
  MeshParts parts = two_hexes().parts();
  parts.blocks[1].id = large + 1;
  parts.node_sets[0].id = large + 2;
  parts.element_ids = {large, 7};
  parts.assemblies = {{large + 3, "all", EntityKind::block, {1, 0}}};
  const Mesh mesh(parts);
  check_same(write_and_read(mesh), with_names(mesh, parts));
}

TEST_CASE("long names survive", "[io][results]") {
  const std::string long_name = "the_stress_in_the_third_bolt_of_the_second_flange";
  MeshParts parts = two_hexes().parts();
  parts.blocks[0].name = long_name;
  const TemporaryDirectory directory;
  const std::vector<OutputField> fields{{long_name, FieldLocation::node, FieldShape::symmetric_tensor, 6}};
  ResultsWriter(directory.file("r.e"), Mesh(parts), {}, fields);
  const NetcdfFile file(directory.file("r.e"));
  CHECK(texts(file, "name_nod_var")[5] == long_name + "_zx");
  CHECK(texts(file, "eb_names")[0] == long_name);
  CHECK(file.find_global_number("maximum_name_length") == static_cast<double>(long_name.size() + 3));
}

TEST_CASE("a results file tells of the programs and the deck", "[io][results]") {
  const TemporaryDirectory directory;
  const ResultsText text{
      std::string(100, 't'),
      {{"cubit", "16", "01/02/2025", "10:11:12"}, {"contactsim", std::string(40, '1'), "", ""}},
      {"begin sierra", "", std::string(80, 'a') + std::string(80, 'b') + "c"}};
  ResultsWriter(directory.file("r.e"), two_hexes().build(), text, {});
  const NetcdfFile file(directory.file("r.e"));
  CHECK(file.find_global_text("title") == std::string(80, 't'));
  CHECK(texts(file, "info_records") ==
        Names{"begin sierra", "", std::string(80, 'a'), std::string(80, 'b'), "c"});
  CHECK(read_qa_records(directory.file("r.e")) ==
        std::vector<QaRecord>{{"cubit", "16", "01/02/2025", "10:11:12"},
                              {"contactsim", std::string(32, '1'), "", ""}});
}

TEST_CASE("variables can be read step by step", "[io][results]") {
  const TemporaryDirectory directory;
  SampleResults results(two_hexes().build());
  ResultsWriter writer(directory.file("r.e"), results.mesh(), {}, results.fields());
  for (int step = 0; step < 3; ++step) {
    results.set_step(step);
    writer.write_step(0.5 * step, results.values());
  }
  CHECK(writer.n_steps() == 3);
  const NetcdfFile file(directory.file("r.e"));
  CHECK(texts(file, "name_nod_var") == Names{"displ_x", "displ_y", "displ_z", "mass"});
  CHECK(texts(file, "name_elem_var") ==
        Names{"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx", "eqps"});
  CHECK(texts(file, "name_glo_var") == Names{"kinetic_energy", "momentum_x", "momentum_y", "momentum_z"});
  std::vector<std::int64_t> table(14);
  file.read_int64(*file.find_variable("elem_var_tab"), table);
  CHECK(table == std::vector<std::int64_t>{1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1});
  CHECK_FALSE(file.find_variable("vals_elem_var7eb1"));
  CHECK(read_times(file) == std::vector<double>{0.0, 0.5, 1.0});
  for (std::size_t step = 0; step < 3; ++step) CHECK(results.is_step(file, step));
}

TEST_CASE("a results file can be read while it grows", "[io][results]") {
  const TemporaryDirectory directory;
  SampleResults results(two_hexes().build());
  ResultsWriter writer(directory.file("r.e"), results.mesh(), {}, results.fields());
  for (std::size_t step = 0; step < 4; ++step) {
    fs::copy_file(directory.file("r.e"), directory.file("copy.e"), fs::copy_options::overwrite_existing);
    Diagnostics warnings;
    CHECK(read_mesh(directory.file("copy.e"), warnings).n_elements() == 2);
    const NetcdfFile file(directory.file("copy.e"));
    CHECK(read_times(file).size() == step);
    if (step > 0) CHECK(results.is_step(file, step - 1));
    results.set_step(static_cast<int>(step));
    writer.write_step(static_cast<double>(step), results.values());
  }
}

TEST_CASE("the same calls give the same bytes", "[io][results]") {
  const TemporaryDirectory directory;
  SampleResults results(sample_mesh().build());
  for (const char* name : {"a.e", "b.e"}) {
    ResultsWriter writer(directory.file(name), results.mesh(), {"t", {{"c", "v", "d", "t"}}, {"deck"}},
                         results.fields());
    for (int step = 0; step < 2; ++step) {
      results.set_step(step);
      writer.write_step(step, results.values());
    }
  }
  CHECK(read_bytes(directory.file("a.e")) == read_bytes(directory.file("b.e")));
}

TEST_CASE("values for others than all nodes or elements are refused, the step does not count",
          "[io][results]") {
  const TemporaryDirectory directory;
  SampleResults results(two_hexes().build());
  ResultsWriter writer(directory.file("r.e"), results.mesh(), {}, results.fields());
  const ResultsWriter::Values values = results.values();
  CHECK_THROWS_AS(writer.write_step(0.0, [&](std::size_t i) { return values(i).first(1); }),
                  std::logic_error);
  CHECK_THROWS_AS(writer.write_step(0.0, [&](std::size_t i) { return values(i == 0 ? 1 : i); }),
                  std::logic_error);
  CHECK(read_times(NetcdfFile(directory.file("r.e"))).empty());
}

TEST_CASE("the mesh of the run is never overwritten", "[io][results]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g"), link = directory.file("link.e");
  write_exodus(path, two_hexes().build());
  fs::create_symlink(path, link);
  Diagnostics warnings;
  const Mesh mesh = read_mesh(path, warnings);
  const std::string before = read_bytes(path),
                    problem = ": is the mesh of the run; results need a file of their own";
  CHECK_THROWS_WITH(ResultsWriter(path, mesh, {}, {}), path + problem);
  CHECK_THROWS_WITH(ResultsWriter(link, mesh, {}, {}), link + problem);
  CHECK(read_bytes(path) == before);
}

TEST_CASE("an older file stays until the new one has its mesh", "[io][results]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("r.e"), "old");
  MeshParts parts = two_hexes().parts();
  parts.blocks[0].shape = Shape::unknown;
  parts.blocks[0].type_name = "BEX_HEX";
  CHECK_THROWS_WITH(ResultsWriter(directory.file("r.e"), Mesh(parts), {}, {}),
                    Catch::Contains("cannot hold lower of ") && Catch::Contains("type 'BEX_HEX'"));
  CHECK(read_bytes(directory.file("r.e")) == "old");
  const ResultsWriter writer(directory.file("r.e"), two_hexes().build(), {}, {});
  CHECK(NetcdfFile(directory.file("r.e")).dimension("num_nodes") == 12);
  CHECK_FALSE(fs::exists(directory.file("r.e.part")));
}

TEST_CASE("a place that cannot take results is an error", "[io][results]") {
  const Mesh mesh = two_hexes().build();
  CHECK_THROWS_AS(ResultsWriter("/nowhere/at/all.e", mesh, {}, {}), FileError);
  CHECK_THROWS_WITH(ResultsWriter("/dev/full", mesh, {}, {}),
                    "/dev/full: cannot be created (it is not a regular file)");
}

// Written here and looked at by results_in_vtk.py, which CTest runs afterwards where VTK is installed.
TEST_CASE("results for VTK to read", "[.][vtk]") {
  SampleResults results(two_hexes().build());
  ResultsWriter writer(std::string(CONTACTSIM_BINARY_DIR) + "/results_for_vtk.e", results.mesh(),
                       {"for VTK", {}, {}}, results.fields());
  for (int step = 0; step < 3; ++step) {
    results.set_step(step);
    writer.write_step(0.5 * step, results.values());
  }
}
