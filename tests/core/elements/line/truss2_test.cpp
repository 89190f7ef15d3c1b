// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "core/materials/linear_hardening.hpp"
#include "core/materials/neo_hookean.hpp"
#include "support/catch.hpp"
#include "support/lone_line.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

TEST_CASE("a truss pulls along itself alone, turns freely and yields", "[core][beams]") {
  const Matrix3Xd x = slanted_line();
  LoneShell truss = truss_of(0.01, x);
  const Vector3d axis = (x.col(1) - x.col(0)).normalized();
  Matrix3Xd there = rotation_of(0.7) * x;
  truss.move_to(there, Matrix3Xd::Zero(3, 2));
  CHECK(truss.forces().norm() < 1e-13 * size_of_line_forces);
  const Vector3d now = rotation_of(0.7) * axis;
  there.col(1) += 1e-6 * now;
  const double step = truss.move_to(there, Matrix3Xd::Zero(3, 2)).stable_step;
  CHECK((truss.forces().col(0) - 1e-6 / 0.8 * line_youngs * 0.01 * now).norm() <
        1e-5 * 1e-6 * line_youngs * 0.01);
  CHECK(step == Approx(0.8 / std::sqrt(line_youngs / 7800.0)).epsilon(1e-5));

  LoneShell plastic = truss_of(0.01, x, PlasticLaw<LinearHardening>{line_steel, {200e6, 1e9, 0.0}});
  Matrix3Xd far = x;
  far.col(1) += 0.008 * axis;
  plastic.move_to(far, Matrix3Xd::Zero(3, 2));
  const double strain = 0.008 / 0.804;  // by the length in the middle
  const double expected = 200e6 + 1e9 * (line_youngs * strain - 200e6) / (line_youngs + 1e9);
  CHECK(plastic.forces().norm() / std::sqrt(2.0) == Approx(0.01 * expected).epsilon(1e-9));
}

TEST_CASE("a truss with an initial load pulls by it before it is stretched, and as its period has it",
          "[core][beams]") {
  const Matrix3Xd x = slanted_line();
  LoneShell at_once = truss_of(0.01, x);
  at_once.block.preload = {3e6, 0.0};
  at_once.state = make_state(at_once.block);
  at_once.stay();
  const Vector3d axis = (x.col(1) - x.col(0)).normalized();
  CHECK((at_once.forces().col(0) - 3e6 * axis).norm() < 1e-3);
  Matrix3Xd there = x;
  there.col(1) += 1e-6 * axis;
  at_once.move_to(there, Matrix3Xd::Zero(3, 2));
  CHECK(at_once.forces().col(0).norm() == Approx(3e6 + 1e-6 / 0.8 * line_youngs * 0.01).epsilon(1e-9));

  LoneShell soon = truss_of(0.01, x);
  soon.block.preload = {3e6, 4.0};
  soon.state = make_state(soon.block);
  const Matrix3Xd still = Matrix3Xd::Zero(3, 2);
  for (const double time : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    const Motion motion{time, 1.0, x, still};
    soon.block.element->advance(soon.block, soon.block.chunks[0], motion, soon.state);
    CHECK(soon.forces().col(0).norm() == Approx(3e6 * std::min(time / 4.0, 1.0)));
  }
  CHECK(soon.stress_work() == 0.0);
}

TEST_CASE("a rubber cord pulled to twice its length has the stress by the area that is left",
          "[core][beams]") {
  const MaterialLaw rubber = NeoHookeanLaw{{1e9, 3.0}};  // next to incompressible
  const Matrix3Xd x = slanted_line();
  Matrix3Xd far = x;
  far.col(1) += x.col(1) - x.col(0);
  LoneShell truss = truss_of(0.01, x, rubber), beam = beam_of(shape_of_beam(BeamShape::bar), x, rubber);
  const double free = truss.stay().stable_step;
  const double step = truss.move_to(far, Matrix3Xd::Zero(3, 2)).stable_step;
  beam.stay();
  beam.move_to(far, Matrix3Xd::Zero(3, 2));
  const double expected = 3.0 * (4.0 - 0.5) / 2.0;  // mu (L^2 - 1 / L) / L
  CHECK(truss.forces().col(0).norm() == Approx(0.01 * expected).epsilon(1e-6));
  CHECK(beam.forces().col(0).norm() == Approx(0.02 * expected).epsilon(1e-6));
  CHECK(step > 0.0);
  CHECK(free == Approx(0.8 / std::sqrt(9.0 / 7800.0)).epsilon(1e-6));
}
