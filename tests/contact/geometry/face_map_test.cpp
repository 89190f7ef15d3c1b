// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_map.hpp"

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr std::array<std::array<double, 2>, 4> square_corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
constexpr std::array<std::array<double, 2>, 3> triangle_corners{{{0, 0}, {1, 0}, {0, 1}}};

}  // namespace

TEST_CASE("a face's map takes the values of the corners at the corners", "[contact][face_map]") {
  Random random(1);
  const MovingFace quad = random_face(random, false, true, 0.3), tri = random_face(random, true, false, 2.0);
  const FaceMap of_quad = make_face_map(quad.x, false), of_tri = make_face_map(tri.x, true);
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d there = of_quad.at(square_corners[k][0], square_corners[k][1]);
    CHECK((there - quad.x.col(static_cast<int>(k))).norm() < 1e-15);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d there = of_tri.at(triangle_corners[k][0], triangle_corners[k][1]);
    CHECK((there - tri.x.col(static_cast<int>(k))).norm() < 1e-15);
  }
  CHECK((of_quad.centre() - quad.x.rowwise().mean()).norm() < 1e-15);
  CHECK((of_tri.centre() - tri.x.leftCols<3>().rowwise().mean()).norm() < 1e-15);
}

TEST_CASE("weights of the corners give a face's points and sum to one", "[contact][face_map]") {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const bool is_triangle = i % 2 == 0;
    const MovingFace face = random_face(random, is_triangle, true, 0.0);
    const FaceMap map = make_face_map(face.x, is_triangle);
    const double xi = uniform(random, 0.0, 0.5), eta = uniform(random, 0.0, 0.5);
    const Eigen::Vector4d weights = corner_weights(xi, eta, is_triangle);
    CHECK(weights.sum() == Approx(1.0).epsilon(1e-15));
    CHECK((face.x * weights - map.at(xi, eta)).norm() < 1e-15);
  }
  CHECK(corner_weights(0.5, -1.0, false) == Eigen::Vector4d(0.25, 0.75, 0.0, 0.0));
  CHECK(corner_weights(0.25, 0.25, true) == Eigen::Vector4d(0.5, 0.25, 0.25, 0.0));
}

TEST_CASE("corners share a sum by its moments", "[contact][face_map]") {
  // A force of 3 at (0.5, -1) and one of 1 at (-1, 1): corner 3 gets all of the second.
  const FaceMoments moments{4.0, 3.0 * 0.5 - 1.0, -3.0 + 1.0, -3.0 * 0.5 - 1.0};
  CHECK(corner_shares(moments, false) == Eigen::Vector4d(0.75, 2.25, 0.0, 1.0));
  // The same of a triangle_corners: 2 at (0.5, 0.5), between its last corners, and 1 at the first corner.
  CHECK(corner_shares({3.0, 1.0, 1.0, 0.5}, true) == Eigen::Vector4d(1.0, 1.0, 1.0, 0.0));
}

TEST_CASE("the area vector of a face is its projected area", "[contact][face_map]") {
  FaceCorners x;
  x << 0, 2, 2, 0, 0, 0, 3, 3, 0, 0, 0, 0;
  CHECK(area_vector(x) == Eigen::Vector3d(0, 0, 6));
  x(2, 1) = x(2, 3) = 0.5;  // warped: seen from above it is the same
  CHECK(area_vector(x).z() == 6.0);
  x << 0, 2, 0, 0, 0, 0, 3, 3, 0, 0, 0, 0;
  CHECK(area_vector(x) == Eigen::Vector3d(0, 0, 3));
}
