// SPDX-License-Identifier: BSD-3-Clause
// What beams and trusses must do. Moduli are near 1e11, lengths near 1, steps of size 1.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/neo_hookean.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
constexpr double youngs = 9.0 * 160e9 * 80e9 / (3.0 * 160e9 + 80e9);
constexpr double size_of_forces = 1e9;  // modulus x area

const MaterialLaw elastic = ElasticLaw{steel};

BeamShapeSettings shape_of(BeamShape kind, bool is_offset = false) {
  BeamSection section;
  section.shape = kind;
  section.width = 0.1;
  section.height = 0.2;
  section.wall_thickness = 0.01;
  section.flange_thickness = 0.02;
  section.t_axis = Vector3d(0.3, 1.0, 0.2);
  if (is_offset) section.axis_offset = {0.05, -0.1};
  std::string problem;
  return *make_beam_shape(section, problem);
}

std::vector<BeamShapeSettings> all_shapes() {
  std::vector<BeamShapeSettings> shapes;
  for (const BeamShape kind : {BeamShape::rod, BeamShape::tube, BeamShape::bar, BeamShape::box, BeamShape::i})
    shapes.push_back(shape_of(kind));
  shapes.push_back(shape_of(BeamShape::bar, true));
  return shapes;
}

/// Two nodes in no special direction.
Matrix3Xd line(double length = 0.8) {
  Matrix3Xd x(3, 2);
  x.col(0) = Vector3d(0.1, 0.2, -0.3);
  x.col(1) = x.col(0) + length * Vector3d(0.6, -0.5, 0.7).normalized();
  return x;
}

LoneShell beam_of(const BeamShapeSettings& shape, const Matrix3Xd& x, const MaterialLaw& law = elastic) {
  const double area = shape.area;
  return {make_line_block(one_element_mesh(Shape::beam2, x), 0, beam2_beam, undamped(law), shape, {&area, 1}),
          x};
}

LoneShell truss_of(double area, const Matrix3Xd& x, const MaterialLaw& law = elastic) {
  BeamShapeSettings one_fibre;
  one_fibre.fibres = {{}};
  return {
      make_line_block(one_element_mesh(Shape::bar2, x), 0, bar2_truss, undamped(law), one_fibre, {&area, 1}),
      x};
}

}  // namespace

TEST_CASE("cross-sections have the areas and second moments of their shapes", "[core][beams]") {
  const BeamShapeSettings bar = shape_of(BeamShape::bar), rod = shape_of(BeamShape::rod);
  CHECK(bar.area == Approx(0.02));
  CHECK(bar.second_t == Approx(0.2 * 0.001 / 12));
  CHECK(bar.second_s == Approx(0.1 * 0.008 / 12));
  CHECK(bar.torsion == Approx(0.229 * 0.2 * 0.001).epsilon(0.01));  // tabled for a ratio of 2
  CHECK(rod.area == Approx(M_PI * 0.0025));
  CHECK(rod.second_s == Approx(M_PI * std::pow(0.05, 4) / 4));
  const BeamShapeSettings tube = shape_of(BeamShape::tube), box = shape_of(BeamShape::box);
  CHECK(tube.second_t == Approx(M_PI * (std::pow(0.05, 4) - std::pow(0.04, 4)) / 4));
  CHECK(box.area == Approx(0.1 * 0.2 - 0.08 * 0.18));
  CHECK(box.second_s == Approx((0.1 * 0.008 - 0.08 * std::pow(0.18, 3)) / 12));
  CHECK(box.second_t == Approx((0.2 * 0.001 - 0.18 * std::pow(0.08, 3)) / 12));
  const BeamShapeSettings i = shape_of(BeamShape::i);
  CHECK(i.area == Approx(2 * 0.1 * 0.02 + 0.16 * 0.01));
  CHECK(i.second_s == Approx((0.1 * 0.008 - 0.09 * std::pow(0.16, 3)) / 12));
}

TEST_CASE("a section without what its shape needs says so", "[core][beams]") {
  const auto problem_of = [](BeamSection section) {
    std::string problem;
    CHECK_FALSE(make_beam_shape(section, problem));
    return problem;
  };
  BeamSection section;
  section.shape = BeamShape::box;
  CHECK(problem_of(section) == "needs WIDTH");
  section.width = 0.1;
  CHECK(problem_of(section) == "needs HEIGHT");
  section.height = 0.1;
  CHECK(problem_of(section) == "needs WALL THICKNESS");
  section.wall_thickness = 0.06;
  CHECK(problem_of(section) == "has walls that do not fit into it");
}

TEST_CASE("a rigid motion of a beam in large steps strains nothing and turns its forces", "[core][beams]") {
  for (const BeamShapeSettings& shape : all_shapes()) {
    const Matrix3Xd x = line(), there = distorted(x, 1e-3, 2);
    LoneShell beam = beam_of(shape, x);
    beam.stay();
    for (int i = 1; i <= 5; ++i) beam.move_to(rotation_of(0.3 * i) * x, turns_of(0.3, 2));
    CHECK(beam.forces().norm() < 1e-13 * size_of_forces);
    CHECK(beam.moments().norm() < 1e-13 * size_of_forces);
    LoneShell strained = beam_of(shape, x);
    strained.stay();
    strained.move_to(there, random_turns(2, 1e-2, 5));
    const LoneShell before = strained;
    REQUIRE(before.moments().norm() > 1e-6 * size_of_forces);
    for (int i = 1; i <= 5; ++i) strained.move_to(rotation_of(0.3 * i) * there, turns_of(0.3, 2));
    const Matrix3d turn = rotation_of(1.5);
    CHECK((strained.forces() - turn * before.forces()).norm() < 1e-12 * size_of_forces);
    CHECK((strained.moments() - turn * before.moments()).norm() < 1e-12 * size_of_forces);
  }
}

TEST_CASE("forces and moments of a beam balance and are the derivatives of its work", "[core][beams]") {
  for (const BeamShapeSettings& shape : all_shapes()) {
    const Matrix3Xd x = line();
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
  for (BeamShapeSettings shape : all_shapes()) {
    if (shape.is_offset) continue;
    shape.t_axis = Vector3d::UnitY();
    LoneShell beam = beam_of(shape, x);
    beam.stay();
    const Eigen::MatrixXd flexibility = stiffness_of(beam).bottomRightCorner(6, 6).inverse();
    const double bend_y =
        std::pow(length, 3) / (3 * youngs * shape.second_t) + length / (shape.shear_t * 80e9 * shape.area);
    const double bend_z =
        std::pow(length, 3) / (3 * youngs * shape.second_s) + length / (shape.shear_s * 80e9 * shape.area);
    CHECK(flexibility(0, 0) == Approx(length / (youngs * shape.area)).epsilon(1e-5));
    CHECK(flexibility(1, 1) == Approx(bend_y).epsilon(1e-5));
    CHECK(flexibility(2, 2) == Approx(bend_z).epsilon(1e-5));
    CHECK(flexibility(3, 3) == Approx(length / (80e9 * shape.torsion)).epsilon(1e-5));
    CHECK(flexibility(5, 5) == Approx(length / (youngs * shape.second_t)).epsilon(1e-5));
  }
}

TEST_CASE("nodes of a round beam share its polar inertia, and what its offset adds", "[core][beams]") {
  const auto inertia_over_mass = [](const BeamShapeSettings& shape) {
    const double area = shape.area;
    const Mesh mesh = one_element_mesh(Shape::beam2, line());
    const ModelBlock block = make_line_block(mesh, 0, beam2_beam, undamped(elastic), shape, {&area, 1});
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
  for (const BeamShapeSettings& shape : all_shapes()) {
    for (const double length : {0.1, 0.8, 5.0}) {
      LoneShell beam = beam_of(shape, line(length));
      const double bound = beam.stay().stable_step, limit = stable_limit(beam);
      CHECK(bound <= (1.0 + 1e-5) * limit);
      CHECK(bound > 0.4 * limit);
    }
  }
}

TEST_CASE("a truss pulls along itself alone, turns freely and yields", "[core][beams]") {
  const Matrix3Xd x = line();
  LoneShell truss = truss_of(0.01, x);
  const Vector3d axis = (x.col(1) - x.col(0)).normalized();
  Matrix3Xd there = rotation_of(0.7) * x;
  truss.move_to(there, Matrix3Xd::Zero(3, 2));
  CHECK(truss.forces().norm() < 1e-13 * size_of_forces);
  const Vector3d now = rotation_of(0.7) * axis;
  there.col(1) += 1e-6 * now;
  const double step = truss.move_to(there, Matrix3Xd::Zero(3, 2)).stable_step;
  CHECK((truss.forces().col(0) - 1e-6 / 0.8 * youngs * 0.01 * now).norm() < 1e-5 * 1e-6 * youngs * 0.01);
  CHECK(step == Approx(0.8 / std::sqrt(youngs / 7800.0)).epsilon(1e-5));

  LoneShell plastic = truss_of(0.01, x, PlasticLaw<LinearHardening>{steel, {200e6, 1e9, 0.0}});
  Matrix3Xd far = x;
  far.col(1) += 0.008 * axis;
  plastic.move_to(far, Matrix3Xd::Zero(3, 2));
  const double strain = 0.008 / 0.804;  // by the length in the middle
  const double expected = 200e6 + 1e9 * (youngs * strain - 200e6) / (youngs + 1e9);
  CHECK(plastic.forces().norm() / std::sqrt(2.0) == Approx(0.01 * expected).epsilon(1e-9));
}

TEST_CASE("a rubber cord pulled to twice its length has the stress by the area that is left",
          "[core][beams]") {
  const MaterialLaw rubber = NeoHookeanLaw{{1e9, 3.0}};  // next to incompressible
  const Matrix3Xd x = line();
  Matrix3Xd far = x;
  far.col(1) += x.col(1) - x.col(0);
  LoneShell truss = truss_of(0.01, x, rubber), beam = beam_of(shape_of(BeamShape::bar), x, rubber);
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

TEST_CASE("forces and moments of rubber beams and trusses are the derivatives of the work", "[core][beams]") {
  const MaterialLaw rubber = NeoHookeanLaw{steel};
  for (const bool is_truss : {false, true}) {
    LoneShell line_of =
        is_truss ? truss_of(0.01, line(), rubber) : beam_of(shape_of(BeamShape::box, true), line(), rubber);
    line_of.stay();
    for (unsigned i = 1; i <= 4; ++i)
      line_of.move_to(distorted(line_of.coordinates, 0.05, i), random_turns(2, 0.05, 7 + i));
    REQUIRE(line_of.forces().norm() > 1e-3 * size_of_forces);
    check_derivatives_of_work(line_of, 1e-7 * size_of_forces);
    if (!is_truss) CHECK(line_of.stay().stable_step <= (1.0 + 1e-6) * stable_limit(line_of));
  }
}

TEST_CASE("a truss with an initial load pulls by it before it is stretched, and as its period has it",
          "[core][beams]") {
  const Matrix3Xd x = line();
  LoneShell at_once = truss_of(0.01, x);
  at_once.block.preload = {3e6, 0.0};
  at_once.state = make_state(at_once.block);
  at_once.stay();
  const Vector3d axis = (x.col(1) - x.col(0)).normalized();
  CHECK((at_once.forces().col(0) - 3e6 * axis).norm() < 1e-3);
  Matrix3Xd there = x;
  there.col(1) += 1e-6 * axis;
  at_once.move_to(there, Matrix3Xd::Zero(3, 2));
  CHECK(at_once.forces().col(0).norm() == Approx(3e6 + 1e-6 / 0.8 * youngs * 0.01).epsilon(1e-9));

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
