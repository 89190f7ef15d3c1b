// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_overlap.hpp"

#include "support/catch.hpp"
#include "support/projected_overlap.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("sums over a face grow by f at all points of a batch, or by that at one of each face",
          "[contact][face_overlap]") {
  FaceMoments moments{};
  MomentsOfFaces of_faces{};
  for (int i = 0; i < 2; ++i) {
    add_moments(2.0, 0.5, -0.25, moments);
    add_moments(2.0, 0.5, -0.25, of_faces);
  }
  const double expected[] = {4.0, 2.0, -1.0, -0.5};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(moments[k] == Approx(n_lanes * expected[k]));
    CHECK(moments_in(of_faces, 5)[k] == Approx(expected[k]));
  }
}

TEST_CASE("points are added one by one, and those that are missing have no area", "[contact][face_overlap]") {
  OverlapPoints points;
  for (int i = 0; i < n_lanes + 2; ++i) points.add({9.0, 1.0, 2.0, 3.0, 4.0, 5.0}, 0.5);
  REQUIRE(points.batches().size() == 2);
  CHECK(points.area == 5.0);
  CHECK(points.batches()[1].weight.sum() == 1.0);
  CHECK(points.batches()[1].eta_2(1) == 4.0);
  CHECK(points.batches()[1].weight(2) == 0.0);
}

TEST_CASE("points for products integrate the fourth degree", "[contact][face_overlap]") {
  MovingFace first, second;
  first.x << 0, 0, 2, 2, 0, 3, 3, 0, 0, 0, 0, 0;         // seen from below
  second.x << 0.5, 3, 3, 0.5, -1, -1, 2, 2, 0, 0, 0, 0;  // in common: 0.5 to 2 and 0 to 2
  ProjectedOverlap overlap(first, second);
  REQUIRE(overlap.area() == Approx(3.0));
  place_points_for_products(overlap.polygons.of(0), overlap.pair.map_1, overlap.pair.map_2, overlap.points);
  const auto on_first = [&](const Eigen::Vector3d& at) {
    return Eigen::Vector3d(overlap.pair.plane.origin + at.x() * overlap.pair.plane.across +
                           at.y() * overlap.pair.plane.along);
  };
  const double found = overlap.sum([&](const Eigen::Vector3d& at, const Eigen::Vector3d& /*on_second*/) {
    const Eigen::Vector3d x = on_first(at);
    return x.x() * x.x() * x.y() * x.y() + x.x() * x.x() * x.x() * x.y();
  });
  const double exact = (8.0 - 0.125) / 3.0 * 8.0 / 3.0 + (16.0 - 0.0625) / 4.0 * 2.0;
  CHECK(found == Approx(exact).epsilon(1e-12));
}
