// SPDX-License-Identifier: BSD-3-Clause
// The contact points of two faces where momentum is balanced.
#include "contact/geometry/face_face_constraints.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double margin = 1e-4;

FaceFaceConstraints points_of(const MovingFace& first, const MovingFace& second, double depth = 1.0) {
  return find_face_face_constraints(first, second, {1.0, margin, 10.0 * margin, depth, 20.0 * margin});
}

double gap_of(const MovingFace& first, const MovingFace& second, const OverlapShare& point) {
  return point.normal.dot(first.x * point.weights_1 - second.x * point.weights_2);
}

/// A unit square that looks up, two opposite corners of it lifted by a height and two lowered.
MovingFace saddle(double height) {
  MovingFace face = make_square(0.0, 0.0, true);
  for (int k = 0; k < 4; ++k) face.x(2, k) = k % 2 == 0 ? height : -height;
  return face;
}

}  // namespace

TEST_CASE("flat faces have a point for each corner of the smaller one", "[contact][face_face]") {
  const MovingFace below = make_square(0.0, 0.0, true), above = make_square(0.25, -0.01, false, 0.5);
  const FaceFaceConstraints found = points_of(above, below);
  REQUIRE(found.n == 4);
  double area = 0.0;
  for (const OverlapShare& point : found.all()) {
    area += point.area;
    CHECK(gap_of(above, below, point) == Approx(-0.01));
    CHECK((point.normal - Vector3d(0, 0, 1)).norm() < 1e-14);
  }
  CHECK(area == Approx(0.25));
}

TEST_CASE("points of one overlap have numbers of their own, whichever face is the smaller one",
          "[contact][face_face]") {
  const MovingFace large = make_square(0.0, 0.0, true), small = make_square(0.25, -0.01, false, 0.5);
  const MovingFace aside = make_square(0.9, -0.01, false, 0.5);
  const FaceFaceConstraints of_first = points_of(small, large), of_second = points_of(large, small),
                            whole = points_of(aside, large);
  REQUIRE(of_first.n == 4);
  REQUIRE(of_second.n == 4);
  REQUIRE(whole.n == 1);
  std::set<int> numbers{whole.points[0].part};
  for (const OverlapShare& point : of_first.all()) numbers.insert(point.part);
  for (const OverlapShare& point : of_second.all()) numbers.insert(point.part);
  CHECK(numbers.size() == 9);
}

TEST_CASE("what rises from a warped face between the corners of another one is found",
          "[contact][face_face]") {
  const MovingFace below = saddle(0.1);
  // The middles of its sides stand on the ridge from (0, 0) to (1, 1), its corners at the height of the
  // middle.
  FaceCorners x;
  x.col(0) << 0.9, 0.5, 0.01;
  x.col(1) << 0.5, 0.1, 0.01;
  x.col(2) << 0.1, 0.5, 0.01;
  x.col(3) << 0.5, 0.9, 0.01;
  const MovingFace above = make_face(x);
  const FaceFaceConstraints found = points_of(above, below);
  REQUIRE(found.n >= 2);
  for (const OverlapShare& point : found.all()) CHECK(gap_of(above, below, point) < -0.005);
}

TEST_CASE("points of a warped face push square to its edges beside them", "[contact][face_face]") {
  const MovingFace below = saddle(0.1);
  // A narrow strip of a face lies on the edge at y = 0, along which the saddle is straight.
  FaceCorners x;
  x.col(0) << 0.3, -0.1, 0.0;
  x.col(1) << 0.3, 0.05, 0.0;
  x.col(2) << 0.7, 0.05, -0.05;
  x.col(3) << 0.7, -0.1, -0.05;
  const MovingFace above = make_face(x);
  const FaceFaceConstraints found = points_of(above, below);
  REQUIRE(found.n > 0);
  const Vector3d edge = (below.x.col(1) - below.x.col(0)).normalized();
  for (const OverlapShare& point : found.all()) CHECK(std::abs(point.normal.dot(edge)) < 0.05);
}

TEST_CASE("both sides of a contact point of faces coincide along its normal", "[contact][face_face]") {
  Random random(5);
  int n_points = 0;
  for (int i = 0; i < 300; ++i) {
    const MovingFace first = random_face(random, uniform(random, 0, 1) < 0.3, true, 0.0),
                     second = random_face(random, uniform(random, 0, 1) < 0.3, false, 0.02);
    const FaceFaceConstraints found = points_of(first, second);
    for (const OverlapShare& point : found.all()) {
      ++n_points;
      CHECK(point.weights_1.sum() == Approx(1.0));
      CHECK(point.weights_2.sum() == Approx(1.0));
      const Vector3d apart = first.x * point.weights_1 - second.x * point.weights_2;
      CHECK(apart.cross(point.normal).norm() < 1e-12);
    }
  }
  CHECK(n_points > 300);
}

TEST_CASE("constraints of eight pairs are those of each pair alone", "[contact][face_face]") {
  Random random(22);
  std::size_t n_points = 0;
  for (int i = 0; i < 30; ++i) {
    auto [first, second] = random_pairs(random, i, -0.1, 0.1);
    second[2].x.row(1).array() += 0.8;  // a small overlap
    std::vector<ConstrainedFaces> pairs;
    for (std::size_t k = 0; k < n_lanes; ++k) {
      const double closes = 0.005 * static_cast<double>(k);
      pairs.push_back({first[k], second[k], {0.01, closes, 2.0 * closes, 1.0, i % 2 == 0 ? 1.0 : 0.02}});
    }
    std::array<FaceFaceConstraints, n_lanes> together;
    find_face_face_constraints(pairs, together);
    for (std::size_t k = 0; k < n_lanes; ++k) {
      const FaceFaceConstraints alone = find_face_face_constraints(first[k], second[k], pairs[k].activation);
      REQUIRE(together[k].n == alone.n);
      n_points += alone.n;
      for (std::size_t c = 0; c < alone.n; ++c) {
        const OverlapShare &a = together[k].points[c], &b = alone.points[c];
        CHECK(a.part == b.part);
        CHECK(a.area == b.area);
        CHECK(a.normal == b.normal);
        CHECK(a.weights_1 == b.weights_1);
        CHECK(a.weights_2 == b.weights_2);
      }
    }
  }
  CHECK(n_points > 300);
}
