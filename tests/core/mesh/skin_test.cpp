// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/skin.hpp"

#include <omp.h>

#include <algorithm>
#include <random>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/slow_skin.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::vector<std::uint8_t> all_present(const Mesh& mesh) {
  return std::vector<std::uint8_t>(mesh.n_elements(), 1);
}

void check_skin(const Mesh& mesh, const std::vector<std::uint8_t>& present) {
  const Skin skin = make_skin(mesh, present), slow = make_slow_skin(mesh, present);
  CHECK(skin.exterior == slow.exterior);
  CHECK(skin.in_between == slow.in_between);
}

/// A brick of mixed shapes: hexahedra, then tetrahedra, wedges and pyramids apart from it, shells on one
/// side.
Mesh mesh_of_all_shapes() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 3, 3}, .size = {4, 3, 3}});
  b.add_hexes({.id = 2, .cells = {2, 3, 3}, .origin = {4, 0, 0}, .size = {2, 3, 3}});
  b.add_tets({.id = 3, .cells = {2, 2, 2}, .origin = {0, 5, 0}}, 5);
  b.add_wedges({.id = 4, .cells = {2, 1, 2}, .origin = {0, 8, 0}});
  b.add_pyramids({.id = 5, .cells = {1, 1, 2}, .origin = {0, 11, 0}});
  b.add_shells({.id = 6, .cells = {4, 3}, .origin = {0, 0, 3}, .u = {4, 0, 0}, .v = {0, 3, 0}});
  return b.build();
}

}  // namespace

TEST_CASE("a brick of 2 x 3 x 4 cells has 52 exterior faces", "[core][skin]") {
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {2, 3, 4}}).build();
  CHECK(make_skin(mesh, all_present(mesh)).exterior.size() == 52);  // 2 (2*3 + 3*4 + 2*4)
}

TEST_CASE("faces between present blocks are interior and counted, those to absent blocks are exterior",
          "[core][skin]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}});
  b.add_hexes({.id = 2, .cells = {3, 2, 2}, .origin = {2, 0, 0}, .size = {3, 2, 2}});
  const Mesh mesh = b.build();
  const Skin both = make_skin(mesh, all_present(mesh));
  CHECK(both.sides_of_block(mesh.blocks()[0]).size() == 20);  // 24 less 4 at the joint
  CHECK(both.sides_of_block(mesh.blocks()[1]).size() == 28);  // 32 less 4
  CHECK(both.in_between == std::vector<std::uint32_t>{4, 4});
  auto present = all_present(mesh);
  std::fill(present.begin() + 8, present.end(), std::uint8_t{0});
  const Skin one = make_skin(mesh, present);
  CHECK(one.exterior.size() == 24);
  CHECK(one.in_between == std::vector<std::uint32_t>{0, 0});
}

TEST_CASE("a shell on a solid face covers it, and has no face in the skin", "[core][skin]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_shells({.id = 2, .origin = {0, 0, 1}});
  const Mesh mesh = b.build();
  const Skin skin = make_skin(mesh, all_present(mesh));
  CHECK(skin.exterior.size() == 5);
  CHECK(std::find(skin.exterior.begin(), skin.exterior.end(), ElementSide({0}, 6)) == skin.exterior.end());
  CHECK(skin.in_between == std::vector<std::uint32_t>{1, 0});
}

TEST_CASE("a hexahedron that is degenerate to a wedge meets a wedge and a hexahedron", "[core][skin]") {
  // Nodes 0..7: unit cube; 8, 9: ridge beyond the face x = 1. The hexahedron 1 8 8 2 / 5 9 9 6 is a wedge;
  // the WEDGE6 1 2 8 / 5 6 9 would be the same body, so it is put on the ridge's other side with nodes
  // 10, 11.
  MeshBuilder b;
  b.add_hexes({.id = 1});
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(2, 0, 1),
                                   Eigen::Vector3d(1, -1, 0), Eigen::Vector3d(1, -1, 1)}) {
    b.add_node(x);
  }
  const Mesh brick = b.build();
  const auto hex = brick.element_nodes({0});
  const auto n = [&](std::size_t corner) { return hex[corner].value; };
  b.add_block(2, "", Shape::hex8, {n(1), 8, 8, n(2), n(5), 9, 9, n(6)});
  b.add_block(3, "", Shape::wedge6, {n(1), 10, 8, n(5), 11, 9});
  const Mesh mesh = b.build();
  REQUIRE(mesh.blocks()[1].has_repeated_nodes);
  const auto present = all_present(mesh);
  const Skin skin = make_skin(mesh, present);
  CHECK(skin.sides_of_block(mesh.blocks()[0]).size() == 5);
  CHECK(skin.sides_of_block(mesh.blocks()[1]).size() == 3);  // two triangles and one quadrilateral
  CHECK(skin.sides_of_block(mesh.blocks()[2]).size() == 4);
  check_skin(mesh, present);
}

TEST_CASE("the skin of random parts of a mixed mesh equals a slow skin", "[core][skin]") {
  const Mesh mesh = mesh_of_all_shapes();
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::uint8_t> present(mesh.n_elements());
    for (auto& p : present) p = random() % 4 != 0;
    check_skin(mesh, present);
  }
}

TEST_CASE("the skin of random blockings equals a slow skin", "[core][skin]") {
  std::mt19937 random(11);
  for (int round = 0; round < 30; ++round) {
    MeshParts parts = MeshBuilder().add_hexes({.id = 1, .cells = {4, 4, 4}}).parts();
    const ElementBlock whole = parts.blocks.front();
    parts.blocks.assign(1 + random() % 5, ElementBlock{});
    for (std::size_t i = 0; i < parts.blocks.size(); ++i) {
      parts.blocks[i].id = static_cast<std::int64_t>(i) + 1;
      parts.blocks[i].shape = Shape::hex8;
      parts.blocks[i].nodes_per_element = 8;
    }
    for (std::uint32_t e = 0; e < whole.n_elements; ++e) {
      ElementBlock& block = parts.blocks[random() % parts.blocks.size()];
      const auto nodes = whole.element_nodes(e);
      block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
      ++block.n_elements;
    }
    const Mesh mesh(parts);
    std::vector<std::uint8_t> present(mesh.n_elements(), 0);
    for (const ElementBlock& block : mesh.blocks()) {
      if (random() % 3 == 0) continue;
      std::fill_n(present.begin() + block.first_element.value, block.n_elements, std::uint8_t{1});
    }
    check_skin(mesh, present);
  }
}

TEST_CASE("a node that a thousand faces share is no trouble", "[core][skin]") {
  // A fan of tetrahedra around the edge 0-1, closed: every tetrahedron shares two faces with its neighbours.
  constexpr std::uint32_t n = 1000;
  MeshBuilder b;
  b.add_node({0, 0, 0});
  b.add_node({0, 0, 1});
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / n;
    b.add_node({std::cos(angle), std::sin(angle), 0.5});
    for (const std::uint32_t node : {0u, 1u, 2u + i, 2u + (i + 1) % n}) nodes.push_back(node);
  }
  const Mesh mesh = b.add_block(1, "", Shape::tet4, nodes).build();
  CHECK(make_skin(mesh, all_present(mesh)).exterior.size() == 2 * n);
}

TEST_CASE("the skin does not depend on the number of threads", "[core][skin]") {
  // Enough elements for eight threads to be woken.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {40, 40, 30}, .size = {40, 40, 30}});
  b.add_hexes({.id = 2, .cells = {40, 40, 20}, .origin = {0, 0, 30}, .size = {40, 40, 20}});
  const Mesh mesh = b.build();
  const int n_threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Skin one = make_skin(mesh, all_present(mesh));
  for (const int n : {2, 3, 8}) {
    omp_set_num_threads(n);
    const Skin many = make_skin(mesh, all_present(mesh));
    CHECK(many.exterior == one.exterior);
    CHECK(many.in_between == one.in_between);
  }
  omp_set_num_threads(n_threads);
}

TEST_CASE("a skin of many nodes equals a slow skin", "[core][skin]") {
  // 41 x 41 x 25 nodes: more than are taken at a time, and layers that straddle the ranges.
  const Mesh mesh = MeshBuilder().add_hexes({.cells = {40, 40, 24}}).build();
  std::mt19937 random(5);
  std::vector<std::uint8_t> present(mesh.n_elements());
  for (std::uint8_t& mark : present) mark = random() % 8 != 0;
  check_skin(mesh, present);
}

TEST_CASE("a mesh without elements has no skin", "[core][skin]") {
  const Mesh mesh;
  CHECK(make_skin(mesh, {}).exterior.empty());
}
