// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/neo_hookean.hpp"

#include <Eigen/Dense>
#include <random>

#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using contactsim::test::rotation_of;
using Eigen::Matrix3d;

namespace {

constexpr double bulk = 10.0, shear = 3.0;

double energy(const Matrix3d& f) {
  const double j = f.determinant();
  return bulk / 4.0 * (j * j - 1.0) - bulk / 2.0 * std::log(j) +
         shear / 2.0 * (std::pow(j, -2.0 / 3.0) * f.squaredNorm() - 3.0);
}

/// First Piola-Kirchhoff stress by differences of the energy.
Matrix3d piola(const Matrix3d& f) {
  constexpr double h = 1e-5;
  Matrix3d p;
  for (Eigen::Index i = 0; i < 9; ++i) {
    Matrix3d more = f, less = f;
    more(i) += h;
    less(i) -= h;
    p(i) = (energy(more) - energy(less)) / (2.0 * h);
  }
  return p;
}

/// A material point in lane 0, with other lanes elsewhere.
struct Point {
  NeoHookeanLaw law{{bulk, shear}};
  std::array<Lanes, 6> state;
  SymmetricLanes stress = SymmetricLanes::zero();
  LaneModuli moduli{};
  Matrix3d f = Matrix3d::Identity();

  Point() { law.start(state); }

  void deform_to(const Matrix3d& next) {
    const Matrix3d gradient = (next - f) * (0.5 * (next + f)).inverse();
    StrainStep step{SymmetricLanes::zero(), {}, 1.0};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        step.gradient[i][j].setConstant(0.1 * (i == j));
        step.gradient[i][j](0) = gradient(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
    moduli = law.update(step, stress, state);
    f = next;
  }
  Matrix3d cauchy() const {
    const auto& s = stress;
    return Matrix3d{{s[0](0), s[3](0), s[5](0)}, {s[3](0), s[1](0), s[4](0)}, {s[5](0), s[4](0), s[2](0)}};
  }
};

Matrix3d random_deformation(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  return Matrix3d::Identity() + Matrix3d::NullaryExpr([&] { return number(random); });
}

}  // namespace

TEST_CASE("a neo-Hookean body stretched to twice its length has the stress of its formula",
          "[core][materials]") {
  Point point;
  point.deform_to(Eigen::Vector3d(2.0, 1.0, 1.0).asDiagonal());
  // J = 2, B = diag(4, 1, 1), trace 6, deviator diag(2, -1, -1); pressure part 10/2 (2 - 1/2)
  const double factor = 3.0 * std::pow(2.0, -5.0 / 3.0);
  const Matrix3d expected = Eigen::Vector3d(7.5 + 2.0 * factor, 7.5 - factor, 7.5 - factor).asDiagonal();
  CHECK((point.cauchy() - expected).norm() < 1e-13);
}

TEST_CASE("the neo-Hookean stress is the derivative of its energy", "[core][materials]") {
  std::mt19937 random(3);
  for (int i = 0; i < 10; ++i) {
    Point point;
    const Matrix3d f = random_deformation(random, 0.3);
    point.deform_to(f);
    const Matrix3d expected = piola(f) * f.transpose() / f.determinant();
    CHECK((point.cauchy() - expected).norm() < 1e-8 * bulk);
  }
}

TEST_CASE("the neo-Hookean stress does not depend on the way, and turns with the body", "[core][materials]") {
  std::mt19937 random(4);
  Point straight, detour;
  const Matrix3d f = random_deformation(random, 0.3);
  straight.deform_to(f);
  for (int i = 0; i < 20; ++i) detour.deform_to(random_deformation(random, 0.3));
  detour.deform_to(f);
  CHECK((detour.cauchy() - straight.cauchy()).norm() < 1e-12 * bulk);
  for (int i = 1; i <= 5; ++i) detour.deform_to(rotation_of(0.5 * i) * f);
  const Matrix3d turn = rotation_of(2.5);
  CHECK((detour.cauchy() - turn * straight.cauchy() * turn.transpose()).norm() < 1e-12 * bulk);
  detour.deform_to(turn);
  CHECK(detour.cauchy().norm() < 1e-12 * bulk);
}

TEST_CASE("the neo-Hookean bounds hold for the tangent at any deformation, and exactly at rest",
          "[core][materials]") {
  std::mt19937 random(5);
  for (const double size : {0.0, 0.05, 0.4, 0.6}) {
    const Matrix3d f = random_deformation(random, size);
    if (f.determinant() < 0.1) continue;
    Point point;
    point.deform_to(f);
    constexpr double h = 1e-4;
    // The power of a velocity gradient L on the rate of the first Piola-Kirchhoff stress, per present volume.
    Eigen::Matrix<double, 9, 9> power;
    for (Eigen::Index k = 0; k < 9; ++k) {
      Matrix3d l = Matrix3d::Zero();
      l(k) = 1.0;
      const Matrix3d rate = (piola(f + h * l * f) - piola(f - h * l * f)) / (2.0 * h);
      const Matrix3d spatial = rate * f.transpose() / f.determinant();
      power.col(k) = spatial.reshaped();
    }
    const Eigen::Matrix<double, 9, 1> one = Matrix3d::Identity().reshaped();
    const Eigen::Matrix<double, 9, 9> bound =
        point.moduli.lambda()(0) * one * one.transpose() +
        2.0 * point.moduli.shear(0) * Eigen::Matrix<double, 9, 9>::Identity();
    const Eigen::Matrix<double, 9, 9> excess = 0.5 * (power + power.transpose()) - bound;
    const double largest =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(excess).eigenvalues()(8);
    CHECK(largest <= 1e-4 * bulk);  // differences of differences
    if (size == 0.0) CHECK(largest >= -1e-4 * bulk);
  }
}
