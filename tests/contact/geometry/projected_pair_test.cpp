// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/projected_pair.hpp"

#include <vector>

#include "support/catch.hpp"
#include "support/projected_overlap.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("bounds of the gap of two faces hold every point of both", "[contact][projected_pair]") {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const MovingFace first = random_face(random, i % 2 == 0, false, 0.3),
                     second = random_face(random, i % 3 == 0, true, 0.0);
    const auto pair = project_pair(first, second);
    REQUIRE(pair);
    for (int k = 0; k < 4; ++k) {
      for (int m = 0; m < 4; ++m) {
        const double apart = pair->plane.normal.dot(Eigen::Vector3d(first.x.col(k) - second.x.col(m)));
        CHECK(apart >= pair->min_gap - 1e-12);
        CHECK(apart <= pair->max_gap + 1e-12);
      }
      // Distances are kept.
      const Eigen::Vector3d edge = first.x.col(k) - first.x.col(0),
                            seen = pair->first.col(k) - pair->first.col(0);
      CHECK(seen.norm() == Approx(edge.norm()).margin(1e-12));
    }
  }
}

TEST_CASE("a pair that is turned round has the same gaps", "[contact][projected_pair]") {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const MovingFace first = random_face(random, i % 2 == 0, false, 0.3),
                     second = random_face(random, i % 3 == 0, true, 0.0);
    const auto pair = project_pair(first, second), turned = project_pair(second, first);
    REQUIRE((pair && turned));
    CHECK(turned->min_gap == Approx(pair->min_gap));
    CHECK(turned->max_gap == Approx(pair->max_gap));
  }
}

TEST_CASE("heights ahead of time are those that the faces move to", "[contact][projected_pair]") {
  MovingFace first = make_square(0.0, 0.5, false), second = make_square(0.0, 0.0, true);
  first.v.row(2).setConstant(-2.0);
  first.v.row(0).setConstant(7.0);  // along the plane they stay where they are
  second.v.row(2).setConstant(1.0);
  const auto now = project_pair(first, second), ahead = project_pair(first, second, 0.1);
  REQUIRE((now && ahead));
  CHECK(now->min_gap == Approx(0.5));
  CHECK(ahead->min_gap == Approx(0.5 - 0.3));
  CHECK(ahead->first.topRows<2>() == now->first.topRows<2>());
}

TEST_CASE("faces that look the same way are no pair", "[contact][projected_pair]") {
  CHECK_FALSE(project_pair(make_square(0.0, 0.5, true), make_square(0.0, 0.0, true)));
  CHECK(project_pair(make_square(0.0, 0.5, false), make_square(0.0, 0.0, true)));
}

TEST_CASE("faces are near where their boxes meet, and their gap lies between the limits",
          "[contact][projected_pair]") {
  const auto is_near_at = [](double aside, double gap) {
    const MovingFace first = make_square(aside, gap, false), second = make_square(0.0, 0.0, true);
    return project_one(first, second).are_near(0.1, 0.2)(0);
  };
  CHECK(is_near_at(0.0, 0.05));
  CHECK_FALSE(is_near_at(0.0, 0.1));
  CHECK(is_near_at(0.0, -0.19));
  CHECK_FALSE(is_near_at(0.0, -0.2));
  CHECK(is_near_at(0.9, 0.05));
  CHECK_FALSE(is_near_at(2.5, 0.05));
  CHECK_FALSE(is_near_at(-2.5, 0.05));
}

TEST_CASE("a face is warped by more than a height out of its plane, either way",
          "[contact][projected_pair]") {
  MovingFace first = make_square(0.0, 0.1, false), second = make_square(0.0, 0.0, true);
  const auto is_warped = [&](double flat) { return project_one(first, second).are_warped_1(flat)(0); };
  CHECK_FALSE(is_warped(0.0));
  for (const double height : {0.1, -0.1}) {
    first.x.row(2) << height, -height, height, -height;
    CHECK(is_warped(0.0999));
    CHECK_FALSE(is_warped(0.1001));
    CHECK_FALSE(project_one(first, second).are_warped_2(0.0)(0));
    CHECK(project_one(second, first).are_warped_2(0.0999)(0));
  }
  first.x.col(3) = first.x.col(2);
  first.is_triangle = true;
  CHECK_FALSE(is_warped(0.0));
}

TEST_CASE("eight pairs, or fewer, are projected as each of them alone", "[contact][projected_pair]") {
  Random random(7);
  std::vector<MovingFace> first, second;
  std::vector<FacePair> pairs;
  for (int k = 0; k < n_lanes; ++k) {
    first.push_back(random_face(random, k % 2 == 0, false, 0.3));
    second.push_back(random_face(random, k % 3 == 0, k != 5, 0.0));  // one looks the same way
  }
  for (std::size_t k = 0; k < n_lanes; ++k) {
    first[k].sharpness = 20.0 * static_cast<double>(k);
    pairs.push_back({&first[k], &second[k]});
    const ProjectedPairs projected(pairs, 0.01);
    for (std::size_t i = 0; i <= k; ++i) {
      const auto alone = project_pair(first[i], second[i], 0.01);
      const auto lane = static_cast<Eigen::Index>(i);
      REQUIRE(alone.has_value() == projected.planes.exist(lane));
      if (!alone) continue;
      const ProjectedPair pair = projected.of(lane);
      CHECK(pair.plane.normal == alone->plane.normal);
      CHECK(pair.plane.spread == alone->plane.spread);
      CHECK(pair.first == alone->first);
      CHECK(pair.second == alone->second);
      CHECK(pair.min_gap == alone->min_gap);
      for (std::size_t c = 0; c < 4; ++c) CHECK(pair.map_2.c[c] == alone->map_2.c[c]);
    }
  }
}

TEST_CASE("maps take the corners of triangles and quadrilaterals", "[contact][projected_pair]") {
  Random random(9);
  for (const bool is_triangle : {false, true}) {
    const MovingFace first = random_face(random, is_triangle, false, 0.1),
                     second = random_face(random, !is_triangle, true, 0.0);
    const ProjectedPair pair = project_one(first, second).of(0);
    const FaceMap expected = make_face_map(pair.first, is_triangle);
    CHECK(pair.map_1.is_triangle == is_triangle);
    CHECK(pair.map_2.is_triangle == !is_triangle);
    for (std::size_t c = 0; c < 4; ++c) CHECK((pair.map_1.c[c] - expected.c[c]).norm() < 1e-15);
  }
}
