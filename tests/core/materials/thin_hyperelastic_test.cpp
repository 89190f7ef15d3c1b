// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/thin_hyperelastic.hpp"

#include <Eigen/Dense>
#include <random>

#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/neo_hookean.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Matrix3d;

namespace thin_hyperelastic_test {

namespace {

constexpr ElasticModuli rubber{1000.0, 3.0};
constexpr double c01 = 0.4;

/// The point of a shell, whose surface is strained in steps.
template <class Law>
struct PlanePoint {
  Law law;
  std::array<Lanes, 6> state;
  PlaneLanes stress;

  explicit PlanePoint(const Law& its_law) : law(its_law) {
    law.start(state);
    for (Lanes& component : stress) component.setZero();
  }
  void move(const std::array<double, 5>& strain) {
    PlaneStep step{{}, 1.0};
    for (std::size_t i = 0; i < 5; ++i) step.strain[i].setConstant(strain[i]);
    law.update_plane(step, stress, state);
  }
  /// Stretches x and y to lengths from others in one step.
  void stretch(double x_from, double x_to, double y_from, double y_to) {
    move({2.0 * (x_to - x_from) / (x_to + x_from), 2.0 * (y_to - y_from) / (y_to + y_from), 0.0, 0.0, 0.0});
  }
  double thickness() const { return law.plane_thinning(state)(0); }
};

struct FibrePoint {
  NeoHookeanLaw law{rubber};
  std::array<Lanes, 6> state;
  FibreLanes stress;

  FibrePoint() { law.start(state); }
  void move(const std::array<double, 3>& strain) {
    FibreStep step{{}, 1.0};
    for (std::size_t i = 0; i < 3; ++i) step.strain[i].setConstant(strain[i]);
    law.update_fibre(step, stress, state);
  }
  double area() const { return law.fibre_thinning(state)(0); }
};

SymmetricLanes tensor_of(std::span<const Lanes> state) {
  return {{state[0], state[1], state[2], state[3], state[4], state[5]}};
}

}  // namespace

TEST_CASE("a nearly incompressible sheet follows Rivlin's formula of equal stretch",
          "[core][materials][shells]") {
  PlanePoint<MooneyRivlinLaw> stiff(MooneyRivlinLaw{{1e9, 3.0}, c01});
  stiff.stretch(1.0, 1.5, 1.0, 1.3);  // any way there
  stiff.stretch(1.5, 1.7, 1.3, 1.7);
  const double c10 = 1.5 - c01, squared = 1.7 * 1.7;
  CHECK(stiff.thickness() == Approx(1.0 / squared).epsilon(1e-8));
  CHECK(stiff.stress[0](0) ==
        Approx(2.0 * (squared - 1.0 / (squared * squared)) * (c10 + squared * c01)).epsilon(1e-6));
  CHECK(stiff.stress[1](0) == Approx(stiff.stress[0](0)).epsilon(1e-7));
}

TEST_CASE("a sheet has no stress across to round-off, whatever it suffers", "[core][materials][shells]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(-0.1, 0.1);
  for (const double second : {0.0, c01, 1.5}) {
    const MooneyRivlinLaw law{rubber, second};
    PlanePoint<MooneyRivlinLaw> point(law);
    for (int step = 0; step < 50; ++step) {
      point.move({size(random), size(random), size(random), size(random), size(random)});
      const hyperelastic::Response solid = law.at(tensor_of(point.state));
      CHECK(std::abs(solid.stress[2](0)) < 1e-12 * rubber.bulk);
      for (std::size_t i = 0; i < 5; ++i) CHECK(point.stress[i](0) == solid.stress[plane_places[i]](0));
    }
  }
}

TEST_CASE("a sheet's work in a closed path is nothing, and its energy is that of the body",
          "[core][materials][shells]") {
  const NeoHookeanLaw law{rubber};
  PlanePoint<NeoHookeanLaw> point(law);
  constexpr int n = 4000;
  double work = 0.0, x = 1.0, y = 1.0, half = 0.0;
  for (int i = 1; i <= n; ++i) {
    const double turn = 2.0 * std::acos(-1.0) * i / n;
    const double next_x = 1.0 + 0.3 * (1.0 - std::cos(turn)), next_y = 1.0 + 0.4 * std::sin(turn);
    const double area = 0.5 * (x + next_x) * 0.5 * (y + next_y), thick = point.thickness();
    const double before[2] = {thick * point.stress[0](0), thick * point.stress[1](0)};
    point.stretch(x, next_x, y, next_y);
    const double after[2] = {point.thickness() * point.stress[0](0), point.thickness() * point.stress[1](0)};
    work += 0.5 * area *
            ((before[0] + after[0]) * 2.0 * (next_x - x) / (next_x + x) +
             (before[1] + after[1]) * 2.0 * (next_y - y) / (next_y + y));
    x = next_x;
    y = next_y;
    if (2 * i == n) half = work;
  }
  const double stretch = 1.6, z = [&] {
    PlanePoint<NeoHookeanLaw> there(law);
    there.stretch(1.0, stretch, 1.0, 1.0);
    return there.thickness();
  }();
  const double j = stretch * z;
  const double energy =
      rubber.bulk / 4.0 * (j * j - 1.0) - rubber.bulk / 2.0 * std::log(j) +
      rubber.shear / 2.0 * (std::pow(j, -2.0 / 3.0) * (stretch * stretch + 1.0 + z * z) - 3.0);
  CHECK(half == Approx(energy).epsilon(1e-5));  // of second order in the step
  CHECK(std::abs(work) < 1e-5 * energy);
}

TEST_CASE("small strains of a sheet and a fibre meet the moduli of elasticity", "[core][materials][shells]") {
  const PlaneModuli plane(rubber);
  PlanePoint<MooneyRivlinLaw> sheet(MooneyRivlinLaw{rubber, c01});
  const PlaneLanes none{Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  CHECK(sheet.law.plane_stiffening(sheet.state)(0) == Approx(1.0));
  const std::array<double, 5> strain{2e-6, -1e-6, 3e-6, 1e-6, -2e-6};
  sheet.move(strain);
  PlaneLanes expected = none, lanes;
  for (std::size_t i = 0; i < 5; ++i) lanes[i].setConstant(strain[i]);
  plane.add(lanes, expected);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(sheet.stress[i](0) == Approx(expected[i](0)).margin(1e-4 * rubber.shear * 3e-6));
  FibrePoint fibre;
  CHECK(fibre.law.fibre_stiffening(fibre.state)(0) == Approx(1.0));
  fibre.move({2e-6, 1e-6, -3e-6});
  CHECK(fibre.stress[0](0) == Approx(rubber.youngs() * 2e-6).epsilon(1e-4));
  CHECK(fibre.stress[1](0) == Approx(rubber.shear * 1e-6).epsilon(1e-4));
  CHECK(fibre.stress[2](0) == Approx(rubber.shear * -3e-6).epsilon(1e-4));
}

TEST_CASE("a nearly incompressible fibre pulled to twice its length follows Rivlin's formula",
          "[core][materials][lines]") {
  FibrePoint fibre;
  fibre.law = NeoHookeanLaw{{1e9, 3.0}};
  fibre.move({2.0 / 3.0, 0.0, 0.0});  // 2 (2 - 1) / (2 + 1)
  CHECK(fibre.area() == Approx(0.5).epsilon(1e-8));
  CHECK(fibre.stress[0](0) == Approx(3.0 * (4.0 - 0.5)).epsilon(1e-7));
}

TEST_CASE("a fibre has no stress across to round-off, whatever it suffers", "[core][materials][lines]") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> size(-0.1, 0.1);
  FibrePoint fibre;
  for (int step = 0; step < 50; ++step) {
    fibre.move({size(random), size(random), size(random)});
    const SymmetricLanes b = tensor_of(fibre.state);
    const hyperelastic::Response solid = MooneyRivlinLaw{rubber}.at(b);
    for (const std::size_t i : {1, 2, 4}) CHECK(std::abs(solid.stress[i](0)) < 1e-12 * rubber.bulk);
    CHECK(fibre.stress[0](0) == solid.stress[0](0));
  }
}

}  // namespace thin_hyperelastic_test
