// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/round_shape.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

const Vector3d shape_origin(0.3, -0.2, 0.5), shape_axis = Vector3d(1, 2, -2) / 3.0;

RoundShape leaning_shape(RoundShape::Kind kind) { return {kind, shape_origin, shape_axis, 2.0}; }

}  // namespace

TEST_CASE("the radius of a point is its distance from the middle of the shape", "[contact][round_shape]") {
  const Vector3d across = shape_axis.unitOrthogonal();
  const RoundShape cylinder = leaning_shape(RoundShape::Kind::circumferential),
                   sphere = leaning_shape(RoundShape::Kind::spherical),
                   torus = leaning_shape(RoundShape::Kind::toroidal);
  const Vector3d x = shape_origin + 3.0 * across + 4.0 * shape_axis;
  CHECK(cylinder.radius_of(x) == Approx(3.0));
  CHECK(cylinder.way_to(x).isApprox(3.0 * across));
  CHECK(sphere.radius_of(x) == Approx(5.0));
  CHECK(torus.radius_of(x) == Approx(std::hypot(1.0, 4.0)));  // 1 outside the circle, 4 over it
  CHECK(torus.way_to(x).isApprox(across + 4.0 * shape_axis));
  // Inside the circle the way points to the axis.
  const Vector3d inside = shape_origin + 1.5 * across;
  CHECK(torus.way_to(inside).isApprox(-0.5 * across));
}

TEST_CASE("on the axis a way has no direction and no trouble", "[contact][round_shape]") {
  const Vector3d x = shape_origin;
  for (const auto kind :
       {RoundShape::Kind::circumferential, RoundShape::Kind::spherical, RoundShape::Kind::toroidal})
    CHECK(leaning_shape(kind).way_to(x).allFinite());
}

TEST_CASE("ways along a face have the derivatives of their differences", "[contact][round_shape]") {
  const auto kind =
      GENERATE(RoundShape::Kind::circumferential, RoundShape::Kind::spherical, RoundShape::Kind::toroidal);
  const RoundShape shape = leaning_shape(kind);
  const auto place = [](double xi, double eta) {
    return Vector3d(3.0 + xi - 0.2 * eta * eta, 1.0 + 0.3 * xi * xi + eta, 0.2 * xi * eta);
  };
  const double xi = 0.3, eta = -0.6;
  const FaceVector at{place(xi, eta), Vector3d(1, 0.6 * xi, 0.2 * eta), Vector3d(-0.4 * eta, 1, 0.2 * xi)};
  const FaceVector way = shape.way_to(at);
  constexpr double probe = 1e-5;
  const Vector3d by_xi =
      (shape.way_to(place(xi + probe, eta)) - shape.way_to(place(xi - probe, eta))) / (2 * probe);
  const Vector3d by_eta =
      (shape.way_to(place(xi, eta + probe)) - shape.way_to(place(xi, eta - probe))) / (2 * probe);
  CHECK(way.value.isApprox(shape.way_to(at.value)));
  CHECK((way.by_xi - by_xi).norm() < 1e-9);
  CHECK((way.by_eta - by_eta).norm() < 1e-9);
}
