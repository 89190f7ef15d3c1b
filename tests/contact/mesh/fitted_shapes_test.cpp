// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/fitted_shapes.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/ring_mesh.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string fit_all =
    "skin all blocks = on\nbegin interaction defaults\ngeneral contact = on\nsmoothing = auto\nend\n";

/// A ring of n elements, and a cube far away that it forms a pair with.
Mesh ring_and_cube(int n, double size = 1.0) {
  MeshBuilder b;
  add_ring(b, {.id = 1, .n = n, .from = 0.8 * size, .to = 1.0 * size, .turn = 0.1, .width = 0.2 * size});
  b.add_hexes({.id = 2, .origin = Vector3d(5, 0, 0) * size, .size = Vector3d::Ones() * size});
  return b.build();
}

}  // namespace

TEST_CASE("a ring has its two round sides and two flat ones, a cube six flat ones", "[contact][smoothing]") {
  const double size = GENERATE(1.0, 1e-3, 1e3);
  const Mesh mesh = ring_and_cube(16, size);
  const SmoothingShapes shapes = shapes_of_mesh(make_model(mesh, fit_all), mesh);
  CHECK(shapes.name == "AUTO");
  CHECK(shapes.is_automatic);
  const SurfaceShapes &ring = shapes.surfaces[{0}], &cube = shapes.surfaces[{1}];
  REQUIRE(ring.fitted.size() == 2);
  CHECK(ring.n_flat == 2);
  CHECK(ring.n_unfitted == 0);
  CHECK(std::min(ring.fitted[0].radius, ring.fitted[1].radius) == Approx(0.8 * size));
  CHECK(std::max(ring.fitted[0].radius, ring.fitted[1].radius) == Approx(size));
  for (const FittedShape& fitted : ring.fitted) {
    CHECK(fitted.n_faces == 16);
    CHECK(fitted.shape.kind == RoundShape::Kind::circumferential);
    CHECK(std::abs(fitted.shape.axis.z()) == Approx(1.0));
    CHECK(fitted.shape.origin.head<2>().norm() < 1e-9 * size);
    CHECK(fitted.residual < 1e-9 * size);
  }
  CHECK(cube.fitted.empty());
  CHECK(cube.n_flat == 6);
}

TEST_CASE("nine faces go round smoothly, eight have edges", "[contact][smoothing]") {
  const int n = GENERATE(8, 9);
  const Mesh mesh = ring_and_cube(n);
  const SurfaceShapes ring = shapes_of_mesh(make_model(mesh, fit_all), mesh).surfaces[{0}];
  CHECK(ring.fitted.size() == (n == 9 ? 2 : 0));
  CHECK(ring.n_flat == (n == 9 ? 2 : 2 + 2 * 8));
}

TEST_CASE("only surfaces of pairs with SMOOTHING = AUTO are fitted", "[contact][smoothing]") {
  const Mesh mesh = ring_and_cube(16);
  const auto shapes = [&](const std::string& lines) {
    return shapes_of_mesh(make_model(mesh, "skin all blocks = on\n" + lines), mesh).surfaces[{0}];
  };
  const SurfaceShapes none = shapes("begin interaction defaults\ngeneral contact = on\nend\n");
  CHECK(none.is_empty());
  CHECK(none.n_flat == 0);
  CHECK_FALSE(shapes("begin interaction\nsurfaces = block_2 block_1\nsmoothing = auto\nend\n").is_empty());
}

TEST_CASE("a side that is neither flat nor round is told with how far it is off", "[contact][smoothing]") {
  // A sheet that bends as x^2 along x and as x y beside: no axis, no centre.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {6, 6, 1}, .size = {6, 6, 1}});
  MeshParts parts = b.parts();
  for (Eigen::Index i = 0; i < parts.coordinates.cols(); ++i) {
    const double x = parts.coordinates(0, i) - 3.0, y = parts.coordinates(1, i) - 3.0;
    parts.coordinates(2, i) += 0.05 * x * x + 0.03 * x * y + 0.01 * x * x * x;
  }
  const Mesh mesh(std::move(parts));
  const SurfaceShapes sheet =
      shapes_of_mesh(make_model(mesh,
                                "skin all blocks = on\nbegin interaction defaults\nself contact = on\n"
                                "smoothing = auto\nend\n"),
                     mesh)
          .surfaces[{0}];
  CHECK(sheet.fitted.empty());
  CHECK(sheet.n_unfitted == 2);  // above and below
  CHECK(sheet.n_flat == 4);      // all around
  CHECK(sheet.least_residual > 1e-3);
}
