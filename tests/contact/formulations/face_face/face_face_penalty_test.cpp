// SPDX-License-Identifier: BSD-3-Clause
// Faces that the elastic penalty parts: forces, friction, damping, warped faces.
#include <algorithm>
#include <cmath>

#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "support/catch.hpp"
#include "support/cube_on_plate.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double plate_stiffness = 1000.0;

/// Height of four triangles about the middle of a unit square whose far corner is lifted by 1 [1].
double facet_height(double u, double v) {
  if (u + v < 1.0) return 0.5 * std::min(u, v);
  return u > v ? -0.5 + 0.5 * u + v : -0.5 + u + 0.5 * v;
}

}  // namespace

TEST_CASE("a cube in a plate is pushed out by stiffness, area and depth", "[contact][face_face_contacts]") {
  const bool cube_first = GENERATE(false, true);
  CubeOnPlate parts("", cube_first);
  parts.move_cube({0, 0, -0.01}, false);
  const auto points = parts.find();
  CHECK((parts.force_on_cube(points) - Vector3d(0, 0, 2.5)).norm() < 1e-12);
  REQUIRE(points.size() == 1);
  CHECK(points[0].area == Approx(0.25));
  CHECK(points[0].gap == Approx(-0.01));
  CHECK(points[0].stiffness == Approx(250.0));
  CHECK(points[0].first_entity < points[0].second_entity);
  CHECK(points[0].first.weights.sum() == Approx(1.0));
  CHECK(points[0].is_swapped == false);
  parts.move_cube({0.55, 0, 0}, false);  // over two cells
  parts.renew_candidates();
  CHECK(parts.find().size() == 2);
  CHECK((parts.force_on_cube(parts.find()) - Vector3d(0, 0, 2.5)).norm() < 1e-12);
}

TEST_CASE("friction goes on when a face slides from one partner to the next",
          "[contact][face_face_contacts]") {
  const bool cube_first = GENERATE(false, true);
  CubeOnPlate parts(
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 50\n",
      cube_first);
  parts.move_cube({0, 0, -0.1}, false);
  CHECK(parts.find().size() == 1);
  double slipped = 0.0;
  for (int step = 0; step < 100; ++step) {
    parts.move_cube({0.01, 0, 0});
    if (step % 10 == 0) parts.renew_candidates();
    const auto points = parts.find();
    slipped += 0.01;
    const Vector3d force = parts.force_on_cube(points);
    // It sticks all the way, over two edges. The sliver on a new partner, no wider than the way of a step,
    // may be a flush rim for that step.
    CHECK(force.z() == Approx(25.0).epsilon(0.021));
    CHECK(force.x() == Approx(-plate_stiffness * 0.25 * slipped).epsilon(0.021));
    CHECK(std::abs(force.y()) < 1e-9);
  }
}

TEST_CASE("friction slides at its limit and tells what it takes", "[contact][face_face_contacts]") {
  CubeOnPlate parts(
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.5\n");
  parts.move_cube({0, 0, -0.1}, false);
  parts.find();
  for (int step = 0; step < 10; ++step) {
    parts.move_cube({0.02, 0.0, 0});
    const auto points = parts.find();
    double lost = 0.0;
    for (const ContactPoint& point : points) lost += point.dissipated;
    const Vector3d force = parts.force_on_cube(points);
    CHECK(force.x() == Approx(-std::min(12.5, plate_stiffness * 0.25 * 0.02 * (step + 1))));
    CHECK(lost == Approx(step < 2 ? 0.0 : step == 2 ? 12.5 * 0.01 : 12.5 * 0.02).margin(1e-12));
  }
}

TEST_CASE("a warped face pushes by the depth behind each of its facets", "[contact][face_face_contacts]") {
  CubeOnPlate parts;
  constexpr double lift = 0.12;
  for (Eigen::Index i = 0; i < parts.x.cols(); ++i) {
    if (parts.x.col(i) == Vector3d(1, 2, 1)) parts.x(2, i) += lift;
  }
  // The bottom cuts through the facets: the cube covers [0.2, 0.7] x [0.1, 0.6] of the cell.
  constexpr double height = 0.018;
  parts.move_cube({0, 0, height}, false);
  parts.renew_candidates();
  const auto points = parts.find();
  CHECK(points.size() > 1);
  constexpr int n = 1000;
  double volume = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = 0.2 + 0.5 * (i + 0.5) / n, v = 0.1 + 0.5 * (j + 0.5) / n;
      volume += std::max(0.0, lift * facet_height(u, v) - height) * 0.25 / (n * n);
    }
  }
  // Depths along normals that lean by up to 0.13 are smaller by the cosine, and areas larger.
  CHECK(parts.force_on_cube(points).z() == Approx(plate_stiffness * volume).epsilon(1e-2));
  for (const ContactPoint& point : points) {
    CHECK(point.first.weights.sum() == Approx(1.0));
    CHECK(point.second.weights.sum() == Approx(1.0));
    CHECK(point.first.weights.minCoeff() > -1e-12);
  }
}

TEST_CASE("damping pushes by the speed of closing and tells what it takes", "[contact][face_face_contacts]") {
  CubeOnPlate parts("contact damping fraction = 0.1\n");
  // 2 z sqrt(k m) per area, the masses of both sides, 4 each, in series.
  const double damping = 0.2 * std::sqrt(plate_stiffness * 2.0);
  parts.move_cube({0, 0, 0.01}, false);
  CHECK(parts.find().empty());
  parts.move_cube({0, 0, -0.02});
  const auto points = parts.find();
  REQUIRE(points.size() == 1);
  CHECK(parts.force_on_cube(points).z() == Approx(0.25 * (plate_stiffness * 0.01 + damping * 0.02)));
  CHECK(points[0].damped == Approx(0.25 * damping * 0.02 * 0.02));
}

TEST_CASE("what turns up behind a face in a step has not come through it", "[contact][face_face_contacts]") {
  CubeOnPlate parts;
  parts.move_cube({0, 0, -0.3}, false);
  parts.size = 1.0;  // a step in which it has not moved
  CHECK(parts.find().empty());
  CubeOnPlate shallow;
  shallow.move_cube({0, 0, -0.019}, false);  // the elements are 1 thick
  shallow.size = 1.0;
  CHECK(shallow.find().size() == 1);
}

TEST_CASE("what is in front has no friction", "[contact][face_face_contacts]") {
  CubeOnPlate parts(
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 50\n");
  parts.move_cube({0, 0, 0.03}, false);
  parts.find();
  parts.move_cube({0.005, 0, -0.02});
  const auto points = parts.find();
  REQUIRE(points.size() == 1);
  CHECK(points[0].gap == Approx(0.01));
  CHECK(points[0].tangential.isZero(0.0));
  CHECK(points[0].elastic_slip.isZero(0.0));
}
