// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/node_face.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// The distance to the nearest of many points of a face.
double distance_by_sampling(const MovingFace& face, const Vector3d& point) {
  constexpr int n = 60;
  const FaceMap map = make_face_map(face.x, face.is_triangle);
  double least = 1e300;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= (face.is_triangle ? n - i : n); ++j) {
      const double a = double(i) / n, b = double(j) / n;
      const Vector3d on_face = face.is_triangle ? map.at(a, b) : map.at(2 * a - 1, 2 * b - 1);
      least = std::min(least, (point - on_face).norm());
    }
  }
  return least;
}

/// A point beside a face that may be a triangle, warped, without area or far away.
struct FacePoint {
  MovingFace face;
  Vector3d point;

  explicit FacePoint(Random& random)
      : face(random_face(random, random() % 2 == 0, random() % 2 == 0, 0.0)),
        point(random_vector(random, 1.0)) {
    const auto kind = random() % 12;
    if (kind == 0) face.x.col(0) = face.x.col(1) = face.x.col(2);
    if (kind == 1) point *= 30.0;
    if (kind == 2) point[1] = std::nan("");
    if (kind == 3) point = face.x.col(0);
    if (kind == 4) face.x.colwise() += 1e6 * Vector3d::Ones();
    if (kind == 5) face.x *= 1e-160;  // what is square to it has no length
  }
};

bool are_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool are_same(const std::optional<ClosestPoint>& a, const std::optional<ClosestPoint>& b) {
  if (!a || !b) return !a && !b;
  for (int i = 0; i < 3; ++i) {
    if (!are_same_bits(a->normal[i], b->normal[i])) return false;
  }
  return are_same_bits(a->xi, b->xi) && are_same_bits(a->eta, b->eta) && are_same_bits(a->gap, b->gap) &&
         are_same_bits(a->beyond, b->beyond) && a->edge == b->edge;
}

ClosestPoint project_on(const MovingFace& face, const Vector3d& point) {
  return project_onto_face(face.x, face.is_triangle, point).value();
}

}  // namespace

TEST_CASE("a point over a warped face is found where it was put", "[contact][node_face]") {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const MovingFace face = random_face(random, i % 2 == 0, i % 3 == 0, 0.0);
    const FaceMap map = make_face_map(face.x, face.is_triangle);
    const double xi = uniform(random, 0.05, 0.45), eta = uniform(random, 0.05, 0.45);
    const Vector3d normal = (map.c[1] + eta * map.c[3]).cross(map.c[2] + xi * map.c[3]).normalized();
    const double gap = uniform(random, -0.2, 0.2);
    const Vector3d point = map.at(xi, eta) + gap * normal;
    const ClosestPoint found = project_on(face, point);
    CHECK(found.xi == Approx(xi).epsilon(1e-10));
    CHECK(found.eta == Approx(eta).epsilon(1e-10));
    CHECK(found.gap == Approx(gap).epsilon(1e-10).margin(1e-13));
    CHECK((found.normal - normal).norm() < 1e-10);
    CHECK(found.normal.dot(face.normal()) > 0.5);
    CHECK_FALSE(found.edge);
    CHECK(found.beyond == 0.0);
    const double slow = distance_by_sampling(face, point);
    CHECK(std::abs(found.gap) <= slow + 1e-12);
    CHECK(slow < std::abs(found.gap) + 0.02);  // half the diagonal between samples
  }
}

TEST_CASE("a point beside a square is beyond the nearest edge by its distance", "[contact][node_face]") {
  const MovingFace square = make_square(0.0, 0.0, true);
  const std::vector<std::pair<Vector3d, std::uint32_t>> points{
      {{0.5, -0.1, 0.3}, 0}, {{1.1, 0.5, 0.3}, 1}, {{0.5, 1.1, 0.3}, 2}, {{-0.1, 0.5, 0.3}, 3}};
  for (const auto& [point, edge] : points) {
    const ClosestPoint found = project_on(square, point);
    CHECK(found.edge == edge);
    CHECK(found.beyond == Approx(0.1));
    CHECK(found.gap == Approx(0.3));
  }
  CHECK(project_on(square, {1.3, 1.4, -0.2}).beyond == Approx(0.5));
  CHECK(project_on(square, {1.3, 1.4, -0.2}).gap == Approx(-0.2));
  CHECK(project_on(square, {1.0, 1.0, 0.1}).beyond < 1e-15);
}

TEST_CASE("a point beside a triangle is beyond the nearest edge by its distance", "[contact][node_face]") {
  FaceCorners x;
  x << 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  const MovingFace triangle = make_face(x);
  CHECK(project_on(triangle, {0.4, -0.1, 0.3}).edge == 0u);
  CHECK(project_on(triangle, {0.4, -0.1, 0.3}).beyond == Approx(0.1));
  CHECK(project_on(triangle, {0.7, 0.5, 0.3}).edge == 1u);
  CHECK(project_on(triangle, {0.7, 0.5, 0.3}).beyond == Approx(0.1 * std::sqrt(2.0)));
  CHECK(project_on(triangle, {-0.2, 0.4, -0.3}).edge == 2u);
  CHECK(project_on(triangle, {-0.2, 0.4, -0.3}).beyond == Approx(0.2));
  CHECK(project_on(triangle, {-0.2, 0.4, -0.3}).gap == Approx(-0.3));
  CHECK(project_on(triangle, {1.5, -0.1, 0.0}).beyond == Approx(std::hypot(0.5, 0.1)));
}

TEST_CASE("a projection turns with the face and does not mind where corners are counted from",
          "[contact][node_face]") {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const MovingFace face = random_face(random, i % 2 == 0, true, 0.0);
    const Vector3d point = face.x.rowwise().mean() + random_vector(random, 0.2);
    const ClosestPoint found = project_on(face, point), other = project_on(renumbered(face), point);
    CHECK(other.gap == Approx(found.gap).margin(1e-12));
    CHECK((other.normal - found.normal).norm() < 1e-10);
    const Eigen::Matrix3d rotation = random_rotation(random);
    const Vector3d shift = random_vector(random, 5.0);
    const ClosestPoint moved = project_on(turned(face, rotation, shift), rotation * point + shift);
    CHECK(moved.gap == Approx(found.gap).margin(1e-12));
    CHECK((moved.normal - rotation * found.normal).norm() < 1e-10);
    CHECK(moved.xi == Approx(found.xi).margin(1e-10));
  }
}

TEST_CASE("a point far away, one that is nowhere and a face without area have no projection",
          "[contact][node_face]") {
  const MovingFace square = make_square(0.0, 0.0, true);
  CHECK(!project_onto_face(square.x, false, {20.0, 0.5, 0.0}));
  CHECK(!project_onto_face(square.x, false, {std::nan(""), 0.5, 0.0}));
  CHECK(!project_onto_face(FaceCorners::Zero(), false, {0.0, 0.0, 1.0}));
  CHECK(!project_onto_face(FaceCorners::Zero(), true, {0.0, 0.0, 1.0}));
}

TEST_CASE("points that are projected together are where each would be alone, to the bit",
          "[contact][node_face]") {
  Random random(3);
  ProjectionLanes lanes;
  int n_found = 0, n_lost = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<FacePoint> all;
    const std::size_t n = 1 + random() % n_lanes;
    for (std::size_t k = 0; k < n; ++k) {
      all.emplace_back(random);
      lanes.add(all[k].face.x, all[k].face.is_triangle, all[k].point);
    }
    CHECK(lanes.are_full() == (n == n_lanes));
    REQUIRE(lanes.size() == n);
    const auto found = lanes.project();
    lanes.clear();
    for (std::size_t k = 0; k < n; ++k) {
      const auto alone = project_onto_face(all[k].face.x, all[k].face.is_triangle, all[k].point);
      if (!are_same(found[k], alone)) FAIL("lane " << k << " of " << n << " differs");
      (alone ? n_found : n_lost) += 1;
    }
  }
  CHECK(n_found > 5000);
  CHECK(n_lost > 1000);
}

TEST_CASE("coordinates move into a face to its nearest point there", "[contact][node_face]") {
  const auto moved = [](bool is_triangle, double xi, double eta) {
    const auto edge = move_inside(is_triangle, xi, eta);
    return std::array{edge ? static_cast<double>(*edge) : -1.0, xi, eta};
  };
  CHECK(moved(false, 0.5, -0.5) == std::array{-1.0, 0.5, -0.5});
  CHECK(moved(false, 1.5, -1.25) == std::array{1.0, 1.0, -1.0});
  CHECK(moved(false, -1.0, 1.0) == std::array{-1.0, -1.0, 1.0});
  CHECK(moved(true, 0.25, 0.5) == std::array{-1.0, 0.25, 0.5});
  CHECK(moved(true, 0.75, 0.75) == std::array{1.0, 0.5, 0.5});
  CHECK(moved(true, -0.5, 2.0) == std::array{1.0, 0.0, 1.0});
  CHECK(moved(true, -0.25, 0.5) == std::array{2.0, 0.0, 0.5});
}
