// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/neo_hookean.hpp"

#include "support/catch.hpp"
#include "support/hyperelastic_point.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;

namespace neo_hookean_test {

namespace {

constexpr double bulk = 10.0, shear = 3.0;

double energy(const Matrix3d& f) {
  const double j = f.determinant();
  return bulk / 4.0 * (j * j - 1.0) - bulk / 2.0 * std::log(j) +
         shear / 2.0 * (std::pow(j, -2.0 / 3.0) * f.squaredNorm() - 3.0);
}

/// A material point in lane 0.
struct Point : HyperelasticPoint<NeoHookeanLaw> {
  Point() : HyperelasticPoint(NeoHookeanLaw{{bulk, shear}}) {}
};

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
    const Matrix3d expected = piola(energy, f) * f.transpose() / f.determinant();
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
    const double largest = excess_over(point.moduli, energy, f);
    CHECK(largest <= 1e-4 * bulk);  // differences of differences
    if (size == 0.0) CHECK(largest >= -1e-4 * bulk);
  }
}

}  // namespace neo_hookean_test
