// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/sample_mesh.hpp"

#include <utility>

#include "core/base/errors.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "support/catch.hpp"
#include "support/sample_sets.hpp"
#include "support/temporary_directory.hpp"

namespace contactsim::test {

namespace {

std::string without_path(std::string text, const std::string& path) {
  for (std::size_t at = text.find(path + ": "); at != std::string::npos; at = text.find(path + ": ")) {
    text.erase(at, path.size() + 2);
  }
  return text;
}

void check_same_blocks(const ElementBlock& found, const ElementBlock& expected) {
  CHECK(found.id == expected.id);
  CHECK(found.name == expected.name);
  CHECK(found.shape == expected.shape);
  CHECK(found.first_element == expected.first_element);
  CHECK(found.n_elements == expected.n_elements);
  CHECK(found.nodes == expected.nodes);
  CHECK(found.has_repeated_nodes == expected.has_repeated_nodes);
  CHECK(found.attribute_names == expected.attribute_names);
  CHECK(found.attributes == expected.attributes);
}

}  // namespace

MeshBuilder sample_mesh() {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "lower", .cells = {2, 2, 1}})
      .add_tets({.id = 7, .name = "Upper Part", .origin = {0, 0, 1}})
      .add_block(99, "", Shape::null, {})
      .add_shells({.id = 3, .cells = {2, 2}, .origin = {0, 0, 1}})
      .set_attributes(3, {"thickness"}, {0.5, 0.25, 0.125, 1.0})
      .add_bars({.id = 4, .name = "rod", .cells = 2, .from = {0, 0, 3}, .to = {1, 0, 3}})
      .add_spheres(0, "dust", {{4, 0, 0}, {5, 0, 0}})
      .set_attributes(0, {"radius", "volume"}, {1.0, 2.0, 3.0, 4.0});
  return with_sample_sets(std::move(builder));
}

MeshBuilder two_hexes() {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "lower"}).add_hexes({.id = 20, .name = "upper", .origin = {0, 0, 1}});
  builder.add_side_set(1, "top", std::vector<ElementSide>{{{1}, 6}, {{0}, 1}})
      .add_node_set(100, "fixed", std::vector<std::uint32_t>{0, 1, 2, 3});
  return builder;
}

void check_same(const Mesh& found, const Mesh& expected) {
  CHECK(found.title() == expected.title());
  CHECK(found.coordinates() == expected.coordinates());
  REQUIRE(found.blocks().size() == expected.blocks().size());
  for (std::size_t b = 0; b < found.blocks().size(); ++b)
    check_same_blocks(found.blocks()[b], expected.blocks()[b]);
  REQUIRE(found.side_sets().size() == expected.side_sets().size());
  for (std::size_t s = 0; s < found.side_sets().size(); ++s) {
    CHECK(found.side_sets()[s].id == expected.side_sets()[s].id);
    CHECK(found.side_sets()[s].name == expected.side_sets()[s].name);
    CHECK(found.side_sets()[s].sides == expected.side_sets()[s].sides);
    CHECK(found.side_sets()[s].distribution_factors == expected.side_sets()[s].distribution_factors);
  }
  REQUIRE(found.node_sets().size() == expected.node_sets().size());
  for (std::size_t s = 0; s < found.node_sets().size(); ++s) {
    CHECK(found.node_sets()[s].id == expected.node_sets()[s].id);
    CHECK(found.node_sets()[s].name == expected.node_sets()[s].name);
    CHECK(found.node_sets()[s].nodes == expected.node_sets()[s].nodes);
  }
  REQUIRE(found.assemblies().size() == expected.assemblies().size());
  for (std::uint32_t a = 0; a < found.assemblies().size(); ++a) {
    CHECK(found.assemblies()[a].name == expected.assemblies()[a].name);
    CHECK(found.members(a) == expected.members(a));
  }
  for (std::uint32_t n = 0; n < found.n_nodes(); ++n) CHECK(found.node_id({n}) == expected.node_id({n}));
  for (std::uint32_t e = 0; e < found.n_elements(); ++e)
    CHECK(found.element_id({e}) == expected.element_id({e}));
}

std::string refusal(const Mesh& mesh, const std::function<void(ExodusEditor&)>& damage) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  write_exodus(path, mesh);
  {
    ExodusEditor editor(path);
    damage(editor);
  }
  Diagnostics warnings;
  try {
    read_mesh(path, warnings);
  } catch (const FileError& error) {
    return without_path(error.what(), path);
  }
  return "";
}

std::string warnings_of(const Mesh& mesh, const std::function<void(ExodusEditor&)>& change) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  write_exodus(path, mesh);
  {
    ExodusEditor editor(path);
    change(editor);
  }
  Diagnostics warnings;
  read_mesh(path, warnings);
  std::string text;
  for (const DiagnosticGroup& group : warnings.grouped()) text += format_machine(group);
  return without_path(text, path);
}

Mesh reread(const Mesh& mesh, const std::function<void(ExodusEditor&)>& change, const ExodusLayout& layout) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  write_exodus(path, mesh, layout);
  {
    ExodusEditor editor(path);
    change(editor);
  }
  Diagnostics warnings;
  return read_mesh(path, warnings);
}

}  // namespace contactsim::test
