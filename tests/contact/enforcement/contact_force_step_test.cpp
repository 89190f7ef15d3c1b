// SPDX-License-Identifier: BSD-3-Clause
// How much contact lowers the stable step of explicit dynamics.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string stiff_spring = "penalty stiffness = 1000\n";

std::string meets_by() { return GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n"); }

/// A cube over a plate of 3 x 3 cells.
MeshBuilder cube_above_plate(double gap) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  return b.add_hexes({.id = 2, .origin = {0.7, 1.2, 1.0 + gap}, .share_nodes = false});
}

/// The largest eigenvalue of what the forces change by when nodes move, over their masses.
double eigenvalue_of(ContactBodies& bodies) {
  const Eigen::Index n = bodies.x.size();
  Eigen::MatrixXd matrix(n, n);
  constexpr double step = 1e-6;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double was = bodies.x.data()[i];
    bodies.x.data()[i] = was + step;
    bodies.ask();
    const Eigen::VectorXd more = bodies.forces.reshaped();
    bodies.x.data()[i] = was - step;
    bodies.ask();
    matrix.col(i) = (bodies.forces.reshaped() - more) / (2.0 * step);
    bodies.x.data()[i] = was;
  }
  const Eigen::VectorXd root = bodies.model.mass.replicate<3, 1>().reshaped().cwiseSqrt().cwiseInverse();
  matrix = root.asDiagonal() * matrix * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (matrix + matrix.transpose()))
      .eigenvalues()
      .maxCoeff();
}

}  // namespace

TEST_CASE("the stable step that contact asks for bears the stiffest motion of its springs",
          "[contact][contact_force]") {
  const std::string formulation = meets_by();
  const std::string law = GENERATE(std::string(), std::string("friction model = tied\n"));
  ContactBodies bodies(cube_above_plate(law.empty() ? -0.1 : 0.05),
                       general_contact(law + stiff_spring + formulation));
  bodies.ask();
  const double eigenvalue = eigenvalue_of(bodies);
  const double stable_step = bodies.ask().stable_step;
  CHECK(eigenvalue > 1000.0);
  // Contact with an eigenvalue far above the elements' 4: the step is its root's inverse at most.
  CHECK(stable_step <= 1.0001 / std::sqrt(eigenvalue));
  CHECK(stable_step > 0.3 / std::sqrt(eigenvalue));
  CHECK(bodies.contact.lost_step_share() == Approx(1.0 - stable_step).epsilon(0.1));
}

TEST_CASE("what closes within two steps sets the stable step before it touches, at the start too",
          "[contact][contact_force]") {
  const std::string formulation = meets_by();
  for (const double speed : {0.04, 0.06}) {
    ContactBodies bodies(cube_above_plate(0.1), general_contact(stiff_spring + formulation));
    bodies.set_velocity(1, {0, 0, -speed});
    const double stable_step = bodies.ask().stable_step;  // that of the elements is 1
    CHECK(bodies.forces.norm() == 0.0);
    CHECK((stable_step < 1.0) == (speed > 0.05));
  }
}

TEST_CASE("automatic penalties cost little of the elements' step", "[contact][contact_force]") {
  // The elements' own stable step: the edge over the speed of sound.
  const std::string formulation = meets_by();
  ContactBodies bodies(cube_above_plate(-0.01), general_contact(formulation));
  const ForceReport report = bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(report.stable_step < 1.0);
  CHECK(report.stable_step > 0.75);
}
