// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/common_plane.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("the common plane lies between two faces that look at each other", "[contact][common_plane]") {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.1);
    const auto plane = make_common_plane(a.x, a.look(), b.look()),
               swapped = make_common_plane(b.x, b.look(), a.look());
    REQUIRE((plane && swapped));
    CHECK((plane->normal + swapped->normal).norm() < 1e-15);
    CHECK(plane->normal.dot(b.normal()) == Approx(-plane->normal.dot(a.normal())));
    CHECK(plane->normal.dot(b.normal()) > 0.9);
    CHECK((plane->across.cross(plane->along) - plane->normal).norm() < 1e-14);
    CHECK(plane->across.norm() == Approx(1.0));
  }
}

TEST_CASE("faces that stand at an angle have no common plane", "[contact][common_plane]") {
  const MovingFace floor = make_square(0.0, 0.0, true);
  const auto has_plane = [&](double cosine) {
    const Eigen::Vector3d normal(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    return make_common_plane(floor.x, floor.look(), {normal}).has_value();
  };
  CHECK(has_plane(-1.0));
  CHECK(has_plane(-0.31));
  CHECK(!has_plane(-0.29));
  CHECK(!has_plane(0.0));
  CHECK(!has_plane(1.0));
  CHECK(!has_plane(std::nan("")));
}

TEST_CASE("the flanks of blades and spikes face what these point at", "[contact][common_plane]") {
  const MovingFace floor = make_square(0.0, 0.0, true);
  const auto has_plane = [&](double cosine, double sharpness) {
    const Eigen::Vector3d normal(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    const FaceOrientation flank{normal, sharpness};
    const bool found = make_common_plane(floor.x, floor.look(), flank).has_value();
    CHECK(make_common_plane(floor.x, flank, floor.look()).has_value() == found);
    return found;
  };
  CHECK(has_plane(-0.06, 170.0));
  CHECK(!has_plane(-0.04, 170.0));
  CHECK(!has_plane(-0.29, 145.0));
  CHECK(has_plane(-0.29, 146.0));
}

TEST_CASE("a corner that leans is seen along the normal of the blunter face", "[contact][common_plane]") {
  const MovingFace floor = make_square(0.0, 0.0, true);
  const auto plane_at = [&](double degrees, double sharpness_of_floor, double sharpness) {
    const double angle = degrees * M_PI / 180.0;
    const Eigen::Vector3d normal(std::sin(angle), 0.0, -std::cos(angle));
    return make_common_plane(floor.x, {floor.look().area, sharpness_of_floor}, {normal, sharpness}).value();
  };
  const Eigen::Vector3d down(0.0, 0.0, -1.0);
  CHECK((plane_at(45.0, 0.0, 90.0).normal - down).norm() < 1e-3);
  CHECK(plane_at(45.0, 0.0, 90.0).spread == Approx(std::sqrt(2.0)).epsilon(2e-3));
  CHECK((plane_at(45.0, 90.0, 0.0).normal - Eigen::Vector3d(1.0, 0.0, -1.0).normalized()).norm() < 1e-3);
  // Neither is sharper, or they hardly lean: the mean.
  CHECK(plane_at(45.0, 90.0, 90.0).normal.dot(down) == Approx(std::cos(22.5 * M_PI / 180.0)));
  CHECK(plane_at(8.0, 0.0, 90.0).normal.dot(down) == Approx(std::cos(4.0 * M_PI / 180.0)));
  CHECK(plane_at(8.0, 0.0, 90.0).spread == Approx(1.0 / std::cos(4.0 * M_PI / 180.0)));
  const double between = plane_at(20.0, 0.0, 90.0).normal.dot(down);
  CHECK(between > std::cos(9.0 * M_PI / 180.0));
  CHECK(between < 0.99999);
}
