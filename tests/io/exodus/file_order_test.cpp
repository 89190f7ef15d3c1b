// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/file_order.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/mesh/renumber_mesh.hpp"
#include "io/exodus/exodus_variables.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A mesh whose order changes by renumbering, in one of two blocks at least.
Mesh two_blocks() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 4, 2}});
  b.add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {5, 0, 0}, .share_nodes = false});
  b.add_side_set(1, "tops", [](const CandidateSide& side) { return side.normal.z() > 0.9; });
  b.add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; });
  return b.build();
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("values go to the order of the file and back", "[io][results]") {
  const Mesh mesh = two_blocks(), renumbered = renumber_mesh(mesh);
  CHECK(FileOrder::of_nodes(mesh).is_same());
  const FileOrder order = FileOrder::of_nodes(renumbered);
  REQUIRE_FALSE(order.is_same());
  REQUIRE(order.size() == mesh.n_nodes());
  std::vector<double> values;
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
    for (int k = 0; k < 3; ++k) values.push_back(10.0 * static_cast<double>(renumbered.node_id({i})) + k);
  }
  const std::vector<double> second = order.to_file(std::span<const double>(values), 3, 1, 1);
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i)
    CHECK(second[i] == 10.0 * static_cast<double>(mesh.node_id({i})) + 1);
  const std::vector<double> all = order.to_file(std::span<const double>(values), 3, 0, 3);
  CHECK(all[5] == 22.0);
  std::vector<double> back = second;
  order.to_mesh(back);
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) CHECK(back[i] == values[3 * i + 1]);
  const FileOrder block = FileOrder::of_block(renumbered, renumbered.blocks()[1]);
  CHECK(block.size() == 8);
  CHECK(renumbered.element_place({24 + block.position(3)}) == 24 + 3);
}

TEST_CASE("results of a renumbered mesh are those in the order of its file, to the byte", "[io][results]") {
  const TemporaryDirectory directory;
  const Mesh mesh = two_blocks(), renumbered = renumber_mesh(mesh);
  const std::vector<OutputField> fields{{.name = "displacement",
                                         .location = FieldLocation::node,
                                         .shape = FieldShape::vector,
                                         .n_components = 3},
                                        {.name = "id", .location = FieldLocation::element, .block = 0},
                                        {.name = "id", .location = FieldLocation::element, .block = 1},
                                        {.name = "energy", .location = FieldLocation::global}};
  const auto write = [&](const std::string& path, const Mesh& of) {
    ResultsWriter writer(path, of, {"plate", {}, {}}, fields);
    std::vector<double> values;
    writer.write_step(0.5, [&](std::size_t field) -> std::span<const double> {
      values.clear();
      if (field == 0) {
        for (std::uint32_t i = 0; i < of.n_nodes(); ++i) {
          for (int k = 0; k < 3; ++k) values.push_back(static_cast<double>(of.node_id({i})) + 0.1 * k);
        }
      } else if (field == 3) {
        values.push_back(7.0);
      } else {
        const ElementBlock& block = of.blocks()[field - 1];
        for (std::uint32_t i = 0; i < block.n_elements; ++i)
          values.push_back(static_cast<double>(of.element_id({block.first_element.value + i})));
      }
      return values;
    });
  };
  write(directory.file("a.e"), mesh);
  write(directory.file("b.e"), renumbered);
  CHECK(bytes_of_file(directory.file("a.e")) == bytes_of_file(directory.file("b.e")));
  // What is read for the renumbered mesh is in its order.
  const StoredVariables stored = read_stored_variables(directory.file("a.e"), renumbered);
  const std::vector<double> ids = stored.element.read(0, 0), x = stored.nodal.read(0, 0);
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i)
    CHECK(ids[i] == static_cast<double>(renumbered.element_id({i})));
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i)
    CHECK(x[i] == static_cast<double>(renumbered.node_id({i})));
}
