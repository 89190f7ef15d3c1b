// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/hanging_faces.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

namespace {

/// A ten-node tetrahedron, nodes 0 to 9, and a node 10 below its first face, of corners 0 1 3.
MeshBuilder one_tet() {
  MeshBuilder builder;
  for (const Eigen::Vector3d& x : std::vector<Eigen::Vector3d>{{0, 0, 0},
                                                               {2, 0, 0},
                                                               {0, 2, 0},
                                                               {0, 0, 2},
                                                               {1, 0, 0},
                                                               {1, 1, 0},
                                                               {0, 1, 0},
                                                               {0, 0, 1},
                                                               {1, 0, 1},
                                                               {0, 1, 1},
                                                               {0.5, -2, 0.5}})
    builder.add_node(x);
  builder.add_block(1, "", Shape::tet10, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  return builder;
}

}  // namespace

TEST_CASE("meshes of one order have no hanging midside nodes", "[core][mesh]") {
  CHECK_FALSE(find_hanging_faces(MeshBuilder().add_tets({.cells = {2, 2, 2}}).build()));
  CHECK_FALSE(find_hanging_faces(MeshBuilder().add_ten_node_tets({.cells = {2, 2, 2}}).build()));
  CHECK_FALSE(find_hanging_faces(one_tet().build()));
  CHECK_FALSE(find_hanging_faces(Mesh()));
}

TEST_CASE("a linear solid or shell on a face of six nodes leaves its midside nodes hanging", "[core][mesh]") {
  const Mesh solid = one_tet().add_block(2, "", Shape::tet4, {1, 0, 3, 10}).build();
  const auto found = find_hanging_faces(solid);
  REQUIRE(found);
  CHECK(found->n == 1);
  CHECK(found->first == ElementSide({0}, 1));
  CHECK(found->beside.element() == ElementIndex{1});
  const auto on_shell = find_hanging_faces(one_tet().add_block(2, "", Shape::shell3, {0, 1, 3}).build());
  REQUIRE(on_shell);
  CHECK(on_shell->beside == ElementSide({1}, 1));
}

TEST_CASE("midside nodes of their own leave those of both sides hanging", "[core][mesh]") {
  MeshBuilder builder = one_tet();
  for (int i = 0; i < 4; ++i) builder.add_node({5, 5, double(i)});
  // Across the first face, where 11 stands in the place of 8.
  const Mesh mesh = builder.add_block(2, "", Shape::tet10, {1, 0, 3, 10, 4, 7, 11, 12, 13, 14}).build();
  const auto found = find_hanging_faces(mesh);
  REQUIRE(found);
  CHECK(found->n == 2);
  CHECK(found->first == ElementSide({0}, 1));
  CHECK(found->beside.element() == ElementIndex{1});
}
