// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "contact/lofting/loft.hpp"
#include "support/catch.hpp"
#include "support/loft_shape.hpp"
#include "support/mesh_builder.hpp"

// Lofts of lines and particles. Round-off: coordinates are of order 1 and take part in a handful of
// operations, so 1e-12 is generous.

using namespace contactsim;
using namespace contactsim::test;

namespace {

Approx near(double value) { return Approx(value).epsilon(1e-12).margin(1e-12); }

/// Area of a regular hexagon with this circumscribed radius.
double hexagon(double radius) { return 1.5 * std::sqrt(3.0) * radius * radius; }

}  // namespace

TEST_CASE("a line becomes a hexagonal prism", "[contact][loft]") {
  const Mesh mesh = MeshBuilder().add_beams({.id = 1, .from = {1, 0, 0}, .to = {3, 0, 0}}).build();
  const LoftGeometry loft = loft_of(mesh, {.radius = 0.5});
  CHECK(loft.vertices.cols() == 12);
  CHECK(loft.facets.size() == 10);  // six sides, two quadrilaterals at either end
  CHECK(count_parts(loft, LoftPart::prism) == 10);
  CHECK(is_closed(loft));
  CHECK(enclosed_volume(loft) == near(2 * hexagon(0.5)));
  double area = 0.0;
  for (const LoftFacet& facet : loft.facets) {
    CHECK(facet.side == 1);
    const Eigen::Vector3d middle = corners_of(loft, facet).rowwise().mean();
    CHECK(normal_of(loft, facet).dot(middle - Eigen::Vector3d(2, 0, 0)) > 0.0);
    area += facet_area(loft, facet);
  }
  CHECK(area == near(6 * 0.5 * 2 + 2 * hexagon(0.5)));  // a hexagon's edge is its radius
  for (Eigen::Index v = 0; v < 12; ++v) {
    const Eigen::Vector3d x = loft.vertices.col(v);
    CHECK(std::hypot(x.y(), x.z()) == near(0.5));
    CHECK(x.x() == near(v < 6 ? 1 : 3));
  }
}

TEST_CASE("the prisms of a straight chain make one closed prism", "[contact][loft]") {
  // The second line runs against the first.
  MeshBuilder b;
  for (const double s : {0.0, 1.0, 3.0}) b.add_node(s * Eigen::Vector3d(0.6, 0, 0.8));
  const Mesh mesh = b.add_block(1, "", Shape::bar2, {0, 1, 2, 1}).build();
  const LoftGeometry loft = loft_of(mesh, {.radius = 0.2});
  CHECK(loft.facets.size() == 16);  // six sides each, two quadrilaterals at either free end
  CHECK(is_closed(loft));
  CHECK(enclosed_volume(loft) == near(3 * hexagon(0.2)));
}

TEST_CASE("lines that meet in a node have no caps there", "[contact][loft]") {
  MeshBuilder b;
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                   Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    b.add_node(x);
  }
  const Mesh mesh = b.add_block(1, "", Shape::beam2, {0, 1, 0, 2, 3, 0}).build();
  CHECK(loft_of(mesh, {.radius = 0.1}).facets.size() == 24);  // 3 (6 + 2)
  CHECK(loft_of(mesh, {{0}}, {.radius = 0.1}).facets.size() == 10);
}

TEST_CASE("a particle becomes a sphere", "[contact][loft]") {
  MeshBuilder b;
  b.add_shells({.id = 1});
  b.add_spheres(2, "", {{0, 5, 0}, {1, 1, 0}});
  const Mesh mesh = b.build();
  const LoftGeometry loft = loft_of(mesh, {.thickness = 0.1, .radius = 0.3});
  REQUIRE(loft.spheres.size() == 2);
  CHECK(loft.spheres[0].element.value == 1);
  CHECK(loft.spheres[0].radius == 0.3);
  CHECK(mesh.coordinates().col(loft.spheres[0].centre.value) == Eigen::Vector3d(0, 5, 0));
  CHECK(loft.spheres[1].centre == mesh.element_nodes({0})[2]);
  CHECK(loft.facets.size() == 6);
}
