// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/make_mesh.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

/// A cube of nodes 101 to 108, and nodes 109 to 111 beside it; element ids 7, ...
DraftMesh cube() {
  DraftMesh mesh;
  mesh.path = "cube.msh";
  for (int i = 0; i < 11; ++i) {
    mesh.node_ids.push_back(101 + i);
    mesh.coordinates.emplace_back(i % 4, i / 4, i);
  }
  mesh.groups = {{"body", 3, 3, Shape::hex8, {7}, {{0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}}}};
  return mesh;
}

}  // namespace

TEST_CASE("surfaces on solids are side sets, others shells; lines on what is meshed node sets",
          "[io][import]") {
  DraftMesh draft = cube();
  draft.groups.push_back({"top", 3, 2, Shape::shell4, {8}, {{4}, {5}, {6}, {7}}});
  draft.groups.push_back({"sheet", 0, 2, Shape::shell3, {9}, {{1}, {8}, {9}}});
  draft.groups.push_back({"edge", 5, 1, Shape::beam2, {10}, {{0}, {1}}});
  draft.side_sets = {{"bottom", 0, {{{{0}, {1}, {2}, {3}}}}, {}}};
  draft.node_sets = {{"all", 0, {}, {{0}, {0}, {10}}}};
  const auto [mesh, notes] = make_mesh(draft);
  REQUIRE(mesh.blocks().size() == 2);
  CHECK(mesh.blocks()[0].id == 3);
  CHECK(mesh.blocks()[1].name == "sheet");
  CHECK(mesh.blocks()[1].type_name == "SHELL3");
  CHECK(mesh.element_id({1}) == 9);
  REQUIRE(mesh.side_sets().size() == 2);
  CHECK(mesh.side_sets()[0].id == 3);
  CHECK(mesh.side_sets()[0].sides == std::vector{ElementSide({0}, 6)});
  CHECK(mesh.side_sets()[1].sides == std::vector{ElementSide({0}, 5)});
  REQUIRE(mesh.node_sets().size() == 2);
  CHECK(mesh.node_sets()[0].nodes == std::vector<NodeIndex>{{0}, {1}});
  CHECK(mesh.node_sets()[1].nodes == std::vector<NodeIndex>{{0}});
  CHECK(mesh.n_nodes() == 10);  // node 111 belongs to nothing
  CHECK(mesh.node_id({9}) == 110);
  CHECK_THAT(notes.at(1), Contains("surface 'sheet': block 1 of SHELL3, 1 element"));
}

TEST_CASE("a group of two shapes is two blocks, of names and ids of their own", "[io][import]") {
  DraftMesh draft = cube();
  draft.groups.push_back({"body", 3, 3, Shape::tet4, {8}, {{4}, {5}, {6}, {9}}});
  const Mesh mesh = make_mesh(draft).mesh;
  CHECK(mesh.name({EntityKind::block, 0}) == "body");
  CHECK(mesh.name({EntityKind::block, 1}) == "body_tetra4");
  CHECK(mesh.blocks()[1].id == 1);
}

TEST_CASE("blocks of one name and shape have names of their own", "[io][import]") {
  DraftMesh draft = cube();
  for (const std::int64_t id : {4, 5})
    draft.groups.push_back({"body", id, 3, Shape::tet4, {id + 4}, {{4}, {5}, {6}, {9}}});
  const Mesh mesh = make_mesh(draft).mesh;
  CHECK(mesh.name({EntityKind::block, 1}) == "body_tetra4");
  CHECK(mesh.name({EntityKind::block, 2}) == "body_tetra4_2");
}

TEST_CASE("a surface that lies on solids in part, or on none where it must, is refused", "[io][import]") {
  DraftMesh draft = cube();
  draft.groups.push_back({"skin", 2, 2, Shape::shell4, {8, 9}, {{4}, {5}, {6}, {7}, {1}, {8}, {9}, {2}}});
  CHECK_THROWS_WITH(make_mesh(draft), Contains("cube.msh: surface 'skin': 1 of 2 faces lie on solids"));
  draft = cube();
  draft.side_sets = {{"wrong", 0, {{{{0}, {1}, {2}, {9}}}}, {}}};
  CHECK_THROWS_WITH(make_mesh(draft), Contains("surface 'wrong' has a face that no solid has"));
  draft = cube();
  draft.groups.clear();
  CHECK_THROWS_WITH(make_mesh(draft), Contains("no group of elements is a block"));
}
