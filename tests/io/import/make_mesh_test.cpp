// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/make_mesh.hpp"

#include <algorithm>

#include "core/base/errors.hpp"
#include "io/import/inp_elements.hpp"
#include "io/import/solid_faces.hpp"
#include "io/import/text_words.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
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

TEST_CASE("each face of Abaqus and of Exodus is found on its solid, whatever its first corner",
          "[io][import]") {
  for (const Shape shape : {Shape::hex8, Shape::tet4, Shape::tet10, Shape::wedge6, Shape::pyramid5}) {
    ElementBlock block;
    block.shape = shape;
    block.n_elements = 1;
    block.nodes_per_element = topology(shape).n_nodes;
    for (std::uint32_t i = 0; i < topology(shape).n_nodes; ++i) block.nodes.push_back({10 + i});
    const SolidFaces faces({&block, 1});
    std::vector<ElementSide> found;
    for (const std::vector<int>& corners : inp_faces(shape)) {
      DraftFace face;
      for (std::size_t c = 0; c < 4; ++c)
        face[c] = block.nodes[static_cast<std::size_t>(corners[std::min(c, corners.size() - 1)])];
      std::rotate(face.begin(), face.begin() + 1, face.end());
      const auto side = faces.find(face);
      REQUIRE(side);
      found.push_back(*side);
    }
    std::sort(found.begin(), found.end());
    CHECK(std::unique(found.begin(), found.end()) == found.end());
    CHECK_FALSE(faces.find({{{1}, {2}, {3}, {3}}}));
  }
}

TEST_CASE("words of a text have their lines", "[io][import]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("t.txt"), "one  +2\n\n 3.5e-1 rest of it \nx");
  TextWords words(directory.file("t.txt"));
  CHECK(words.word() == "one");
  CHECK(words.integer() == 2);
  CHECK(words.real() == 0.35);
  CHECK(words.line_number() == 3);
  CHECK(words.rest_of_line() == "rest of it");
  CHECK_THROWS_WITH(words.integer(), Contains("t.txt: line 4: expected a whole number, found 'x'"));
  CHECK(words.is_at_end());
  CHECK_THROWS_AS(TextWords(directory.file("none")), FileError);
}
