// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/face_groups.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

namespace {

std::vector<ElementSide> group_of(const FaceGroups& faces, ElementSide face) {
  std::vector<ElementSide> group{face};  // what it holds before is dropped
  faces.find_group(face, group);
  return group;
}

std::size_t n_faces_of(const FaceGroups& faces, std::uint32_t element) {
  std::vector<ElementSide> found{{}};
  faces.find_faces({element}, found);
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(found[i] == ElementSide({element}, static_cast<int>(i) + 1));
  return found.size();
}

using Group = std::vector<ElementSide>;

}  // namespace

TEST_CASE("solids have all their sides, shells their first, lines and points none", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1})
      .add_tets({.id = 2, .origin = {3, 0, 0}}, 5)
      .add_wedges({.id = 3, .origin = {5, 0, 0}});
  builder.add_pyramids({.id = 4, .origin = {7, 0, 0}}).add_shells({.id = 5, .origin = {9, 0, 0}});
  builder.add_triangles({.id = 6, .origin = {11, 0, 0}})
      .add_bars({.id = 7, .from = {13, 0, 0}, .to = {14, 0, 0}});
  builder.add_spheres(8, "", {{15, 0, 0}});
  const Mesh mesh = builder.build();
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  const std::vector<std::size_t> expected{6, 4, 5, 5, 1, 1, 0, 0};
  for (std::size_t b = 0; b < expected.size(); ++b)
    CHECK(n_faces_of(faces, mesh.blocks()[b].first_element.value) == expected[b]);
}

TEST_CASE("faces with the same corners are a group, whatever way they look", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  builder.add_shells({.id = 2, .origin = {1, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}});
  builder.add_shells({.id = 3, .origin = {1, 0, 0}, .u = {0, 0, 1}, .v = {0, 1, 0}});
  builder.add_hexes({.id = 4, .origin = {0, 1, 0}, .share_nodes = false});  // lies there, but shares no node
  const Mesh mesh = builder.build();
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  const Group between{{{0}, 2}, {{1}, 4}, {{2}, 1}, {{3}, 1}};
  for (const ElementSide face : between) CHECK(group_of(faces, face) == between);
  CHECK(group_of(faces, {{0}, 4}) == Group{{{0}, 4}});
  CHECK(group_of(faces, {{0}, 3}) == Group{{{0}, 3}});
}

TEST_CASE("the quadrilateral of a pyramid meets a hexahedron, its triangles a tetrahedron", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1});  // nodes 0 to 7
  builder.add_node({0.5, 0.5, 2}), builder.add_node({0.5, 2, 1});
  builder.add_block(2, "", Shape::pyramid5, {4, 5, 7, 6, 8});
  builder.add_block(3, "", Shape::tet4, {7, 6, 8, 9});
  const Mesh mesh = builder.build();
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  CHECK(group_of(faces, {{0}, 6}) == Group{{{0}, 6}, {{1}, 5}});
  std::vector<ElementSide> own;
  faces.find_faces({1}, own);
  std::size_t n_shared = 0;
  for (const ElementSide face : own) n_shared += group_of(faces, face).size() - 1;
  CHECK(n_shared == 2);
}

TEST_CASE("two sides of one element on the same nodes are both of the group", "[core][mesh]") {
  // A hexahedron folded flat: its top stands on the nodes of its bottom.
  MeshBuilder builder;
  builder.add_shells({.id = 1});
  builder.add_block(2, "", Shape::hex8, {0, 1, 3, 2, 0, 1, 3, 2});
  const Mesh mesh = builder.build();
  const NodeElements elements(mesh);
  const FaceGroups faces(mesh, elements);
  CHECK(group_of(faces, {{0}, 1}) == Group{{{0}, 1}, {{1}, 5}, {{1}, 6}});
}
