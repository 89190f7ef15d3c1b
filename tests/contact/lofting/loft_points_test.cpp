// SPDX-License-Identifier: BSD-3-Clause
// The points of the skins of lofted shells: each once, and along the normals of the shells as these turn.
#include "contact/lofting/loft_points.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/loft_shape.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// The ways from the nodes to the points, at coordinates.
Eigen::Matrix3Xd offsets_at(const LoftPoints& points, const Eigen::Matrix3Xd& coordinates) {
  Eigen::Matrix3Xd areas, offsets;
  points.find_offsets(coordinates, areas, offsets);
  CHECK(offsets.cols() == static_cast<Eigen::Index>(points.size()));
  return offsets;
}

/// Two unit shells that share an edge along y at x = 1; the second one is turned up by an angle, and its
/// normal may look the other way.
Mesh folded(double angle, bool is_turned) {
  MeshBuilder b;
  std::vector<std::uint32_t> nodes;
  for (const double y : {0.0, 1.0}) {
    b.add_node({0, y, 0});
    b.add_node({1, y, 0});
    b.add_node({1 + std::cos(angle), y, std::sin(angle)});
  }
  const std::vector<std::uint32_t> second =
      is_turned ? std::vector<std::uint32_t>{1, 4, 5, 2} : std::vector<std::uint32_t>{1, 2, 5, 4};
  b.add_block(1, "", Shape::shell4, {0, 1, 4, 3});
  b.add_block(2, "", Shape::shell4, second);
  return b.build();
}

}  // namespace

TEST_CASE("points stand where the vertices of the loft do, and each once", "[contact][loft_points]") {
  const bool is_triangles = GENERATE(false, true);
  const Sheet sheet{.id = 1, .cells = {2, 2}, .u = {2, 0.3, 0}, .v = {0, 2, 0.4}};
  MeshBuilder b;
  const Mesh mesh = is_triangles ? b.add_triangles(sheet).build() : b.add_shells(sheet).build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.4, .lofting_factor = 0.25});
  const LoftPoints points(loft, mesh);
  CHECK(points.size() == 2 * 9);  // above and below every node
  CHECK(points.shell_nodes().size() == (is_triangles ? 8 : 4));
  if (is_triangles) CHECK(points.shell_nodes()[0][2] == points.shell_nodes()[0][3]);
  const Eigen::Matrix3Xd offsets = offsets_at(points, mesh.coordinates());
  std::size_t n_above = 0;
  for (std::uint32_t vertex = 0; vertex < loft.vertices.cols(); ++vertex) {
    const auto point = points.of_vertex(vertex);
    REQUIRE(point);
    CHECK(points.node(*point) == loft.node_of_vertex[vertex]);
    const Vector3d x = mesh.coordinates().col(points.node(*point).value) + offsets.col(*point);
    CHECK((x - loft.vertices.col(vertex)).norm() < 1e-12);
    CHECK(points.thickness(*point) == 0.4);
    const bool is_above = offsets(2, *point) > 0.0;
    n_above += is_above ? 1 : 0;
    CHECK(points.distance(*point) == Approx(is_above ? 0.1 : 0.3));
  }
  CHECK(2 * n_above == static_cast<std::size_t>(loft.vertices.cols()));
}

TEST_CASE("shells whose normals look either way share the points at their edge", "[contact][loft_points]") {
  const bool is_turned = GENERATE(false, true);
  const double angle = 0.4;
  const Mesh mesh = folded(angle, is_turned);
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.2});
  const LoftPoints points(loft, mesh);
  CHECK(points.size() == 12);
  const Eigen::Matrix3Xd offsets = offsets_at(points, mesh.coordinates());
  const Vector3d mean(-std::sin(0.5 * angle), 0, std::cos(0.5 * angle));
  std::size_t n_at_edge = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.node(i) != NodeIndex{1} && points.node(i) != NodeIndex{4}) continue;
    ++n_at_edge;
    const Vector3d way = offsets.col(static_cast<Eigen::Index>(i));
    CHECK((way - (way.z() > 0.0 ? 0.1 : -0.1) * mean).norm() < 1e-12);
  }
  CHECK(n_at_edge == 4);
}

TEST_CASE("points follow the normals of the shells that they had at the start", "[contact][loft_points]") {
  const Mesh mesh = folded(0.0, true);
  const LoftPoints points(loft_of(mesh, {.thickness = 0.2}), mesh);
  // Folded by a right angle, which would part the normals of a new loft.
  const Mesh bent = folded(0.5 * 3.14159265358979323846, true);
  const Eigen::Matrix3Xd offsets = offsets_at(points, bent.coordinates());
  const double half = 0.1 * std::sqrt(0.5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d way = offsets.col(static_cast<Eigen::Index>(i));
    const double sign = way.z() - way.x() > 0.0 ? 1.0 : -1.0;
    const std::uint32_t node = points.node(i).value % 3;
    const Vector3d expected = node == 0   ? Vector3d(0, 0, 0.1)
                              : node == 1 ? Vector3d(-half, 0, half)
                                          : Vector3d(-0.1, 0, 0);
    CHECK((way - sign * expected).norm() < 1e-12);
  }
  // Larger shells count by their area.
  Eigen::Matrix3Xd stretched = bent.coordinates();
  for (const Eigen::Index node : {2, 5}) stretched(2, node) = 3.0;
  const Eigen::Matrix3Xd weighted = offsets_at(points, stretched);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.node(i) != NodeIndex{1}) continue;
    const Vector3d way = weighted.col(static_cast<Eigen::Index>(i));
    CHECK(std::abs(way.x() / way.z()) == Approx(3.0));
  }
}

TEST_CASE("vertices that no shell offsets have no point", "[contact][loft_points]") {
  MeshBuilder b;
  b.add_shells({.id = 1});
  b.add_beams({.id = 2, .from = {0, 0, 3}, .to = {1, 0, 3}});
  const Mesh mesh = b.build();
  const std::vector<ElementIndex> elements{{0}, {1}};
  const std::vector<LoftSize> sizes{{.thickness = 0.2}, {.radius = 0.1}};
  const LoftGeometry loft = make_loft(mesh, mesh.coordinates(), elements, sizes);
  const LoftPoints points(loft, mesh);
  CHECK(points.size() == 8);
  std::size_t n_without = 0;
  for (std::uint32_t vertex = 0; vertex < loft.vertices.cols(); ++vertex)
    n_without += points.of_vertex(vertex) ? 0 : 1;
  CHECK(n_without == static_cast<std::size_t>(loft.vertices.cols()) - 8);
  CHECK(n_without > 0);
  CHECK(LoftPoints().size() == 0);
}
