// SPDX-License-Identifier: BSD-3-Clause
#include "support/catch.hpp"
#include "support/lone_line.hpp"

// How sections make springs and dampers is in discrete_section_test.cpp.

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

/// A spring or damper of a stiffness of 50 and a cross-section of 0.1, at rest with a length of 0.7.
LoneShell discrete_line_of(const ElementFormulation& row, const Matrix3Xd& x) {
  const double area = 0.1;
  ModelBlock block = make_discrete_block(one_element_mesh(row.shape, x), 0, row, 2.0, {&area, 1});
  block.discrete.stiffness = {Lanes::Constant(50.0)};
  block.discrete.length = {Lanes::Constant(0.7)};
  block.discrete.stable_step = {Lanes::Constant(0.25)};
  return {std::move(block), x};
}

const Matrix3Xd no_turns = Matrix3Xd::Zero(3, 2);

}  // namespace

TEST_CASE("a spring pulls by how much longer it is than at rest, however it got there", "[core][springs]") {
  const Matrix3Xd x = slanted_line();  // 0.8 long
  const Vector3d axis = (x.col(1) - x.col(0)).normalized();
  for (const ElementFormulation* row : {&bar2_spring, &beam2_spring}) {
    LoneShell spring = discrete_line_of(*row, x);
    CHECK(spring.stay().stable_step == 0.25);
    CHECK((spring.forces().col(0) - 50.0 * 0.1 * axis).norm() < 1e-12);
    CHECK((spring.forces().col(1) + 50.0 * 0.1 * axis).norm() < 1e-12);
    CHECK(spring.stress(0)(0, 0) == Approx(50.0 * 0.1 / 0.1));
    // A turn by far changes nothing but the direction, and takes no work.
    spring.move_to(rotation_of(2.5) * x, no_turns);
    CHECK((spring.forces().col(0) - rotation_of(2.5) * (50.0 * 0.1 * axis)).norm() < 1e-12);
    // Pressed to 0.4, its energy is 50 x 0.3^2 / 2, where it was 50 x 0.1^2 / 2.
    const double before = spring.stress_work();
    Matrix3Xd pressed = x;
    pressed.col(1) = x.col(0) + 0.4 * axis;
    const ChunkStep step = spring.move_to(pressed, no_turns);
    CHECK((spring.forces().col(0) + 50.0 * 0.3 * axis).norm() < 1e-12);
    CHECK(step.min_volume == Approx(0.04));
    CHECK(spring.stress_work() - before == Approx(25.0 * (0.09 - 0.01)));
    CHECK(spring.stress_work() == Approx(25.0 * (0.09 - 0.01)));
  }
}

TEST_CASE("forces of springs are the derivatives of their work", "[core][springs]") {
  LoneShell spring = discrete_line_of(bar2_spring, slanted_line());
  spring.stay();
  spring.move_to(distorted(slanted_line(), 0.05, 3), no_turns);
  check_derivatives_of_work(spring, 1e-6);
}

TEST_CASE("a damper resists by the rate of its length alone, and takes work both ways", "[core][springs]") {
  const Matrix3Xd x = slanted_line();
  const Vector3d axis = (x.col(1) - x.col(0)).normalized();
  for (const ElementFormulation* row : {&bar2_damper, &beam2_damper}) {
    LoneShell damper = discrete_line_of(*row, x);
    Matrix3Xd there = x;
    there.col(1) += 0.06 * axis;
    damper.move_to(there, no_turns, 0.2);
    CHECK((damper.forces().col(0) - 50.0 * 0.3 * axis).norm() < 1e-11);
    CHECK(damper.stress_work() == Approx(50.0 * 0.3 * 0.06));
    damper.move_to(x, no_turns, 0.2);
    CHECK((damper.forces().col(0) + 50.0 * 0.3 * axis).norm() < 1e-11);
    CHECK(damper.stress_work() == Approx(2.0 * 50.0 * 0.3 * 0.06));
    damper.move_to(x.colwise() + Vector3d(1, 2, 3), no_turns, 0.2);
    CHECK(damper.forces().norm() < 1e-10);
  }
}
