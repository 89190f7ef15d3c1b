// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_distance.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A square of edge 2 about a point, whose normal is up.
FaceCorners square(const Vector3d& centre) {
  FaceCorners x;
  x << -1, 1, 1, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  return x.colwise() + centre;
}

FaceCorners triangle() {
  FaceCorners x;
  x << 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  return x;
}

}  // namespace

TEST_CASE("a point is as far from a face as from its nearest point", "[contact][face_distance]") {
  CHECK(distance_to_face({0.3, -0.2, 0.5}, square({0, 0, 0})) == Approx(0.5));
  CHECK(distance_to_face({0.3, -0.2, -0.5}, square({0, 0, 0})) == Approx(0.5));
  CHECK(distance_to_face({4, 0, 4}, square({0, 0, 0})) == Approx(5.0));
  CHECK(distance_to_face({4, 5, 12}, square({0, 0, 0})) == Approx(13.0));
  CHECK(distance_to_face({1, 1, 0}, triangle()) == Approx(std::sqrt(0.5)));
}

TEST_CASE("faces are as far apart as their nearest points", "[contact][face_distance]") {
  CHECK(face_distance(square({0, 0, 0}), square({0.5, 0.5, 0.7})) == Approx(0.7));
  CHECK(face_distance(square({0, 0, 0}), square({5, 0, 4})) == Approx(5.0));
  CHECK(face_distance(square({0, 0, 0}), triangle()) == 0.0);
}

TEST_CASE("long faces that cross are as far apart as their middles", "[contact][face_distance]") {
  FaceCorners along = square({0, 0, 0}), across = square({0, 0, 0.4});
  along.row(0) *= 10.0;
  across.row(1) *= 10.0;
  CHECK(face_distance(along, across) == Approx(0.4));
}

TEST_CASE("a face that another one goes through is at no distance", "[contact][face_distance]") {
  FaceCorners upright;
  upright << 0, 0, 0, 0, -0.1, 0.1, 0.1, -0.1, -0.5, -0.5, 0.5, 0.5;
  CHECK(face_distance(square({0, 0, 0}), upright) == 0.0);
}
