// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_warnings.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

namespace {

std::string warnings_of(const Mesh& mesh) {
  Diagnostics diagnostics;
  warn_of_mesh(mesh, {}, diagnostics);
  CHECK_FALSE(diagnostics.has_errors());
  return messages(diagnostics);
}

}  // namespace

TEST_CASE("a sound mesh is not warned of, nor an empty one", "[core][mesh]") {
  CHECK(warnings_of(MeshBuilder().add_hexes({.cells = {4, 4, 4}}).build()) == "");
  CHECK(warnings_of(Mesh()) == "");
}

TEST_CASE("elements on the nodes of others are reported by their ids, one or several", "[core][mesh]") {
  const std::string end =
      "; both carry load, and what they share is no outer face that others could meet "
      "[coincident-elements]\n";
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {2, 1, 1}})
      .add_block(7, "again", Shape::hex8, {0, 1, 4, 3, 6, 7, 10, 9});
  builder.set_element_ids({10, 20, 30});
  CHECK(warnings_of(builder.build()) ==
        "warning: 1 element has the nodes of other elements, element 30 of again those of element 10 of "
        "block_1" +
            end);
  MeshBuilder twice;
  twice.add_hexes({.id = 1, .cells = {2, 1, 1}}).add_hexes({.id = 2, .cells = {2, 1, 1}});
  CHECK(warnings_of(twice.build()) ==
        "warning: 2 elements have the nodes of other elements, the first of them element 3 of block_2 those "
        "of element "
        "1 of block_1" +
            end);
}

TEST_CASE("faces of six nodes on others are reported by the ids of the elements", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_ten_node_tets({.id = 1}).add_tets({.id = 2, .origin = {1, 0, 0}});
  std::vector<std::int64_t> ids;
  for (int i = 0; i < 12; ++i) ids.push_back(100 + i);
  builder.set_element_ids(ids);
  const std::string text = warnings_of(builder.build());
  CHECK(text.starts_with(
      "warning: 2 faces of six nodes lie on faces that have no or other midside nodes, the first "
      "of element 10"));
  CHECK(text.ends_with(
      "; those nodes are joined to one side only: mesh both sides alike, or part the bodies and tie "
      "them [midside-nodes]\n"));
}

TEST_CASE("an element that spans the model is reported with its size and the usual one", "[core][mesh]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1, .cells = {60, 1, 1}, .size = {60, 1, 1}}).parts();
  parts.coordinates(0, 0) = 45.0;  // a corner of the first element alone, which reaches from 0 to there
  CHECK(warnings_of(Mesh(parts)) ==
        "warning: 1 element spans more than half of the model, element 1 of block_1, 45 long where most of "
        "its block "
        "are 1; a node of it may stand where it should not; contact searches longer with it "
        "[spanning-element]\n");
}
