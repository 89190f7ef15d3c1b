// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/facets.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace facets_test {

namespace {

/// A square of edge 2 about the origin whose corners stand by this height above and below the plane in turns.
MovingFace saddle(double height) {
  MovingFace face;
  face.x << -1, 1, 1, -1, -1, -1, 1, 1, height, -height, height, -height;
  face.v << 1, 2, 3, 4, 0, 0, 0, 0, 4, 8, 12, 0;
  face.sharpness = 30.0;
  return face;
}

}  // namespace

TEST_CASE("a flat face is its only facet", "[contact][facets]") {
  const Facets facets(saddle(0.1), false);
  REQUIRE(facets.all().size() == 1);
  CHECK(facets.all()[0].number == 0);
  CHECK(facets.all()[0].face.x == saddle(0.1).x);
  const Vector4d shares(0.1, 0.2, 0.3, 0.4);
  CHECK(facets.all()[0].to_face(shares) == shares);
}

TEST_CASE("a warped face has four triangles between two corners and the mean of all", "[contact][facets]") {
  const MovingFace whole = saddle(0.1);
  const Facets facets(whole, true);
  REQUIRE(facets.all().size() == 4);
  Vector3d area = Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const Facet& facet = facets.all()[k];
    const auto corner = static_cast<Eigen::Index>(k), next = (corner + 1) % 4;
    CHECK(facet.number == k + 1);
    CHECK(facet.face.is_triangle);
    CHECK(facet.face.sharpness == 30.0);
    CHECK(facet.face.x.col(0) == whole.x.col(corner));
    CHECK(facet.face.x.col(1) == whole.x.col(next));
    CHECK(facet.face.x.col(2).isZero(1e-15));  // the middle
    CHECK(facet.face.x.col(3) == facet.face.x.col(2));
    CHECK(facet.face.v.col(2).isApprox(Vector3d(2.5, 0, 6)));
    area += area_vector(facet.face.x);
  }
  CHECK(area.isApprox(area_vector(whole.x)));
}

TEST_CASE("shares of a facet are shares of the corners at the same point", "[contact][facets]") {
  const MovingFace whole = saddle(0.1);
  const Facets facets(whole, true);
  // Of the last facet: corners 4 and 1, and a quarter of the third share for each corner.
  CHECK(facets.all()[3].to_face({0.2, 0.4, 0.4, 0.0}).isApprox(Vector4d(0.5, 0.1, 0.1, 0.3)));
  for (const Facet& facet : facets.all()) {
    const Vector4d shares(0.5, 0.2, 0.3, 0.0), of_face = facet.to_face(shares);
    CHECK(of_face.sum() == Approx(1.0));
    CHECK((whole.x * of_face).isApprox(facet.face.x * shares));
  }
}

}  // namespace facets_test
