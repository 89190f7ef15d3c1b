// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/mooney_rivlin.hpp"

#include "core/materials/neo_hookean.hpp"
#include "support/catch.hpp"
#include "support/hyperelastic_point.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double bulk = 10.0, c10 = 0.9, c01 = 0.6;

MooneyRivlinLaw law_of(double first, double second) { return {{bulk, 2.0 * (first + second)}, second}; }

/// A material point in lane 0.
struct Point : HyperelasticPoint<MooneyRivlinLaw> {
  Point() : HyperelasticPoint(law_of(c10, c01)) {}
};

auto energy_of(double first, double second) {
  return [first, second](const Matrix3d& f) {
    const double j = f.determinant(), i1 = f.squaredNorm(), i2 = j * j * f.inverse().squaredNorm();
    return bulk / 4.0 * (j * j - 1.0) - bulk / 2.0 * std::log(j) +
           first * (std::pow(j, -2.0 / 3.0) * i1 - 3.0) + second * (std::pow(j, -4.0 / 3.0) * i2 - 3.0);
  };
}

}  // namespace

TEST_CASE("a Mooney-Rivlin body stretched to twice its length has the stress of its formula",
          "[core][materials]") {
  Point point;
  point.deform_to(Vector3d(2.0, 1.0, 1.0).asDiagonal());
  // J = 2, B = diag(4, 1, 1), tr(B) B - B^2 = diag(8, 5, 5); both deviators are diag(2, -1, -1).
  const double factor = c10 * std::pow(2.0, -2.0 / 3.0) + c01 * std::pow(2.0, -4.0 / 3.0);
  const Matrix3d expected = Vector3d(7.5 + 2.0 * factor, 7.5 - factor, 7.5 - factor).asDiagonal();
  CHECK((point.cauchy() - expected).norm() < 1e-13);
}

TEST_CASE("at constant volume a Mooney-Rivlin body follows Rivlin's formulas", "[core][materials]") {
  const double stretch = 1.7;
  Point pulled, sheet, sheared;
  pulled.deform_to(Vector3d(stretch, 1.0 / std::sqrt(stretch), 1.0 / std::sqrt(stretch)).asDiagonal());
  const Matrix3d along = pulled.cauchy();
  CHECK(along(0, 0) - along(1, 1) ==
        Approx(2.0 * (stretch * stretch - 1.0 / stretch) * (c10 + c01 / stretch)));
  sheet.deform_to(Vector3d(stretch, stretch, 1.0 / (stretch * stretch)).asDiagonal());
  const Matrix3d both = sheet.cauchy();
  CHECK(both(0, 0) - both(2, 2) ==
        Approx(2.0 * (stretch * stretch - std::pow(stretch, -4.0)) * (c10 + stretch * stretch * c01)));
  Matrix3d shear = Matrix3d::Identity();
  shear(0, 1) = 0.8;
  sheared.deform_to(shear);
  const Matrix3d slid = sheared.cauchy();
  CHECK(slid(0, 1) == Approx(2.0 * (c10 + c01) * 0.8));
  CHECK(slid(0, 0) - slid(2, 2) == Approx(2.0 * c10 * 0.64));
  CHECK(slid(1, 1) - slid(2, 2) == Approx(-2.0 * c01 * 0.64));
}

TEST_CASE("the Mooney-Rivlin stress is the derivative of its energy, on any way there", "[core][materials]") {
  std::mt19937 random(3);
  Point detour;
  for (int i = 0; i < 10; ++i) {
    Point point;
    const Matrix3d f = random_deformation(random, 0.3);
    point.deform_to(f);
    detour.deform_to(f);
    const Matrix3d expected = piola(energy_of(c10, c01), f) * f.transpose() / f.determinant();
    CHECK((point.cauchy() - expected).norm() < 1e-8 * bulk);
    CHECK((detour.cauchy() - point.cauchy()).norm() < 1e-12 * bulk);
  }
  const Matrix3d turn = rotation_of(2.5);
  detour.deform_to(turn);
  CHECK(detour.cauchy().norm() < 1e-12 * bulk);
}

TEST_CASE("without its second constant Mooney-Rivlin is neo-Hookean", "[core][materials]") {
  std::mt19937 random(6);
  HyperelasticPoint<MooneyRivlinLaw> point(law_of(1.5, 0.0));
  HyperelasticPoint<NeoHookeanLaw> other(NeoHookeanLaw{{bulk, 3.0}});
  const Matrix3d f = random_deformation(random, 0.3);
  point.deform_to(f);
  other.deform_to(f);
  CHECK((point.cauchy() - other.cauchy()).norm() < 1e-14 * bulk);
  CHECK(point.moduli.shear(0) == Approx(other.moduli.shear(0)).epsilon(1e-14));
  CHECK(point.moduli.bulk(0) == Approx(other.moduli.bulk(0)).epsilon(1e-14));
}

TEST_CASE("the Mooney-Rivlin bounds hold for the tangent at any deformation, and exactly at rest",
          "[core][materials]") {
  std::mt19937 random(5);
  for (const auto& [first, second] : {std::pair(0.0, 1.5), std::pair(c10, c01), std::pair(2.0, -0.5)}) {
    for (const double size : {0.0, 0.05, 0.4, 0.6, 0.6}) {
      const Matrix3d f = random_deformation(random, size);
      if (f.determinant() < 0.1) continue;
      HyperelasticPoint<MooneyRivlinLaw> point(law_of(first, second));
      point.deform_to(f);
      const double largest = excess_over(point.moduli, energy_of(first, second), f);
      CHECK(largest <= 1e-4 * bulk);  // differences of differences
      if (size == 0.0) CHECK(largest >= -1e-4 * bulk);
    }
  }
}
