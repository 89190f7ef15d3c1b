// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/ties.hpp"

#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double stiffness = 1000.0;

CornerVectors corners_of(const MovingFace& first, const MovingFace& second) {
  CornerVectors x;
  x << first.x, second.x;
  return x;
}

Tie tied(const MovingFace& first, const MovingFace& second, double tolerance = 1.0) {
  Tie tie;
  REQUIRE(tie_faces(first, second, stiffness, tolerance, tie));
  return tie;
}

void check_balance(const CornerVectors& x, const CornerVectors& forces) {
  Vector3d moment = Vector3d::Zero();
  for (int k = 0; k < 8; ++k) moment += x.col(k).cross(forces.col(k));
  const double size = forces.colwise().norm().sum();
  CHECK(size > 1e-3);
  CHECK(forces.rowwise().sum().norm() < 1e-13 * size);
  CHECK(moment.norm() < 1e-12 * size);
}

}  // namespace

TEST_CASE("tied faces keep their gap without a force, however they turn together", "[contact][ties]") {
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, uniform(random, -0.2, 0.2));
    const Tie tie = tied(a, b);
    const CornerVectors x = corners_of(a, b);
    CHECK(find_tie_forces(tie, x).forces.norm() < 1e-11 * stiffness);
    const CornerVectors moved = (random_rotation(random) * x).colwise() + random_vector(random, 3.0);
    CHECK(find_tie_forces(tie, moved).forces.norm() < 1e-10 * stiffness);
  }
}

TEST_CASE("a tie pulls, pushes and shears by stiffness times area", "[contact][ties]") {
  const MovingFace lower = make_square(0.0, 0.0, true), upper = make_square(0.5, 0.1, false);
  const Tie tie = tied(lower, upper);
  CHECK(tie.area == Approx(0.5));
  for (const Vector3d& move : {Vector3d(0, 0, 0.01), Vector3d(0, 0, -0.01), Vector3d(0.01, 0, 0)}) {
    CornerVectors x = corners_of(lower, upper);
    x.rightCols<4>().colwise() += move;
    const CornerForces found = find_tie_forces(tie, x);
    const Vector3d on_lower = found.forces.leftCols<4>().rowwise().sum();
    CHECK((on_lower - stiffness * 0.5 * move).norm() < 1e-12);
    CHECK((found.normal - Vector3d(0, 0, -1)).norm() < 1e-14);
    check_balance(x, found.forces);
  }
}

TEST_CASE("a tie with other springs goes on with its forces", "[contact][ties]") {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.2);
    Tie tie = tied(a, b);
    CornerVectors x = corners_of(a, b);
    x.leftCols<4>().colwise() += random_vector(random, 0.01);
    x = ((random_rotation(random) * x).colwise() + random_vector(random, 3.0)).eval();
    const CornerForces before = find_tie_forces(tie, x);
    renew_springs(0.1 * stiffness, x, tie);
    const CornerForces now = find_tie_forces(tie, x);
    const double size = before.forces.colwise().norm().sum();
    CHECK((now.forces - before.forces).norm() < 1e-9 * size);
    CHECK(now.stored == Approx(10.0 * before.stored));
    const Vector3d step(0.0, 0.002, 0.003), on_first = before.forces.leftCols<4>().rowwise().sum();
    x.leftCols<4>().colwise() += step;
    const Vector3d moved = find_tie_forces(tie, x).forces.leftCols<4>().rowwise().sum();
    CHECK((moved - on_first + 0.1 * stiffness * tie.area * step).norm() < 1e-8 * size);
  }
}

TEST_CASE("a tie goes on by its points with the forces of its springs", "[contact][ties]") {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.2);
    Tie tie = tied(a, b);
    CornerVectors x = corners_of(a, b);
    for (int k = 0; k < 8; ++k) x.col(k) += random_vector(random, 0.01);
    if (a.is_triangle) x.col(3) = x.col(2);
    if (b.is_triangle) x.col(7) = x.col(6);
    x = ((random_rotation(random) * x).colwise() + random_vector(random, 3.0)).eval();
    CHECK_FALSE(has_constant_forces(tie));
    const CornerVectors before = find_tie_forces(tie, x).forces;
    const double size = before.colwise().norm().sum();
    replace_springs_by_points(x, tie);
    REQUIRE(has_constant_forces(tie));
    const CornerForces rest = find_tie_forces(tie, x);
    CHECK((find_point_forces(tie, x).forces + rest.forces - before).norm() < 1e-9 * size);
    CHECK(rest.stored == Approx(0.0).margin(1e-12));
    const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
    for (std::uint32_t p = 0; p < tie.n_points; ++p)
      CHECK((axes * tie.points[p].offset - offset_of(tie.points[p], x)).norm() < 1e-12);
    // They turn with the second side.
    const Eigen::Matrix3d turn = random_rotation(random);
    const CornerVectors turned = turn * x;
    CHECK((find_tie_forces(tie, turned).forces - turn * rest.forces).norm() < 1e-9 * size);
    check_balance(x, find_point_forces(tie, x).forces);
  }
}

TEST_CASE("forces of ties over a gap balance in any deformation", "[contact][ties]") {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, 0.2);
    const Tie tie = tied(a, b);
    CornerVectors x = corners_of(a, b);
    for (int k = 0; k < 8; ++k) x.col(k) += random_vector(random, 0.1);
    if (a.is_triangle) x.col(3) = x.col(2);
    if (b.is_triangle) x.col(7) = x.col(6);
    x = ((random_rotation(random) * x).colwise() + random_vector(random, 3.0)).eval();
    check_balance(x, find_tie_forces(tie, x).forces);
  }
}

TEST_CASE("a tie passes uniform stress", "[contact][ties]") {
  // Pulled apart, the corners of two equal squares get a quarter each.
  const MovingFace lower = make_square(0.0, 0.0, true), upper = make_square(0.0, 0.0, false);
  CornerVectors x = corners_of(lower, upper);
  x.rightCols<4>().row(2).array() += 0.01;
  const CornerForces found = find_tie_forces(tied(lower, upper), x);
  for (int k = 0; k < 8; ++k) CHECK(found.forces(2, k) == Approx(k < 4 ? 2.5 : -2.5));
}

TEST_CASE("only points within the tolerance are tied", "[contact][ties]") {
  const MovingFace lower = make_square(0.0, 0.0, true);
  Tie tie;
  CHECK(!tie_faces(lower, make_square(0.0, 0.1, false), stiffness, 0.09, tie));
  CHECK(!tie_faces(lower, make_square(0.0, -0.1, false), stiffness, 0.09, tie));
  CHECK(!tie_faces(lower, make_square(1.0, 0.0, false), stiffness, 0.09, tie));
  CHECK(!tie_faces(lower, make_square(0.0, 0.0, true), stiffness, 0.09, tie));
  CHECK(tie.area == 0.0);
  CHECK(tie_faces(lower, make_square(0.0, 0.1, false), stiffness, 0.11, tie));
}

TEST_CASE("a node tied to a face over a gap stays over its point, and its force has no moment",
          "[contact][ties]") {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const MovingFace face = random_face(random, i % 2 == 0, true, 0.0);
    const Eigen::Vector4d weights = corner_weights(0.2, 0.3, face.is_triangle);
    const Vector3d node = face.x * weights + 0.1 * face.normal();
    Tie tie;
    tie.is_node = true;
    tie_node(node, face, weights, stiffness, tie);
    CornerVectors x;
    x << node.replicate<1, 4>(), face.x;
    CHECK(find_tie_forces(tie, x).forces.norm() < 1e-11 * stiffness);
    CornerVectors moved = (random_rotation(random) * x).colwise() + random_vector(random, 2.0);
    CHECK(find_tie_forces(tie, moved).forces.norm() < 1e-11 * stiffness);
    const Vector3d move(0.003, -0.002, 0.01);
    x.leftCols<4>().colwise() += move;
    const CornerForces found = find_tie_forces(tie, x);
    CHECK((found.forces.col(0) + stiffness * move).norm() < 1e-11 * stiffness);
    CHECK(found.forces.middleCols<3>(1).norm() == 0.0);
    check_balance(x, found.forces);
  }
}

TEST_CASE("a stiff tie that has hardly moved does not push the whole by round-off", "[contact][ties]") {
  Random random(5);
  const MovingFace lower = make_square(0.0, 0.0, true), upper = make_square(0.5, 0.1, false);
  Tie tie;
  REQUIRE(tie_faces(lower, upper, 1e12, 1.0, tie));
  for (int i = 0; i < 20; ++i) {
    CornerVectors x = corners_of(lower, upper);
    for (int k = 0; k < 8; ++k) x.col(k) += random_vector(random, 1e-9);
    check_balance(x, find_tie_forces(tie, x).forces);
  }
}
