// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/face_record.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::element_faces;

TEST_CASE("a face's record is the same for any order of its corners and has all but the smallest",
          "[core][face_record]") {
  const Corners corners{7, 3, 9, 12};
  std::array<std::uint32_t, 4> order{0, 1, 2, 3};
  do {
    const FaceRecord record =
        make_record({corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]]}, {});
    CHECK(std::array{record.b, record.c, record.d} == std::array<std::uint32_t, 3>{7, 9, 12});
  } while (std::ranges::next_permutation(order).found);
  CHECK(smallest(corners) == 3);
}

TEST_CASE("the records of a triangle and of a quadrilateral with its corners differ", "[core][face_record]") {
  const FaceRecord triangle = make_record({4, 8, 6, 6}, {}), turned = make_record({8, 6, 4, 4}, {});
  CHECK(triangle.has_nodes_of(turned));
  for (const std::uint32_t fourth : {1u, 5u, 7u, 9u})
    CHECK_FALSE(triangle.has_nodes_of(make_record({4, 8, 6, fourth}, {})));
}

TEST_CASE("a face with repeated nodes is a triangle, or none", "[core][face_record]") {
  Corners corners{5, 5, 2, 8};
  CHECK(reduce(corners));
  CHECK(corners == Corners{5, 2, 8, 8});
  corners = {5, 2, 8, 5};
  CHECK(reduce(corners));
  CHECK(corners == Corners{5, 2, 8, 8});
  corners = {1, 2, 3, 4};
  CHECK(reduce(corners));
  CHECK(corners == Corners{1, 2, 3, 4});
  corners = {5, 2, 5, 2};
  CHECK_FALSE(reduce(corners));
}

TEST_CASE("of equal faces those are in between that are the only ones of their blocks",
          "[core][face_record]") {
  // Elements 0 and 1 of block 0, 2 of block 1, 3 of block 2, which is of shells.
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}});
  b.add_hexes({.id = 2, .origin = {5, 0, 0}});
  b.add_shells({.id = 3, .origin = {9, 0, 0}});
  const Mesh mesh = b.build();
  const auto in_between = [&](const std::vector<std::uint32_t>& elements) {
    std::vector<ElementSide> group;
    for (const std::uint32_t element : elements) group.emplace_back(ElementIndex{element}, 1);
    std::vector<std::uint32_t> blocks;
    visit_in_between(
        mesh, group, [&](ElementIndex element) { return mesh.block_of(element); },
        [&](std::uint32_t block) { blocks.push_back(block); });
    return blocks;
  };
  using Blocks = std::vector<std::uint32_t>;
  CHECK(in_between({0, 2}) == Blocks{0, 1});
  CHECK(in_between({0, 1}).empty());
  CHECK(in_between({0, 1, 2}) == Blocks{1});
  CHECK(in_between({2, 3}) == Blocks{1});
}
