// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/pair_work.hpp"

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// Two cubes that go on by steps, and the work of one pair of two.
struct WorkedCubes {
  test::TwoCubes cubes;
  PairWork work{2};
  Eigen::Matrix3Xd turning = Eigen::Matrix3Xd::Zero(3, 16);

  /// Begins a step in which the upper cube moves by a velocity and turns by another one at each node.
  void step(double dt, const Vector3d& velocity, const Vector3d& turns = Vector3d::Zero()) {
    cubes.parts.v.rightCols(8).colwise() = velocity;
    turning.rightCols(8).colwise() = turns;
    cubes.parts.kinematics.move_nodes({0.0, dt, cubes.parts.x, cubes.parts.v, 1.0, &turning});
    work.begin_step(cubes.parts.kinematics, dt);
  }
  void add(const ContactPoint& point) { work.add(cubes.parts.kinematics, point); }
  double taken() const { return work.taken()[{1}]; }
};

/// A force of 10 up on the upper cube.
ContactPoint pressed_point() {
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.pair = {1};
  point.force = 10.0;
  return point;
}

}  // namespace

TEST_CASE("a force works along the half steps before and behind its time", "[contact][pair_work]") {
  WorkedCubes cubes;
  cubes.step(0.2, {0, 0, -3});
  CHECK(cubes.work.step() == 0.2);
  CHECK(cubes.work.work_behind(cubes.cubes.parts.kinematics, pressed_point()) == Approx(3.0));
  CHECK(cubes.taken() == 0.0);  // asked for alone it counts nowhere
  cubes.add(pressed_point());
  CHECK(cubes.taken() == Approx(0.1 * 10.0 * 3.0));
  cubes.step(0.4, {7, 0, 5});
  CHECK(cubes.taken() == Approx(3.0 - 0.2 * 10.0 * 5.0));
  cubes.step(0.4, {0, 0, 5});
  CHECK(cubes.taken() == Approx(-7.0));  // each force has two halves of steps
  CHECK(cubes.work.taken()[{0}] == 0.0);
}

TEST_CASE("what moves alike on both sides of a contact point works nothing", "[contact][pair_work]") {
  WorkedCubes cubes;
  cubes.cubes.parts.v.leftCols(8).colwise() = Vector3d(1, 2, 3);
  cubes.step(0.2, {1, 2, 3});
  ContactPoint point = pressed_point();
  point.tangential << 1, -4, 0;
  cubes.add(point);
  CHECK(cubes.taken() == Approx(0.0).margin(1e-14));
}

TEST_CASE("a point that does not touch works nothing, one that is held apart does", "[contact][pair_work]") {
  WorkedCubes cubes;
  cubes.step(0.2, {1, 0, 0});
  ContactPoint point = pressed_point();
  point.force = 0.0;
  point.tangential << 5, 0, 0;
  cubes.add(point);
  CHECK(cubes.taken() == 0.0);
  point.is_held_apart = true;
  cubes.add(point);
  CHECK(cubes.taken() == Approx(-0.1 * 5.0));
}

TEST_CASE("a point that stands off its node works along what it moves by", "[contact][pair_work]") {
  WorkedCubes cubes;
  const Vector3d turning(0.3, 4, 2), velocity(1, 0, -1);
  cubes.step(0.2, velocity, turning);
  ContactPoint point = pressed_point();
  point.first.radius = 0.5;  // below the node
  point.tangential << 2, 3, 0;
  cubes.add(point);
  const Vector3d moves = velocity + turning.cross(Vector3d(0, 0, -0.5));
  CHECK(cubes.taken() == Approx(-0.1 * moves.dot(Vector3d(2, 3, 10))));
}

TEST_CASE("work that a point knows itself is taken as it is, its second half in the next step",
          "[contact][pair_work]") {
  WorkedCubes cubes;
  cubes.step(0.2, {0, 0, -3});
  ContactPoint point = pressed_point();
  point.knows_work = true;
  point.work_before = 0.25;
  point.work_after = -4.0;
  cubes.add(point);
  CHECK(cubes.taken() == 0.25);
  cubes.step(0.2, {0, 0, -3});
  CHECK(cubes.taken() == -3.75);
  cubes.step(0.2, {0, 0, -3});
  CHECK(cubes.taken() == -3.75);
}

TEST_CASE("an interface constraint works by the forces on its corners", "[contact][pair_work]") {
  WorkedCubes cubes;
  cubes.step(0.2, {0, 0, 2});
  InterfaceConstraint constraint;
  constraint.pair = {1};
  constraint.nodes = {8, 9, 10, 11, 4, 5, 6, 7};
  CornerForces forces;
  forces.forces.setZero();
  forces.forces(2, 0) = -3.0;
  forces.forces(2, 3) = -1.0;
  forces.forces(2, 4) = 4.0;
  cubes.work.add(cubes.cubes.parts.kinematics, constraint, forces);
  CHECK(cubes.taken() == Approx(0.1 * 4.0 * 2.0));
  cubes.step(0.1, {0, 0, 2});
  CHECK(cubes.taken() == Approx(0.15 * 4.0 * 2.0));
}

TEST_CASE("forces of nodes that have other numbers now work no more", "[contact][pair_work]") {
  WorkedCubes cubes;
  cubes.step(0.2, {0, 0, -3});
  cubes.add(pressed_point());
  cubes.work.forget_forces();
  cubes.step(0.2, {0, 0, -3});
  CHECK(cubes.taken() == Approx(3.0));
}

TEST_CASE("work goes on from a stored state, forces of the last step included", "[contact][pair_work]") {
  WorkedCubes cubes, other;
  ContactPoint point = pressed_point();
  cubes.step(0.2, {0, 0, -3});
  point.first.radius = 0.5;
  point.tangential << 1, 0, 0;
  cubes.add(point);
  point.knows_work = true;
  point.work_after = 0.5;
  cubes.add(point);
  StateArchive saves;
  cubes.work.archive(saves);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  other.work.archive(restores);
  cubes.step(0.2, {0, 0, -3}, {0, 2, 0});
  other.step(0.2, {0, 0, -3}, {0, 2, 0});
  CHECK(other.taken() == cubes.taken());
  PairWork fewer(1);
  StateArchive fails(saved);
  CHECK_THROWS_AS(fewer.archive(fails), FileError);
}
