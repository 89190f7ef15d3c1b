// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_reader.hpp"

#include "core/base/errors.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::StartsWith;

namespace {

Mesh write_and_read(const Mesh& mesh, const ExodusLayout& layout) {
  return reread(
      mesh, [](ExodusEditor&) {}, layout);
}

}  // namespace

TEST_CASE("a mesh reads alike from every netCDF format", "[io][exodus]") {
  const FileFormat format = GENERATE(FileFormat::cdf1, FileFormat::cdf2, FileFormat::cdf5,
                                     FileFormat::netcdf4, FileFormat::netcdf4_classic);
  CAPTURE(static_cast<int>(format));
  const Mesh mesh = sample_mesh().build();
  check_same(write_and_read(mesh, {.format = format}), mesh);
  check_same(write_and_read(mesh, {.format = format, .combined_coordinates = true}), mesh);
  check_same(write_and_read(mesh, {.format = format, .with_status = false, .name_length = 255}), mesh);
}

TEST_CASE("64-bit integers and compressed data read alike", "[io][exodus]") {
  const Mesh mesh = sample_mesh().build();
  check_same(write_and_read(mesh, {.format = FileFormat::cdf5, .wide_integers = true}), mesh);
  check_same(write_and_read(mesh, {.format = FileFormat::netcdf4, .wide_integers = true}), mesh);
  check_same(write_and_read(mesh, {.format = FileFormat::netcdf4, .deflate = true}), mesh);
}

TEST_CASE("4-byte reals read to their own precision", "[io][exodus]") {
  const Mesh mesh = MeshBuilder().add_hexes({.size = {0.1, 0.2, 0.3}}).build();
  const Mesh found = write_and_read(mesh, {.single_precision = true});
  CHECK(found.coordinates() == mesh.coordinates().cast<float>().cast<double>());
  CHECK(found.coordinates() != mesh.coordinates());
}

TEST_CASE("without names on file the default names serve", "[io][exodus]") {
  const Mesh found = write_and_read(sample_mesh().build(), {.with_names = false});
  CHECK(found.names(EntityKind::block) ==
        std::vector<std::string>{"block_10", "block_7", "block_99", "block_3", "block_4", "block_0"});
  CHECK(found.names(EntityKind::side_set) == std::vector<std::string>{"surface_5", "surface_6"});
  CHECK(found.names(EntityKind::node_set) == std::vector<std::string>{"nodelist_100"});
  CHECK(found.find(EntityKind::assembly, "everything") == 2u);
}

TEST_CASE("an empty mesh is a mesh", "[io][exodus]") {
  const Mesh found = write_and_read(Mesh(), {});
  CHECK(found.n_nodes() == 0);
  CHECK(found.n_elements() == 0);
}

TEST_CASE("the path and the title are kept", "[io][exodus]") {
  const TemporaryDirectory directory;
  MeshParts parts = two_hexes().parts();
  parts.title = "two hexes";
  write_exodus(directory.file("a.g"), Mesh(parts));
  Diagnostics warnings;
  const Mesh found = read_mesh(directory.file("a.g"), warnings);
  CHECK(found.path() == directory.file("a.g"));
  CHECK(found.title() == "two hexes");
  CHECK(warnings.empty());
}

TEST_CASE("the element order map, properties and results are not looked at", "[io][exodus]") {
  const Mesh mesh = two_hexes().build();
  const auto change = [](ExodusEditor& editor) {
    editor.add_integers("elem_map", {"num_elem"}, {2, 1}).add_integers("eb_prop2", {"num_el_blk"}, {-1, -1});
    editor.add_dimension("time_step", 2)
        .add_reals("vals_nod_var1", {"time_step", "num_nodes"}, std::vector<double>(24, std::nan("")));
  };
  check_same(reread(mesh, change), mesh);
  CHECK(warnings_of(mesh, change).empty());
}

TEST_CASE("netCDF that is not a three-dimensional Exodus mesh is refused", "[io][exodus]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) { file.remove_attribute("", "version"); }) ==
        "is netCDF but not Exodus (no global attribute 'version')");
  CHECK(refusal(mesh, [](auto& file) { file.set_attribute("", "version", 1.5); }) ==
        "is Exodus version 1.5; 2 or later is needed");
  CHECK(refusal(mesh, [](auto& file) { file.set_attribute("", "version", std::nan("")); }) ==
        "is Exodus version nan; 2 or later is needed");
  CHECK(refusal(mesh, [](auto& file) { file.rename_dimension("num_dim", "n"); }) ==
        "is netCDF but not an Exodus mesh (no dimension 'num_dim')");
  CHECK(refusal(mesh, [](auto& file) {
          file.rename_dimension("num_dim", "n").add_dimension("num_dim", 2);
        }) == "is a 2-dimensional mesh; contactsim needs three dimensions");
}

TEST_CASE("pieces that are not named as such and several meshes in one file are refused", "[io][exodus]") {
  CHECK(refusal(two_hexes().build(), [](auto& file) { file.set_attribute("", "processor_info", 8.0); }) ==
        "is one piece of a decomposed mesh, but not named as one is, like mesh.g.4.0; the pieces cannot be "
        "found");
  CHECK(refusal(two_hexes().build(), [](auto& file) { file.add_dimension("num_processors", 8); }) ==
        "is one piece of a decomposed mesh, but not named as one is, like mesh.g.4.0; the pieces cannot be "
        "found");
  const TemporaryDirectory directory;
  const std::string path = directory.file("groups.e");
  write_exodus(path, two_hexes().build(), {.format = FileFormat::netcdf4});
  ExodusEditor(path).add_group("second").add_group("third");
  Diagnostics warnings;
  CHECK_THROWS_WITH(
      read_mesh(path, warnings),
      path +
          ": holds 2 netCDF groups (several meshes in one file); write the wanted one to a file of "
          "its own");
}

TEST_CASE("a name like a piece's is only worth a warning", "[io][exodus]") {
  const TemporaryDirectory directory;
  write_exodus(directory.file("mesh.g.8.0"), two_hexes().build());
  Diagnostics warnings;
  CHECK(read_mesh(directory.file("mesh.g.8.0"), warnings).n_elements() == 2);
  REQUIRE(warnings.all().size() == 1);
  CHECK(warnings.all()[0].id == "mesh-piece");
}

TEST_CASE("entities that are not read are named", "[io][exodus]") {
  CHECK(warnings_of(two_hexes().build(), [](auto& file) { file.add_dimension("num_elem_sets", 3); }) ==
        "warning: its 3 element sets are not read [mesh-entities-ignored]\n");
}

TEST_CASE("counts that the file is too small for allocate nothing", "[io][exodus]") {
  const Mesh mesh = two_hexes().build();
  // Larger than any memory: reaching an allocation would end the test.
  CHECK_THAT(refusal(mesh,
                     [](auto& file) {
                       file.rename_dimension("num_nodes", "n").add_dimension("num_nodes", 0xfffffffcu);
                     }),
             StartsWith("has 4294967292 nodes; at most 2147483647 are possible"));
  CHECK_THAT(refusal(mesh,
                     [](auto& file) {
                       file.rename_dimension("num_elem", "n").add_dimension("num_elem", 0x7ffffff0u);
                     }),
             StartsWith("has 2147483632 elements; at most 536870912 are possible"));
}

TEST_CASE("a netCDF-4 variable that was declared huge and never written is refused", "[io][exodus]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("huge.e");
  write_exodus(path, two_hexes().build(), {.format = FileFormat::netcdf4});
  const auto declare = [&](bool chunked) {
    ExodusEditor editor(path);
    editor.rename_variable("coordx", chunked ? "x2" : "x1").add_dimension(chunked ? "c" : "d", 1u << 30);
    editor.declare_reals("coordx", {chunked ? "c" : "d"}, chunked);
  };
  Diagnostics warnings;
  for (bool chunked : {false, true}) {
    declare(chunked);
    CHECK_THROWS_WITH(read_mesh(path, warnings),
                      path + ": variable coordx claims more values than the file can hold");
  }
}
