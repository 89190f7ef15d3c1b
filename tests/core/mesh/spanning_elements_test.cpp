// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/spanning_elements.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

TEST_CASE("an element with a node far from all others is found", "[core][mesh]") {
  MeshParts parts = MeshBuilder().add_hexes({.cells = {5, 5, 5}}).parts();
  CHECK_FALSE(find_spanning_elements(Mesh(parts)));
  parts.coordinates(0, parts.blocks[0].nodes[8 * 124 + 6].value) =
      1000.0;  // a corner of the last element alone
  const auto found = find_spanning_elements(Mesh(parts));
  REQUIRE(found);
  CHECK(found->n == 1);
  CHECK(found->first == ElementIndex{124});
  CHECK(found->extent == Approx(1000.0).epsilon(0.01));
  CHECK(found->usual == Approx(0.2));
}

TEST_CASE("a floor of one element below many small ones is none", "[core][mesh]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1, .cells = {5, 5, 5}})
                        .add_hexes({.id = 2, .origin = {-50, -50, -2}, .size = {100, 100, 1}})
                        .build();
  CHECK_FALSE(find_spanning_elements(mesh));
}
