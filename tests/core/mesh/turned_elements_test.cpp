// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/turned_elements.hpp"

#include <Eigen/Geometry>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

namespace {

/// The positions of those turned when one node moves.
std::vector<std::uint32_t> turned_by(const Mesh& mesh, std::uint32_t node, const Eigen::Vector3d& by) {
  Eigen::Matrix3Xd x = mesh.coordinates();
  x.col(node) += by;
  std::vector<std::uint32_t> places;
  for (const ElementIndex element : find_turned_elements(mesh, x)) places.push_back(element.value);
  return places;
}

using Turned = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("nothing is turned where nothing moves, or all moves as one", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {2, 1, 1}}).add_shells({.id = 2, .origin = {5, 0, 0}});
  builder.add_pyramids({.id = 3, .origin = {7, 0, 0}}).add_triangles({.id = 4, .origin = {9, 0, 0}});
  const Mesh mesh = builder.build();
  CHECK(find_turned_elements(mesh, mesh.coordinates()).empty());
  // Shells are turned over when they turn by more than a right angle: that of a rigid motion counts, too.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  CHECK(find_turned_elements(mesh, turn * mesh.coordinates()).empty());
  CHECK(find_turned_elements(mesh, -mesh.coordinates()).size() == 2 + 6);  // mirrored solids, not shells
}

TEST_CASE("solids are turned when a node goes through the far side", "[core][mesh]") {
  MeshBuilder builder;
  for (const Eigen::Vector3d& x :
       std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}})
    builder.add_node(x);
  builder.add_block(1, "", Shape::tet4, {0, 1, 2, 3, 1, 4, 2, 3});
  const Mesh mesh = builder.build();
  CHECK(turned_by(mesh, 0, {0.3, 0.3, 0.3}).empty());
  CHECK(turned_by(mesh, 0, {0.4, 0.4, 0.4}) == Turned{0});  // beyond the plane x + y + z = 1
  CHECK(turned_by(mesh, 4, {-0.7, -0.7, -0.7}) == Turned{1});
  CHECK(turned_by(mesh, 3, {0, 0, -1}) == Turned{0});  // flat is turned
  CHECK(turned_by(mesh, 3, {0, 0, -2}) == Turned{0, 1});
  Eigen::Matrix3Xd lost = mesh.coordinates();
  lost(0, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK(find_turned_elements(mesh, lost).size() == 2);
}

TEST_CASE("a hexahedron is turned at one corner, though it has volume", "[core][mesh]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).build();
  // The corner at (1 1 1), node 7: beyond the plane of its three neighbours, x + y + z = 2.
  CHECK(turned_by(mesh, 7, {-0.32, -0.32, -0.32}).empty());
  CHECK(turned_by(mesh, 7, {-0.34, -0.34, -0.34}) == Turned{0});
}

TEST_CASE("what was ill in the mesh already is not turned by moving it", "[core][mesh]") {
  MeshParts parts = MeshBuilder().add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}}).parts();
  parts.coordinates.col(11) = Eigen::Vector3d(1.6, 0.6, 0.6);  // the corner (2 1 1) of the second element
  const Mesh mesh(parts);
  CHECK(turned_by(mesh, 11, {-0.01, 0, 0}).empty());  // inside out there before and after
  CHECK(turned_by(mesh, 2, {-1.5, 0, 0}) == Turned{1});
  std::swap(parts.blocks[0].nodes[0], parts.blocks[0].nodes[4]),
      std::swap(parts.blocks[0].nodes[1], parts.blocks[0].nodes[5]);
  std::swap(parts.blocks[0].nodes[2], parts.blocks[0].nodes[6]),
      std::swap(parts.blocks[0].nodes[3], parts.blocks[0].nodes[7]);
  CHECK(turned_by(Mesh(parts), 0, {0.1, 0.1, 0.1}).empty());  // the first has no volume to lose
}

TEST_CASE("shells are turned when they fold or turn over", "[core][mesh]") {
  MeshBuilder builder;
  builder.add_shells({.id = 1}).add_triangles({.id = 2, .origin = {3, 0, 0}});
  const Mesh mesh = builder.build();
  REQUIRE(mesh.n_elements() == 3);
  // Of the quadrilateral the area by its diagonals counts: 0 where the node at (1 1 0) meets the other
  // diagonal twice.
  CHECK(turned_by(mesh, 3, {-0.9, -0.9, 0}).empty());
  CHECK(turned_by(mesh, 3, {-1, -1, 0}) == Turned{0});
  CHECK(turned_by(mesh, 3, {-2, -2, 0}) == Turned{0});
  CHECK(turned_by(mesh, 3, {0, 0, 5}).empty());
  const auto nodes = mesh.element_nodes({1});
  const Eigen::Vector3d a = mesh.coordinates().col(nodes[0].value),
                        b = mesh.coordinates().col(nodes[1].value),
                        c = mesh.coordinates().col(nodes[2].value);
  const Eigen::Vector3d middle = 0.5 * (b + c);
  CHECK(turned_by(mesh, nodes[0].value, 0.9 * (middle - a)).empty());
  const auto over = turned_by(mesh, nodes[0].value, 1.1 * (middle - a));
  CHECK(std::count(over.begin(), over.end(), 1u) == 1);
}
