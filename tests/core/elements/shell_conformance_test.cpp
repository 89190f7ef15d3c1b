// SPDX-License-Identifier: BSD-3-Clause
// What every shell must do. Moduli are near 1e11, edges near 1, steps of size 1.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "core/materials/elastic.hpp"
#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/orthotropic.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace shell_conformance_test {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
constexpr double size_of_forces = 1e11;  // modulus x area

const MaterialLaw elastic = ElasticLaw{steel};

/// Laws that give back what they took; the last is three times as stiff along x as along z.
std::vector<MaterialLaw> elastic_laws() {
  return {elastic, NeoHookeanLaw{steel}, MooneyRivlinLaw{steel, 15e9},
          make_orthotropic_law({{}, 300e9, 200e9, 100e9, 0.3, 0.2, 0.4, 80e9, 60e9, 100e9})};
}

/// Calls check(row, coordinates, thickness, law) for every row and law, in a distorted and warped form.
template <class Check>
void for_each_law(const Check& check) {
  for (const ElementFormulation* row : shell_elements()) {
    std::size_t i = 0;
    for (const MaterialLaw& law : elastic_laws()) {
      INFO(name_of(*row) << ", law " << i++);
      const Matrix3Xd x = distorted(regular_shell(row->shape), 0.1, 4);
      check(*row, Matrix3Xd(rotation_of(0.7) * x), 0.1, law);
    }
  }
}

/// Calls check(row, coordinates, thickness) for every row: regular, distorted in the plane, and warped.
template <class Check>
void for_each_form(const Check& check) {
  for (const ElementFormulation* row : shell_elements()) {
    for (const double distortion : {0.0, 0.15}) {
      for (const double warp : {0.0, 0.1}) {
        for (const double thickness : {0.02, 0.3}) {
          INFO(name_of(*row) << ", distortion " << distortion << ", warp " << warp << ", t " << thickness);
          Matrix3Xd x = distorted(regular_shell(row->shape), distortion, 4);
          x.row(2) = distorted(Matrix3Xd::Zero(3, x.cols()), warp, 9).row(2);
          check(*row, Matrix3Xd(rotation_of(0.7) * x), thickness);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("a rigid motion of a shell in large steps strains nothing and turns its forces",
          "[core][shells][conformance]") {
  for_each_form([](const ElementFormulation& row, const Matrix3Xd& x, double thickness) {
    const Eigen::Index n = x.cols();
    LoneShell shell(row, elastic, x, thickness);
    for (int i = 1; i <= 5; ++i) {
      const Matrix3Xd there = (rotation_of(0.3 * i) * x).colwise() + Vector3d(1.0 * i, 2.0, 3.0);
      shell.move_to(there, turns_of(0.3, n));
    }
    CHECK(shell.forces().norm() < 1e-14 * size_of_forces);
    CHECK(shell.moments().norm() < 1e-14 * size_of_forces);

    LoneShell strained(row, elastic, x, thickness);
    const Matrix3Xd there = distorted(x, 1e-3, 2);
    strained.move_to(there, random_turns(n, 1e-3, 5));
    const LoneShell before = strained;
    REQUIRE(before.forces().norm() > 1e-5 * size_of_forces);
    for (int i = 1; i <= 5; ++i) strained.move_to(rotation_of(0.3 * i) * there, turns_of(0.3, n));
    const Matrix3d turn = rotation_of(1.5);
    CHECK((strained.forces() - turn * before.forces()).norm() < 1e-13 * size_of_forces);
    CHECK((strained.moments() - turn * before.moments()).norm() < 1e-13 * size_of_forces);
    CHECK(strained.stress_work() == Approx(before.stress_work()).epsilon(1e-9));
  });
}

TEST_CASE("a shell of any law turns with its forces", "[core][shells][conformance]") {
  for_each_law(
      [](const ElementFormulation& row, const Matrix3Xd& x, double thickness, const MaterialLaw& law) {
        LoneShell shell(row, law, x, thickness);
        const Matrix3Xd there = distorted(x, 0.05, 2);
        shell.move_to(there, random_turns(x.cols(), 0.01, 5));
        const LoneShell before = shell;
        for (int i = 1; i <= 5; ++i) shell.move_to(rotation_of(0.3 * i) * there, turns_of(0.3, x.cols()));
        const Matrix3d turn = rotation_of(1.5);
        CHECK((shell.forces() - turn * before.forces()).norm() < 1e-12 * size_of_forces);
        CHECK((shell.moments() - turn * before.moments()).norm() < 1e-12 * size_of_forces);
        const LoneShell there_too = shell;
        shell.stay();
        CHECK((shell.forces() - there_too.forces()).norm() <= 1e-12 * size_of_forces);
      });
}

TEST_CASE("forces and moments of a shell of any law are the derivatives of the work",
          "[core][shells][conformance]") {
  for_each_law(
      [](const ElementFormulation& row, const Matrix3Xd& x, double thickness, const MaterialLaw& law) {
        LoneShell shell(row, law, x, thickness);
        for (unsigned i = 1; i <= 4; ++i)
          shell.move_to(distorted(shell.coordinates, 0.05, i), random_turns(x.cols(), 0.05, 7 + i));
        check_derivatives_of_work(shell, 1e-8 * size_of_forces);
      });
}

TEST_CASE("the stable step of a stretched shell of any law is below that of its highest frequency",
          "[core][shells][conformance]") {
  for_each_law(
      [](const ElementFormulation& row, const Matrix3Xd& x, double thickness, const MaterialLaw& law) {
        LoneShell shell(row, law, x, thickness);
        CHECK(shell.stay().stable_step <= (1.0 + 1e-6) * stable_limit(shell));
        for (const double stretch : {1.6, 0.7}) {
          LoneShell moved = shell;
          const Matrix3d turn = rotation_of(0.7);
          const Matrix3d f = turn * Vector3d(stretch, 1.1, 1.0).asDiagonal() * turn.transpose();
          const Matrix3Xd way = (f - Matrix3d::Identity()) * x / 10.0;
          for (int i = 1; i <= 10; ++i) moved.move_to(x + i * way, Matrix3Xd::Zero(3, x.cols()));
          const bool stiffens = law.get_if<NeoHookeanLaw>() || law.get_if<MooneyRivlinLaw>();
          if (!stiffens) continue;
          CHECK(moved.stay().stable_step <= (1.0 + 1e-6) * stable_limit(moved));
        }
      });
}

TEST_CASE("forces and moments of a shell balance", "[core][shells][conformance]") {
  for_each_form([](const ElementFormulation& row, const Matrix3Xd& x, double thickness) {
    LoneShell shell(row, elastic, x, thickness);
    shell.move_to(distorted(x, 0.01, 2), random_turns(x.cols(), 0.01, 3));
    const Matrix3Xd force = shell.forces();
    CHECK(force.rowwise().sum().norm() < 1e-13 * force.norm());
    Vector3d moment = shell.moments().rowwise().sum();
    for (Eigen::Index node = 0; node < x.cols(); ++node)
      moment += Vector3d(shell.coordinates.col(node)).cross(Vector3d(force.col(node)));
    CHECK(moment.norm() < 1e-12 * force.norm());
  });
}

TEST_CASE("forces and moments of a shell are the derivatives of the work", "[core][shells][conformance]") {
  for_each_form([](const ElementFormulation& row, const Matrix3Xd& x, double thickness) {
    const Eigen::Index n = x.cols();
    LoneShell shell(row, elastic, x, thickness);
    for (unsigned i = 1; i <= 4; ++i)
      shell.move_to(distorted(shell.coordinates, 0.01, i), random_turns(n, 0.01, 7 + i));
    check_derivatives_of_work(shell, 1e-8 * size_of_forces);
  });
}

TEST_CASE("rigid motions and fibres that turn about themselves are all that a shell does not resist",
          "[core][shells][conformance]") {
  for_each_form([](const ElementFormulation& row, const Matrix3Xd& x, double thickness) {
    const Eigen::MatrixXd stiffness = stiffness_of(LoneShell(row, elastic, x, thickness));
    CHECK((stiffness - stiffness.transpose()).norm() < 1e-5 * stiffness.norm());
    const Eigen::MatrixXd symmetric = 0.5 * (stiffness + stiffness.transpose());
    const Eigen::VectorXd ascending =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
    const Eigen::Index n_free = 6 + x.cols();
    const double bending = size_of_forces * thickness * thickness * thickness;
    CHECK(ascending.head(n_free).cwiseAbs().maxCoeff() <
          std::max(1e-5 * bending, 1e-7 * size_of_forces * thickness));  // round-off of the differences
    CHECK(ascending(n_free) > 2e-3 * bending);
  });
}

TEST_CASE("the stable step of a shell is below that of its highest frequency",
          "[core][shells][conformance]") {
  for_each_form([](const ElementFormulation& row, const Matrix3Xd& x, double thickness) {
    for (const double offset : {0.0, 0.5}) {
      ShellSettings settings = gauss_layers();
      settings.offset = offset;
      LoneShell shell(row, elastic, x, thickness, settings);
      const double limit = stable_limit(shell), bound = shell.stay().stable_step;
      CHECK(bound <= (1.0 + 1e-6) * limit);
      CHECK(bound > 0.6 * limit);
    }
  });
}

TEST_CASE("asking for the forces where a shell stands changes nothing", "[core][shells][conformance]") {
  for_each_form([](const ElementFormulation& row, const Matrix3Xd& x, double thickness) {
    LoneShell shell(row, elastic, x, thickness);
    shell.stay();
    CHECK(shell.forces() == Matrix3Xd::Zero(3, x.cols()));
    shell.move_to(distorted(x, 0.01, 2), random_turns(x.cols(), 0.01, 3));
    const LoneShell before = shell;
    shell.stay();
    CHECK((shell.forces() - before.forces()).norm() <= 1e-12 * before.forces().norm());
    CHECK((shell.moments() - before.moments()).norm() <= 1e-12 * before.forces().norm());
  });
}

TEST_CASE("a flat shell of any form has the membrane forces, moments and shear of a uniform strain",
          "[core][shells][conformance]") {
  for (const ElementFormulation* row : shell_elements()) {
    INFO(name_of(*row));
    const double t = 0.1, size = 1e-7;
    const Matrix3Xd x = [&] {
      Matrix3Xd flat = distorted(regular_shell(row->shape), 0.15, 4);
      flat.row(2).setZero();
      return flat;
    }();
    // u = G x in the plane, w = x.K x / 2 and the fibres follow its slope: psi = -grad w, turns (grad w_y,
    // -grad w_x).
    const Eigen::Matrix2d g{{0.6, 0.3}, {-0.1, -0.5}}, k{{0.7, 0.2}, {0.2, -0.4}};
    Matrix3Xd there = x, turns = Matrix3Xd::Zero(3, x.cols());
    for (Eigen::Index node = 0; node < x.cols(); ++node) {
      const Eigen::Vector2d at = x.col(node).head<2>(), slope = k * at;
      there.col(node) += size * Vector3d((g * at).x(), (g * at).y(), 0.5 * at.dot(slope));
      turns.col(node) = size * Vector3d(slope.y(), -slope.x(), 0.0);
    }
    LoneShell shell(*row, elastic, x, t);
    const ChunkStep step = shell.move_to(there, turns);
    CHECK(std::abs(step.hourglass_work) < 1e-12 * shell.stress_work());
    const double across = 2.0 * steel.shear * steel.lambda() / (steel.lambda() + 2.0 * steel.shear);
    const Matrix3d frame = row->frame(x);
    for (std::size_t layer = 0; layer < 3; ++layer) {
      const double z = 0.5 * t * shell.block.shell.layers[layer].place;
      const Eigen::Matrix2d strain = size * (0.5 * (g + g.transpose()) - z * k);
      Matrix3d expected = Matrix3d::Zero();
      expected.topLeftCorner<2, 2>() =
          across * strain.trace() * Eigen::Matrix2d::Identity() + 2.0 * steel.shear * strain;
      const Matrix3d stress = frame.transpose() * shell.stress(layer) * frame;
      CHECK((stress - expected).norm() < 1e-6 * size * 1e11);
    }
  }
}

}  // namespace shell_conformance_test
