// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/omit_blocks.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Three boxes in a row along x; the first two share the nodes between them.
Mesh row_of_boxes() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "left"});
  b.add_hexes({.id = 2, .name = "middle", .origin = {1, 0, 0}});
  b.add_hexes({.id = 3, .name = "right", .cells = {2, 1, 1}, .origin = {3, 0, 0}, .share_nodes = false});
  b.add_side_set(1, "tops", [](const CandidateSide& side) { return side.normal.z() > 0.9; });
  b.add_node_set(1, "bottom", [](const Eigen::Vector3d& x) { return x.z() == 0.0; });
  return b.build();
}

FiniteElementModel omitting(const std::vector<std::string>& names) {
  FiniteElementModel model;
  for (const std::string& name : names) model.omitted.push_back({name, {}});
  return model;
}

}  // namespace

TEST_CASE("an omitted block takes its elements, its own nodes and their places in sets along",
          "[core][mesh]") {
  const Mesh whole = row_of_boxes();
  Diagnostics diagnostics;
  const Mesh mesh = omit_blocks(omitting({"LEFT"}), whole, diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(mesh.blocks().size() == 2);
  CHECK(mesh.blocks()[0].name == "middle");
  CHECK(mesh.blocks()[0].first_element.value == 0);
  CHECK(mesh.n_elements() == 3);
  CHECK(mesh.n_nodes() == whole.n_nodes() - 4);  // four of the left box's eight are the middle's too
  CHECK(mesh.side_sets()[0].sides.size() == 3);
  CHECK(mesh.node_sets()[0].nodes.size() == whole.node_sets()[0].nodes.size() - 2);
  // Ids stay, and so does where things are.
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) {
    CHECK(mesh.element_id({i}) == whole.element_id({i + 1}));
    const auto now = mesh.element_nodes({i}), before = whole.element_nodes({i + 1});
    for (std::size_t k = 0; k < now.size(); ++k) {
      CHECK(mesh.node_id(now[k]) == whole.node_id(before[k]));
      CHECK(mesh.coordinates().col(now[k].value) == whole.coordinates().col(before[k].value));
    }
  }
  for (const ElementSide side : mesh.side_sets()[0].sides) {
    for (const NodeIndex node : mesh.side_nodes(side)) CHECK(mesh.coordinates()(2, node.value) == 1.0);
  }
}

TEST_CASE("blocks may be omitted by their default names, several at once", "[core][mesh]") {
  Diagnostics diagnostics;
  const Mesh mesh = omit_blocks(omitting({"block_3", "block_1"}), row_of_boxes(), diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(mesh.blocks().size() == 1);
  CHECK(mesh.n_nodes() == 8);
}

TEST_CASE("what cannot be omitted is reported with the nearest name", "[core][mesh]") {
  Diagnostics diagnostics;
  omit_blocks(omitting({"midle"}), row_of_boxes(), diagnostics);
  CHECK(messages(diagnostics) ==
        "error: there is no block or assembly 'midle' to omit; did you mean 'middle'?\n");
  Diagnostics of_all;
  omit_blocks(omitting({"left", "middle", "right"}), row_of_boxes(), of_all);
  CHECK(messages(of_all) == "error: no block of the mesh is left\n");
}
