// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/surface_sets.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a surface of solids and shells has faces and both sides of shells, lines have nodes",
          "[app][outputs]") {
  MeshBuilder b;
  b.add_hexes({.id = 1})
      .add_shells({.id = 2, .origin = {0, 0, 2}})
      .add_beams({.id = 3, .from = {0, 0, 4}, .to = {1, 0, 4}});
  const Mesh mesh = b.build();
  ContactSurface surface;
  surface.faces = {ElementSide({0}, 6)};
  surface.lofted_elements = {{1}, {2}};
  CHECK(sides_of_surface(surface, mesh) ==
        std::vector{ElementSide({0}, 6), ElementSide({1}, 1), ElementSide({1}, 2)});
  const auto line = mesh.element_nodes({2});
  CHECK(nodes_of_surface(surface, mesh) == std::vector<NodeIndex>(line.begin(), line.end()));
  surface.nodes = {{3}};
  CHECK(nodes_of_surface(surface, mesh).front() == NodeIndex{3});
  CHECK(nodes_of_surface(surface, mesh).size() == 3);
}
