// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/loft_shape.hpp"

// Elements of higher order, and shells whose sides are numbered otherwise: contact sees their corners only.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The mesh with one block's elements of a shape of higher order: each gets the nodes that it lacks for
/// itself, all in one far place.
Mesh raised(const MeshBuilder& builder, std::size_t block_index, Shape shape) {
  MeshParts parts = builder.parts();
  ElementBlock& block = parts.blocks.at(block_index);
  const ElementBlock low = block;
  const auto n_nodes = static_cast<std::size_t>(topology(shape).n_nodes);
  const auto n_corners = static_cast<std::size_t>(low.nodes_per_element);
  REQUIRE(topology(shape).n_corners == low.nodes_per_element);
  auto next = static_cast<std::uint32_t>(parts.coordinates.cols());
  block.shape = shape;
  block.type_name = topology(shape).name;
  block.nodes_per_element = static_cast<int>(n_nodes);
  block.nodes.clear();
  for (std::uint32_t e = 0; e < low.n_elements; ++e) {
    const auto corners = low.element_nodes(e);
    block.nodes.insert(block.nodes.end(), corners.begin(), corners.end());
    for (std::size_t i = n_corners; i < n_nodes; ++i) block.nodes.push_back({next++});
  }
  const Eigen::Index n_old = parts.coordinates.cols();
  parts.coordinates.conservativeResize(3, next);
  parts.coordinates.rightCols(next - n_old).setConstant(1000.0);
  return Mesh(parts);
}

/// Two cells of solids of the shape side by side, block 1, joined to one hexahedron, block 2.
MeshBuilder two_cells(Shape shape) {
  const Box box{.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}};
  MeshBuilder b;
  if (shape == Shape::hex8) b.add_hexes(box);
  if (shape == Shape::tet4) b.add_tets(box, 6);
  if (shape == Shape::wedge6) b.add_wedges(box);
  if (shape == Shape::pyramid5) b.add_pyramids(box);
  b.add_hexes({.id = 2, .origin = {2, 0, 0}});
  b.add_side_set(1, "tops", [](const CandidateSide& c) { return c.block_id == 1 && c.normal.z() > 0.9; });
  return b;
}

}  // namespace

TEST_CASE("solids of higher order are skinned by their corners", "[contact][shapes]") {
  // What is known of the linear elements must hold: who owns what, with neighbours of either order.
  const auto [low, high] = GENERATE(table<Shape, Shape>({{Shape::hex8, Shape::hex20},
                                                         {Shape::hex8, Shape::hex27},
                                                         {Shape::tet4, Shape::tet10},
                                                         {Shape::wedge6, Shape::wedge15},
                                                         {Shape::pyramid5, Shape::pyramid13}}));
  const MeshBuilder b = two_cells(low);
  const Mesh linear = b.build(), mesh = raised(b, 0, high);
  const std::string lines =
      "contact surface a contains tops\n"
      "contact surface c contains block_1\n"
      "contact surface d contains block_2\n"
      "contact node set n contains block_1\n";
  const auto result = resolve(mesh, lines), expected = resolve(linear, lines);
  REQUIRE(result.messages.empty());
  CHECK(list_faces(mesh, result["a"]) == list_faces(linear, expected["a"]));
  CHECK(list_faces(mesh, result["c"]) == list_faces(linear, expected["c"]));
  CHECK(list_faces(mesh, result["d"]) == list_faces(linear, expected["d"]));
  // All nodes of the block, those between its corners too.
  const std::size_t n_added = mesh.n_nodes() - linear.n_nodes();
  CHECK(n_added == mesh.blocks()[0].n_elements *
                       static_cast<std::size_t>(topology(high).n_nodes - topology(high).n_corners));
  CHECK(result["n"].nodes.size() == expected["n"].nodes.size() + n_added);
}

TEST_CASE("the skin of joined hexahedra of 20 nodes is that of hexahedra", "[contact][shapes]") {
  // Three unit cells in a row: 14 faces, 4 of either end block, less its joint.
  const Mesh mesh = raised(two_cells(Shape::hex8), 0, Shape::hex20);
  const auto result = resolve(mesh, "skin all blocks = on\n");
  CHECK(list_faces(mesh, result["block_2"]) == "3:1 3:2 3:3 3:5 3:6");
  CHECK(list_faces(mesh, result["block_1"]) == "1:1 1:3 1:4 1:5 1:6 2:1 2:3 2:5 2:6");
}

TEST_CASE("shells of higher order are lofted by their corners and cover solids", "[contact][shapes]") {
  MeshBuilder b;
  const bool is_triangle = GENERATE(false, true);
  if (is_triangle) {
    b.add_tets({.id = 1}, 6);
    b.add_triangles({.id = 2, .origin = {0, 0, 1}});
  } else {
    b.add_hexes({.id = 1});
    b.add_shells({.id = 2, .origin = {0, 0, 1}});
  }
  b.set_attributes(2, {"thickness"}, std::vector<double>(is_triangle ? 2 : 1, 0.25));
  const std::vector<Shape> shapes =
      is_triangle ? std::vector{Shape::shell6} : std::vector{Shape::shell8, Shape::shell9};
  for (const Shape shape : shapes) {
    const Mesh mesh = raised(b, 1, shape);
    const auto model = make_model(mesh, "skin all blocks = on\n");
    REQUIRE(model.messages.empty());
    CHECK(model.surfaces.surfaces.at(0).faces.size() == (is_triangle ? 10u : 5u));
    CHECK(is_closed(model.loft));
    CHECK(enclosed_volume(model.loft) == Approx(0.25).epsilon(1e-12));
  }
}

TEST_CASE("a quadrilateral of three-dimensional meshes is a shell", "[contact][shapes]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  const auto sides = topology(Shape::hex8).sides;
  std::vector<std::uint32_t> top;
  for (std::size_t i = 0; i < 4; ++i) top.push_back(b.parts().blocks[0].nodes[sides[5].corners[i]].value);
  b.add_block(2, "", Shape::quad4, top);
  b.set_attributes(2, {"thickness"}, {0.5});
  const Mesh mesh = b.build();
  const auto model = make_model(mesh, "skin all blocks = on\n");
  REQUIRE(model.messages.empty());
  CHECK(list_faces(mesh, model.surfaces.surfaces.at(0)) == "1:1 1:2 1:3 1:4 1:5");
  CHECK(list_lofted(mesh, model.surfaces.surfaces.at(1)) == "2");
  CHECK(enclosed_volume(model.loft) == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("lines of three nodes are lofted from end to end", "[contact][shapes]") {
  MeshBuilder b;
  b.add_bars({.id = 1, .cells = 2, .to = {4, 0, 0}});
  b.set_attributes(1, {"area"}, {1, 1});
  const Mesh linear = b.build();
  const auto [family, high] =
      GENERATE(table<Shape, Shape>({{Shape::bar2, Shape::bar3}, {Shape::beam2, Shape::beam3}}));
  REQUIRE(topology(family).family == Family::line);
  const Mesh mesh = raised(b, 0, high);
  const auto model = make_model(mesh, "skin all blocks = on\n"),
             expected = make_model(linear, "skin all blocks = on\n");
  REQUIRE(model.messages.empty());
  CHECK(model.loft.vertices == expected.loft.vertices);
  CHECK(model.loft.facets.size() == 16);
}

TEST_CASE("a block of elements without a shape of their own gives nothing", "[contact][shapes]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_block(2, "", Shape::null, {});
  const Mesh mesh = b.build();
  const auto result = resolve(mesh, "skin all blocks = on\n");
  CHECK(result.messages.empty());
  CHECK(list_warnings(result) ==
        "surface-empty, line 1, block_2, 0: surface 'block_2' owns nothing and takes no part in contact\n");
}
