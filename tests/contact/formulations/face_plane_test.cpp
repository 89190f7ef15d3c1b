// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_plane.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

MovingFace unit_quad() {
  MovingFace face;
  face.x << 0, 2, 3, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  return face;
}

MovingFace triangle() {
  MovingFace face;
  face.is_triangle = true;
  face.x << 0, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1;
  return face;
}

/// The parallelogram (0, 0), (4, 0), (5, 2), (1, 2): x = (2.5, 1) + xi (2, 0) + eta (0.5, 1).
MovingFace parallelogram() {
  MovingFace face;
  face.x << 0, 4, 5, 1, 0, 0, 2, 2, 0, 0, 0, 0;
  return face;
}

}  // namespace

TEST_CASE("weights of a way along a face by hand", "[contact][face_plane]") {
  // (2.5, 1) is xi = 1, eta = 1, and the weights change by (-xi - eta, xi - eta, xi + eta, eta - xi) / 4.
  CHECK(weights_of_way(parallelogram(), {2.5, 1, 0}).isApprox(Eigen::Vector4d(-0.5, 0, 0.5, 0)));
  // (2, 0) is xi = 1 alone.
  CHECK(weights_of_way(parallelogram(), {2, 0, 0}).isApprox(Eigen::Vector4d(-0.25, 0.25, 0.25, -0.25)));
  // Of the triangle (0, 0), (1, 0), (0, 1) the coordinates are x and y themselves.
  CHECK(weights_of_way(triangle(), {3, -2, 0}).isApprox(Eigen::Vector4d(-1, 3, -2, 0)));
  CHECK(weights_of_way(parallelogram(), Vector3d::Zero()).isZero(0.0));
}

TEST_CASE("a way out of the plane of a face counts as far as it lies in it", "[contact][face_plane]") {
  CHECK(weights_of_way(triangle(), {3, -2, 7}).isApprox(Eigen::Vector4d(-1, 3, -2, 0)));
}

TEST_CASE("a face without area has no weights of a way", "[contact][face_plane]") {
  MovingFace line = triangle();
  line.x << 0, 1, 2, 2, 0, 0, 0, 0, 0, 0, 0, 0;
  CHECK(weights_of_way(line, {1, 0, 0}).isZero(0.0));
}

TEST_CASE("the plane of a face goes on beyond its edges", "[contact][face_plane]") {
  for (const MovingFace& face : {unit_quad(), triangle()}) {
    for (const Vector3d& point : {Vector3d(9, -3, 1.25), Vector3d(-40, 30, 1.25), Vector3d(0.2, 0.3, 0.5)}) {
      const PlanePoint found = project_onto_plane(face, point);
      CHECK(found.normal.isApprox(Vector3d::UnitZ()));
      CHECK(found.gap == Approx(point.z() - face.x(2, 0)));
      CHECK(found.weights.sum() == Approx(1.0));
      // Right below the point: forces along the normal leave no moment.
      CHECK((face.x * found.weights - (point - found.gap * found.normal)).norm() < 1e-12);
    }
  }
}

TEST_CASE("the plane of a warped face goes on flat from its edge", "[contact][face_plane]") {
  MovingFace face = unit_quad();
  face.x(2, 2) = 0.1;
  const PlanePoint at = project_onto_plane(face, {3.001, 0.5, 0.0}),
                   far = project_onto_plane(face, {6, 0.5, 0.0});
  CHECK(at.normal.isApprox(far.normal));
  CHECK((face.x * far.weights + far.gap * far.normal - Vector3d(6, 0.5, 0.0)).norm() < 1e-12);
  CHECK(far.beyond > at.beyond);
}
