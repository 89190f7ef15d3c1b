// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_bound.hpp"

#include <limits>

#include "contact/geometry/face_face.hpp"
#include "contact/geometry/node_face.hpp"
#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

FaceBound bound_of(const MovingFace& face) { return {face.x, face.v, face.is_triangle}; }

/// The smallest gap in the overlap of two faces; infinite where they have none.
double smallest_gap(const MovingFace& first, const MovingFace& second) {
  double smallest = std::numeric_limits<double>::infinity();
  const auto found = find_face_face_points(first, second);
  if (!found) return smallest;
  for (const OverlapBatch& batch : found->points.batches())
    smallest = std::min(smallest, (batch.weight > 0.0).select(batch.gap, smallest).minCoeff());
  return smallest;
}

}  // namespace

TEST_CASE("the bound of a square by hand", "[contact][face_bound]") {
  MovingFace face = make_square(2.0, 5.0, true, 4.0);
  face.v.row(2) << 1, 1, 1, 5;
  const FaceBound bound = bound_of(face);
  CHECK(bound.centre().isApprox(Vector3d(4, 2, 5)));
  CHECK(bound.radius() == Approx(2.0 * std::sqrt(2.0)));
  CHECK(bound.normal().isApprox(Vector3f::UnitZ()));
  CHECK(bound.velocity().isApprox(Vector3f(0, 0, 2)));
  CHECK(bound.normal_velocity_spread() == Approx(3.0));
  CHECK(bound.warp() == Approx(0.0).margin(1e-6));
  CHECK(bound.half(0).cwiseAbs().maxCoeff() == Approx(2.0));
  CHECK(std::abs(bound.half(0).dot(bound.half(1))) < 1e-6f);
  CHECK(bound.height_of({9, 9, 4}) == Approx(-1.0));
  CHECK(bound.is_in_front({9, 9, 5.5}));
}

TEST_CASE("the products of a vector are with halves, normal and velocity", "[contact][face_bound]") {
  Random random(3);
  const FaceBound bound = bound_of(random_face(random, false, true, 0.0));
  const Vector3f w(0.3f, -2.0f, 0.7f);
  const FourFloats products = bound.times(w);
  CHECK(products[0] == Approx(bound.half(0).dot(w)));
  CHECK(products[1] == Approx(bound.half(1).dot(w)));
  CHECK(products[2] == Approx(bound.normal().dot(w)));
  CHECK(products[3] == Approx(bound.velocity().dot(w)));
}

TEST_CASE("the corners lie within the warp of the parallelogram", "[contact][face_bound]") {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const MovingFace face = random_face(random, i % 3 == 0, i % 2 == 0, 0.0);
    const FaceBound bound = bound_of(face);
    for (Eigen::Index k = 0; k < 4; ++k) {
      const Vector3f away = (face.x.col(k) - bound.centre()).cast<float>();
      CHECK(away.norm() <= bound.radius() * 1.00001f);
      float nearest = std::numeric_limits<float>::infinity();
      for (const float s : {-1.0f, 1.0f}) {
        for (const float t : {-1.0f, 1.0f})
          nearest = std::min(nearest, (away - s * bound.half(0) - t * bound.half(1)).norm());
      }
      CHECK(nearest <= bound.warp() + 1e-5f);
    }
  }
}

TEST_CASE("faces that touch pass their bounds, most that do not are distinguished", "[contact][face_bound]") {
  Random random(11);
  int n_touching = 0, n_apart = 0, n_reported = 0;
  for (int i = 0; i < 4000; ++i) {
    const MovingFace first = random_face(random, i % 3 == 0, false, uniform(random, 0.0, 0.6));
    MovingFace second = random_face(random, i % 5 == 0, true, 0.0);
    second.x.colwise() += Vector3d(uniform(random, -1.5, 1.5), 0, 0);
    const double activation = i % 2 == 0 ? 0.0 : 0.2;
    const bool passes = may_touch(bound_of(first), bound_of(second), activation);
    if (smallest_gap(first, second) < activation) {
      ++n_touching;
      CHECK(passes);
    } else {
      ++n_apart;
      n_reported += passes ? 0 : 1;
    }
  }
  CHECK(n_touching > 200);
  CHECK(n_reported > n_apart / 3);
}

TEST_CASE("faces that look the same way, or are apart, do not touch", "[contact][face_bound]") {
  const FaceBound low = bound_of(make_square(0, 0, true)), over = bound_of(make_square(0, 0.1, false));
  CHECK(may_touch(low, over, 0.11));
  CHECK_FALSE(may_touch(low, over, 0.09));
  CHECK_FALSE(may_touch(low, bound_of(make_square(0, 0.1, true)), 0.11));
  CHECK_FALSE(may_touch(low, bound_of(make_square(1.01, 0.0, false)), 0.11));
  CHECK(may_touch(low, bound_of(make_square(0.99, 0.0, false)), 0.11));
}

TEST_CASE("points that project inside a face pass its bound, most others do not", "[contact][face_bound]") {
  Random random(13);
  int n_inside = 0, n_outside = 0, n_reported = 0;
  for (int i = 0; i < 4000; ++i) {
    const MovingFace face = random_face(random, i % 3 == 0, true, 0.0);
    const Vector3d point = random_vector(random, 0.8);
    const double activation = 0.3, depth = 0.2, beyond = i % 2 == 0 ? 0.0 : 0.05;
    const bool passes = may_project_inside(point, bound_of(face), activation, depth, beyond);
    const auto found = project_onto_face(face.x, face.is_triangle, point);
    const bool is_inside = found && found->beyond <= beyond && found->gap < activation && found->gap > -depth;
    if (is_inside) {
      ++n_inside;
      CHECK(passes);
    } else {
      ++n_outside;
      n_reported += passes ? 0 : 1;
    }
  }
  CHECK(n_inside > 200);
  CHECK(n_reported > n_outside / 2);
}

TEST_CASE("a corner that runs ahead of its face stirs it by what it is faster than the mean",
          "[contact][face_bound]") {
  FaceCorners x, v = FaceCorners::Zero();
  x << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  v(2, 1) = 4.0;
  const FaceBound bound(x, v, false);
  CHECK(bound.velocity().z() == 1.0f);
  CHECK(bound.normal_velocity_spread() == Approx(3.0));
  CHECK(FaceBound(x, -v, false).normal_velocity_spread() == Approx(1.0));
}
