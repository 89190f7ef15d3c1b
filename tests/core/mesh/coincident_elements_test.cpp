// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/coincident_elements.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

TEST_CASE("elements on the nodes of others are found, however they are numbered", "[core][mesh]") {
  MeshParts parts = MeshBuilder()
                        .add_hexes({.id = 1, .cells = {2, 2, 2}})
                        .add_hexes({.id = 2, .origin = {0, 0, 2}})
                        .parts();
  CHECK_FALSE(find_coincident_elements(Mesh(parts)));
  // The second block's element takes the corners of the third of the first block, from another corner on.
  std::copy_n(parts.blocks[0].nodes.begin() + 16, 8, parts.blocks[1].nodes.begin());
  std::rotate(parts.blocks[1].nodes.begin(), parts.blocks[1].nodes.begin() + 3, parts.blocks[1].nodes.end());
  const auto found = find_coincident_elements(Mesh(parts));
  REQUIRE(found);
  CHECK(found->n == 1);
  CHECK(found->first == ElementIndex{8});
  CHECK(found->beside == ElementIndex{2});
}

TEST_CASE("a shell on a face of a solid is no second element there, one on a shell is", "[core][mesh]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1}).add_shells({.id = 2, .origin = {0, 0, 1}}).parts();
  CHECK_FALSE(find_coincident_elements(Mesh(parts)));
  MeshParts sheets = MeshBuilder().add_shells({.id = 1}).add_shells({.id = 2}).parts();
  std::copy(sheets.blocks[0].nodes.begin(), sheets.blocks[0].nodes.end(), sheets.blocks[1].nodes.begin());
  REQUIRE(find_coincident_elements(Mesh(sheets)));
}

TEST_CASE("elements whose nodes add up alike are no second ones", "[core][mesh]") {
  // 0 1 4 5 and 0 2 5 3 have the same sum and smallest node.
  MeshParts parts = MeshBuilder().add_shells({.id = 1, .cells = {2, 1}}).add_shells({.id = 2}).parts();
  const auto nodes = [](const std::vector<std::uint32_t>& numbers) {
    std::vector<NodeIndex> made;
    for (const std::uint32_t number : numbers) made.push_back({number});
    return made;
  };
  parts.blocks[0].nodes = nodes({0, 1, 4, 5, 0, 2, 5, 3});
  parts.blocks[1].nodes = nodes({1, 2, 3, 4});
  CHECK_FALSE(find_coincident_elements(Mesh(parts)));
  parts.blocks[1].nodes = nodes({5, 3, 0, 2});
  const auto found = find_coincident_elements(Mesh(parts));
  REQUIRE(found);
  CHECK(found->n == 1);
  CHECK(found->first == ElementIndex{2});
  CHECK(found->beside == ElementIndex{1});
}
