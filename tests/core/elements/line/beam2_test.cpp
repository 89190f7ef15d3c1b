// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "core/materials/neo_hookean.hpp"
#include "support/catch.hpp"
#include "support/lone_line.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

TEST_CASE("a rigid motion of a beam in large steps strains nothing and turns its forces", "[core][beams]") {
  for (const BeamShapeSettings& shape : all_beam_shapes()) {
    const Matrix3Xd x = slanted_line(), there = distorted(x, 1e-3, 2);
    LoneShell beam = beam_of(shape, x);
    beam.stay();
    for (int i = 1; i <= 5; ++i) beam.move_to(rotation_of(0.3 * i) * x, turns_of(0.3, 2));
    CHECK(beam.forces().norm() < 1e-13 * size_of_line_forces);
    CHECK(beam.moments().norm() < 1e-13 * size_of_line_forces);
    LoneShell strained = beam_of(shape, x);
    strained.stay();
    strained.move_to(there, random_turns(2, 1e-2, 5));
    const LoneShell before = strained;
    REQUIRE(before.moments().norm() > 1e-6 * size_of_line_forces);
    for (int i = 1; i <= 5; ++i) strained.move_to(rotation_of(0.3 * i) * there, turns_of(0.3, 2));
    const Matrix3d turn = rotation_of(1.5);
    CHECK((strained.forces() - turn * before.forces()).norm() < 1e-12 * size_of_line_forces);
    CHECK((strained.moments() - turn * before.moments()).norm() < 1e-12 * size_of_line_forces);
  }
}

TEST_CASE("forces and moments of a beam balance and are the derivatives of its work", "[core][beams]") {
  for (const BeamShapeSettings& shape : all_beam_shapes()) {
    const Matrix3Xd x = slanted_line();
    LoneShell beam = beam_of(shape, x);
    beam.stay();
    for (unsigned i = 1; i <= 3; ++i)
      beam.move_to(distorted(beam.coordinates, 1e-3, i), random_turns(2, 1e-2, 7 + i));
    const Matrix3Xd force = beam.forces();
    CHECK(force.rowwise().sum().norm() < 1e-12 * force.norm());
    CHECK(total_moment(beam).norm() < 1e-11 * force.norm());
    check_derivatives_of_work(beam, 1e-4 * force.norm());
  }
}

TEST_CASE("one beam bends, twists and stretches as the theory of beams says", "[core][beams]") {
  const double length = 2.0;
  Matrix3Xd x(3, 2);
  x << 0, length, 0, 0, 0, 0;
  for (BeamShapeSettings shape : all_beam_shapes()) {
    if (shape.is_offset) continue;
    shape.t_axis = Vector3d::UnitY();
    LoneShell beam = beam_of(shape, x);
    beam.stay();
    const Eigen::MatrixXd flexibility = stiffness_of(beam).bottomRightCorner(6, 6).inverse();
    const double bend_y = std::pow(length, 3) / (3 * line_youngs * shape.second_t) +
                          length / (shape.shear_t * 80e9 * shape.area);
    const double bend_z = std::pow(length, 3) / (3 * line_youngs * shape.second_s) +
                          length / (shape.shear_s * 80e9 * shape.area);
    CHECK(flexibility(0, 0) == Approx(length / (line_youngs * shape.area)).epsilon(1e-5));
    CHECK(flexibility(1, 1) == Approx(bend_y).epsilon(1e-5));
    CHECK(flexibility(2, 2) == Approx(bend_z).epsilon(1e-5));
    CHECK(flexibility(3, 3) == Approx(length / (80e9 * shape.torsion)).epsilon(1e-5));
    CHECK(flexibility(5, 5) == Approx(length / (line_youngs * shape.second_t)).epsilon(1e-5));
  }
}

TEST_CASE("nodes of a round beam share its polar inertia, and what its offset adds", "[core][beams]") {
  const auto inertia_over_mass = [](const BeamShapeSettings& shape) {
    const double area = shape.area;
    const Mesh mesh = one_element_mesh(Shape::beam2, slanted_line());
    const ModelBlock block =
        make_line_block(mesh, 0, beam2_beam, undamped(line_elastic()), shape, {&area, 1});
    return block.inertia[0](0) / block.mass[0](0);
  };
  BeamSection section;
  section.shape = BeamShape::rod;
  section.width = section.height = 0.1;
  section.t_axis = Vector3d::UnitZ();
  std::string problem;
  const double round = 0.5 * 0.05 * 0.05;  // r^2 / 2
  CHECK(inertia_over_mass(*make_beam_shape(section, problem)) == Approx(round));
  section.axis_offset = {0.03, -0.04};
  CHECK(inertia_over_mass(*make_beam_shape(section, problem)) == Approx(round + 0.05 * 0.05));
}

TEST_CASE("the stable step of a line is below that of its highest frequency", "[core][beams]") {
  for (const BeamShapeSettings& shape : all_beam_shapes()) {
    for (const double length : {0.1, 0.8, 5.0}) {
      LoneShell beam = beam_of(shape, slanted_line(length));
      const double bound = beam.stay().stable_step, limit = stable_limit(beam);
      CHECK(bound <= (1.0 + 1e-5) * limit);
      CHECK(bound > 0.4 * limit);
    }
  }
}

TEST_CASE("forces and moments of rubber beams and trusses are the derivatives of the work", "[core][beams]") {
  const MaterialLaw rubber = NeoHookeanLaw{line_steel};
  for (const bool is_truss : {false, true}) {
    LoneShell line_of = is_truss ? truss_of(0.01, slanted_line(), rubber)
                                 : beam_of(shape_of_beam(BeamShape::box, true), slanted_line(), rubber);
    line_of.stay();
    for (unsigned i = 1; i <= 4; ++i)
      line_of.move_to(distorted(line_of.coordinates, 0.05, i), random_turns(2, 0.05, 7 + i));
    REQUIRE(line_of.forces().norm() > 1e-3 * size_of_line_forces);
    check_derivatives_of_work(line_of, 1e-7 * size_of_line_forces);
    if (!is_truss) CHECK(line_of.stay().stable_step <= (1.0 + 1e-6) * stable_limit(line_of));
  }
}
