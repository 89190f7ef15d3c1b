// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/solid_faces.hpp"

#include <algorithm>

#include "io/import/inp_elements.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

ElementBlock block_of_nodes(Shape shape, const std::vector<std::uint32_t>& nodes) {
  ElementBlock block;
  block.shape = shape;
  block.nodes_per_element = topology(shape).n_nodes;
  block.n_elements = static_cast<std::uint32_t>(nodes.size() / topology(shape).n_nodes);
  for (const std::uint32_t node : nodes) block.nodes.push_back({node});
  return block;
}

}  // namespace

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

TEST_CASE("elements count through blocks, shells among them, and a shared face is that of the first",
          "[io][import]") {
  const std::vector<ElementBlock> blocks{
      block_of_nodes(Shape::hex8, {0, 1, 2, 3, 4, 5, 6, 7}), block_of_nodes(Shape::shell4, {20, 21, 22, 23}),
      block_of_nodes(Shape::hex8, {30, 31, 32, 33, 34, 35, 36, 37, 4, 5, 6, 7, 8, 9, 10, 11})};
  const SolidFaces faces(blocks);
  CHECK(faces.find({{{6}, {4}, {7}, {5}}}) == ElementSide({0}, 6));
  CHECK(faces.find({{{8}, {9}, {10}, {11}}}) == ElementSide({3}, 6));
  CHECK(faces.find({{{30}, {31}, {32}, {33}}}) == ElementSide({2}, 5));
  CHECK_FALSE(faces.find({{{20}, {21}, {22}, {23}}}));
  CHECK_FALSE(faces.find({{{0}, {1}, {2}, {2}}}));  // three corners of four
}

TEST_CASE("a triangle is found whichever of its corners is repeated", "[io][import]") {
  const ElementBlock tet = block_of_nodes(Shape::tet4, {3, 1, 7, 5});
  const SolidFaces faces({&tet, 1});
  const auto side = faces.find({{{3}, {1}, {5}, {5}}});
  REQUIRE(side);
  CHECK(faces.find({{{5}, {3}, {3}, {1}}}) == side);
  CHECK(faces.find({{{1}, {1}, {5}, {3}}}) == side);
  CHECK_FALSE(faces.find({{{1}, {1}, {5}, {5}}}));
  CHECK_FALSE(SolidFaces({}).find({{{3}, {1}, {5}, {5}}}));
}
