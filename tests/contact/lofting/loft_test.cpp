// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/loft_shape.hpp"
#include "support/mesh_builder.hpp"

// Round-off: coordinates are of order 1 and take part in a handful of operations, so 1e-12 is generous.

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr double tolerance = 1e-12;

Eigen::Matrix<double, 3, 4> corners(std::initializer_list<Eigen::Vector3d> points) {
  Eigen::Matrix<double, 3, 4> matrix;
  int column = 0;
  for (const Eigen::Vector3d& point : points) matrix.col(column++) = point;
  return matrix;
}

Approx near(double value) { return Approx(value).epsilon(tolerance).margin(tolerance); }

}  // namespace

TEST_CASE("a shell becomes a brick about its mesh surface", "[contact][loft]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.2});
  REQUIRE(loft.facets.size() == 6);
  CHECK(loft.vertices.cols() == 8);
  const auto check = [&](std::size_t i, LoftPart part, int side,
                         const Eigen::Matrix<double, 3, 4>& expected) {
    CHECK(loft.facets[i].part == part);
    CHECK(loft.facets[i].side == side);
    CHECK(loft.facets[i].element.value == 0);
    CHECK(corners_of(loft, loft.facets[i]).isApprox(expected, tolerance));
  };
  const double t = 0.1, b = -0.1;
  check(0, LoftPart::top, 1, corners({{0, 0, t}, {1, 0, t}, {1, 1, t}, {0, 1, t}}));
  check(1, LoftPart::bottom, 2, corners({{0, 0, b}, {0, 1, b}, {1, 1, b}, {1, 0, b}}));
  check(2, LoftPart::side, 3, corners({{0, 0, b}, {1, 0, b}, {1, 0, t}, {0, 0, t}}));
  check(3, LoftPart::side, 4, corners({{1, 0, b}, {1, 1, b}, {1, 1, t}, {1, 0, t}}));
  check(4, LoftPart::side, 5, corners({{1, 1, b}, {0, 1, b}, {0, 1, t}, {1, 1, t}}));
  check(5, LoftPart::side, 6, corners({{0, 1, b}, {0, 0, b}, {0, 0, t}, {0, 1, t}}));
  CHECK(facet_area(loft, loft.facets[0]) == near(1.0));
  CHECK(facet_area(loft, loft.facets[2]) == near(0.2));
}

TEST_CASE("the lofting factor is the share of the thickness on the normal's side", "[contact][loft]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  const double factor = GENERATE(0.0, 0.25, 1.0);
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.4, .lofting_factor = factor});
  CHECK(corners_of(loft, loft.facets[0]).row(2).isApproxToConstant(0.4 * factor, tolerance));
  CHECK(corners_of(loft, loft.facets[1]).row(2).isApproxToConstant(0.4 * factor - 0.4, tolerance));
  CHECK(enclosed_volume(loft) == near(0.4));
}

TEST_CASE("a flat patch has the volume of its area times its thickness", "[contact][loft]") {
  // 3 x 2 cells of 4.5 x 4: area 18, 10 edges on the perimeter. Its plane is tilted so that nothing is zero.
  const Sheet sheet{.id = 1, .cells = {3, 2}, .origin = {1, 2, 3}, .u = {2.7, 3.6, 0}, .v = {0, 0, 4}};
  const bool is_triangles = GENERATE(false, true);
  MeshBuilder b;
  const Mesh mesh = is_triangles ? b.add_triangles(sheet).build() : b.add_shells(sheet).build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.1, .lofting_factor = 0.3});
  CHECK(count_parts(loft, LoftPart::top) == (is_triangles ? 12 : 6));
  CHECK(count_parts(loft, LoftPart::bottom) == (is_triangles ? 12 : 6));
  CHECK(count_parts(loft, LoftPart::side) == 10);
  CHECK(is_closed(loft));
  CHECK(enclosed_volume(loft) == Approx(1.8).epsilon(1e-11));  // terms of order 100 cancel
  for (const LoftFacet& facet : loft.facets) {
    const bool is_triangle = facet.vertices[3] == facet.vertices[2];
    CHECK(is_triangle == (is_triangles && facet.part != LoftPart::side));
  }
}

TEST_CASE("the side of a triangular shell's edge has the edge's number", "[contact][loft]") {
  // A cell cut along its diagonal: triangle 1 has the edges 1-2, 2-3 free, triangle 2 the edges 2-3, 3-1.
  const Mesh mesh = MeshBuilder().add_triangles({.id = 1}).build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.2});
  std::vector<std::pair<std::uint32_t, int>> found;
  for (const LoftFacet& facet : loft.facets) found.emplace_back(facet.element.value, facet.side);
  CHECK(found == std::vector<std::pair<std::uint32_t, int>>{
                     {0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 1}, {1, 2}, {1, 4}, {1, 5}});
}

TEST_CASE("every loft vertex belongs to the node that it was lofted from", "[contact][loft]") {
  const Mesh mesh = MeshBuilder()
                        .add_shells({.id = 1, .cells = {2, 2}})
                        .add_beams({.id = 2, .cells = 2, .from = {0, 5, 0}, .to = {4, 5, 0}})
                        .build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.2, .radius = 0.1});
  REQUIRE(loft.node_of_vertex.size() == static_cast<std::size_t>(loft.vertices.cols()));
  CHECK(loft.vertices.cols() == 4 * 8 + 2 * 12);
  for (Eigen::Index v = 0; v < loft.vertices.cols(); ++v) {
    const NodeIndex node = loft.node_of_vertex[static_cast<std::size_t>(v)];
    CHECK((loft.vertices.col(v) - mesh.coordinates().col(node.value)).norm() == near(0.1));
  }
}

TEST_CASE("shells that look opposite ways make one closed brick", "[contact][loft]") {
  // Nodes 0 to 5 on a 2 x 1 strip, x fastest. The second shell is turned over.
  MeshBuilder b;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0, 2.0}) b.add_node({x, y, 0});
  }
  b.add_block(1, "", Shape::shell4, {0, 1, 4, 3, 1, 4, 5, 2});
  const LoftGeometry loft = loft_of(b.build(), {.thickness = 0.5});
  CHECK(is_closed(loft));
  CHECK(enclosed_volume(loft) == near(1.0));
  CHECK(count_parts(loft, LoftPart::side) == 6);
  for (const LoftFacet& facet : loft.facets) {
    const bool is_up = (facet.part == LoftPart::top) == (facet.element.value == 0);
    if (facet.part == LoftPart::side) continue;
    CHECK(normal_of(loft, facet).z() == near(is_up ? 1.0 : -1.0));
    CHECK(corners_of(loft, facet).row(2).isApproxToConstant(is_up ? 0.25 : -0.25, tolerance));
  }
}

TEST_CASE("shells that fold gently share a bent edge", "[contact][loft]") {
  // The first shell is flat; the second rises along (0.8, 0, 0.6), normal (-0.6, 0, 0.8), and is twice as
  // large: the sum of the area vectors at the fold is (0,0,1) + 2 (-0.6,0,0.8) = (-1.2, 0, 2.6).
  MeshBuilder b;
  b.add_shells({.id = 1});
  b.add_shells({.id = 2, .origin = {1, 0, 0}, .u = {1.6, 0, 1.2}});
  const LoftGeometry loft = loft_of(b.build(), {.thickness = 0.2});
  CHECK(is_closed(loft));
  CHECK(count_parts(loft, LoftPart::side) == 6);
  const Eigen::Vector3d normal = Eigen::Vector3d(-1.2, 0, 2.6) / std::sqrt(1.2 * 1.2 + 2.6 * 2.6);
  const Eigen::Vector3d fold = Eigen::Vector3d(1, 0, 0) + 0.1 * normal;
  CHECK((corners_of(loft, loft.facets[0]).col(1) - fold).norm() < tolerance);
  const auto second = std::find_if(loft.facets.begin(), loft.facets.end(),
                                   [](const LoftFacet& f) { return f.element.value == 1; });
  CHECK((corners_of(loft, *second).col(0) - fold).norm() < tolerance);
  CHECK((corners_of(loft, *second).col(1) - Eigen::Vector3d(2.6 - 0.06, 0, 1.2 + 0.08)).norm() < tolerance);
}

TEST_CASE("shells that fold sharply keep their own normals", "[contact][loft]") {
  // Flat, then upright: at right angles, beyond 60 degrees.
  MeshBuilder b;
  b.add_shells({.id = 1});
  b.add_shells({.id = 2, .origin = {1, 0, 0}, .u = {0, 0, 1}});
  const LoftGeometry loft = loft_of(b.build(), {.thickness = 0.2});
  CHECK(count_parts(loft, LoftPart::side) == 6);
  for (const LoftFacet& facet : loft.facets) {
    if (facet.part != LoftPart::top) continue;
    const auto x = corners_of(loft, facet);
    if (facet.element.value == 0) CHECK(x.row(2).isApproxToConstant(0.1, tolerance));
    if (facet.element.value == 1) CHECK(x.row(0).isApproxToConstant(0.9, tolerance));  // z x y = -x
  }
}

TEST_CASE("three shells at one edge have no side faces there", "[contact][loft]") {
  MeshBuilder b;
  b.add_shells({.id = 1, .cells = {2, 1}, .u = {2, 0, 0}});
  b.add_shells({.id = 2, .origin = {1, 0, 0}, .u = {0, 0, 1}});
  const LoftGeometry loft = loft_of(b.build(), {.thickness = 0.2});
  CHECK(count_parts(loft, LoftPart::side) == 9);  // 3 of 4 edges each
  // The flat shells stay flat over the joint.
  CHECK(corners_of(loft, loft.facets[0]).row(2).isApproxToConstant(0.1, tolerance));
}

TEST_CASE("only lofted shells count as neighbours", "[contact][loft]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1, .cells = {2, 1}}).build();
  const LoftGeometry loft = loft_of(mesh, {{1}}, {.thickness = 0.2});
  CHECK(count_parts(loft, LoftPart::side) == 4);
  CHECK(is_closed(loft));
  for (const LoftFacet& facet : loft.facets) CHECK(facet.element.value == 1);
}

TEST_CASE("a closed tube of shells has an inner and an outer skin and no perimeter inside",
          "[contact][loft]") {
  // A regular 12-gon of circumradius R has area 12/2 R^2 sin(30) = 3 R^2. Mean normals at its corners are
  // radial, so the skins have R + t/2 and R - t/2: volume 3 h ((R + t/2)^2 - (R - t/2)^2) = 6 R t h.
  constexpr std::uint32_t n = 12;
  MeshBuilder b;
  std::vector<std::uint32_t> nodes;
  for (const double z : {0.0, 3.0}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      b.add_node({2 * std::cos(angle), 2 * std::sin(angle), z});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    nodes.insert(nodes.end(), {i, j, n + j, n + i});
  }
  const LoftGeometry loft = loft_of(b.add_block(1, "", Shape::shell4, nodes).build(), {.thickness = 0.1});
  CHECK(is_closed(loft));
  CHECK(count_parts(loft, LoftPart::side) == 2 * n);  // the two rims
  CHECK(enclosed_volume(loft) == Approx(6 * 2 * 0.1 * 3).epsilon(1e-11));
}

TEST_CASE("lofts stand at the coordinates that are given", "[contact][loft]") {
  const Mesh mesh = MeshBuilder().add_shells({.id = 1}).build();
  Eigen::Matrix3Xd moved = mesh.coordinates();
  moved.row(0).array() += 10.0;
  moved.row(1) *= 2.0;
  const ElementIndex elements[] = {{0}};
  const LoftSize sizes[] = {{.thickness = 0.2}};
  const LoftGeometry loft = make_loft(mesh, moved, elements, sizes);
  CHECK(corners_of(loft, loft.facets[0])
            .isApprox(corners({{10, 0, 0.1}, {11, 0, 0.1}, {11, 2, 0.1}, {10, 2, 0.1}}), tolerance));
}

TEST_CASE("lofts turn with the mesh", "[contact][loft]") {
  MeshBuilder b;
  b.add_shells({.id = 1, .cells = {2, 2}});
  b.add_triangles({.id = 2, .origin = {1, 0, 0}, .u = {0.8, 0, 0.6}});
  const Mesh mesh = b.build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.1, .lofting_factor = 0.4});
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  MeshParts parts = b.parts();
  parts.coordinates = turn * parts.coordinates;
  const LoftGeometry turned = loft_of(Mesh(parts), {.thickness = 0.1, .lofting_factor = 0.4});
  CHECK(turned.vertices.isApprox(turn * loft.vertices, tolerance));
}

TEST_CASE("elements without extent are lofted to points and lines, not to NaN", "[contact][loft]") {
  MeshBuilder b;
  b.add_node({1, 2, 3});
  b.add_node({1, 2, 3});
  b.add_block(1, "", Shape::shell4, {0, 1, 1, 0});
  b.add_block(2, "", Shape::beam2, {0, 1});
  const LoftGeometry loft = loft_of(b.build(), {.thickness = 0.1, .radius = 0.1});
  CHECK(loft.vertices.allFinite());
}

TEST_CASE("nothing lofts to nothing", "[contact][loft]") {
  const LoftGeometry loft = loft_of(MeshBuilder().add_hexes({.id = 1}).build(), {{0}}, {.thickness = 1});
  CHECK(loft.vertices.cols() == 0);
  CHECK(loft.facets.empty());
  CHECK(loft_of(Mesh(), {}, {}).facets.empty());
}
