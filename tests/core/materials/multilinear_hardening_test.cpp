// SPDX-License-Identifier: BSD-3-Clause
// The returns to a curve against slow ones, by halving alone, of one point.
#include "core/materials/multilinear_hardening.hpp"

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "support/catch.hpp"
#include "support/root_by_halving.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;

namespace multilinear_hardening_test {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
const std::vector<FunctionPoint> points{
    {0.0, 200e6}, {0.001, 260e6}, {0.004, 300e6}, {0.02, 340e6}, {0.05, 340e6}};

PlasticLaw<MultilinearHardening> law_of(double beta) { return {steel, {HardeningCurve(points), beta}}; }

Matrix3d deviatoric(const Matrix3d& a) { return a - a.trace() / 3.0 * Matrix3d::Identity(); }

/// One point of the solid law.
struct SlowPoint {
  double beta;
  Matrix3d stress = Matrix3d::Zero(), back = Matrix3d::Zero();
  double eqps = 0.0;
  PiecewiseLinear curve{points};

  void strain(const Matrix3d& e) {
    stress += steel.lambda() * e.trace() * Matrix3d::Identity() + 2.0 * steel.shear * e;
    const Matrix3d relative = deviatoric(stress) - back;
    const double trial = std::sqrt(1.5) * relative.norm();
    const auto grown = [&](double x) { return curve.evaluate(eqps + x) - curve.evaluate(eqps); };
    const double radius = (1.0 - beta) * curve.evaluate(0.0) + beta * curve.evaluate(eqps);
    if (trial <= radius) return;
    const double x = root_by_halving(
        [&](double y) { return trial - 3.0 * steel.shear * y - radius - grown(y); }, 0.0, 1.0);
    stress -= 3.0 * steel.shear * x / trial * relative;
    back += (1.0 - beta) * grown(x) / trial * relative;
    eqps += x;
  }
};

struct FastPoint {
  PlasticLaw<MultilinearHardening> law;
  SymmetricLanes stress = SymmetricLanes::zero();
  std::array<Lanes, 7> state;

  explicit FastPoint(const PlasticLaw<MultilinearHardening>& its_law) : law(its_law) { law.start(state); }
  void strain(const Matrix3d& e) {
    StrainStep step{SymmetricLanes::zero(), {}, 1.0};
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = i; j < 3; ++j) step.strain[symmetric_place[i][j]].setConstant(e(i, j));
    }
    law.update(step, stress, state);
  }
};

}  // namespace

TEST_CASE("the radial return to a curve is that of halving, for any share of kinematic hardening",
          "[core][materials]") {
  const double beta = GENERATE(0.0, 0.4, 1.0), size = GENERATE(5e-4, 1e-2);  // the larger passes many points
  SlowPoint slow{beta};
  FastPoint fast(law_of(beta));
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, size);
  for (int step = 0; step < 200; ++step) {
    const Matrix3d gradient = Matrix3d::NullaryExpr([&] { return normal(random); });
    const Matrix3d strain = deviatoric(0.5 * (gradient + gradient.transpose()));
    slow.strain(strain);
    fast.strain(strain);
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = i; j < 3; ++j) {
        const std::size_t place = symmetric_place[i][j];
        CHECK(fast.stress[place](0) == Approx(slow.stress(i, j)).margin(1e-3));  // of 1e8
        CHECK(fast.state[place](0) == Approx(slow.back(i, j)).margin(1e-3));
      }
    }
    CHECK(fast.state[6](0) == Approx(slow.eqps).epsilon(1e-12));
  }
  CHECK(slow.eqps > 0.05);
}

TEST_CASE("a return that ends on a point or between points is exact", "[core][materials]") {
  const MultilinearHardening hardening{HardeningCurve(points), 1.0};
  const auto end = [&](double eqps, double strain) {  // what is left of an equivalent strain, elastic from 0
    const Lanes start = Lanes::Constant(eqps), stress = Lanes::Constant(3.0 * steel.shear * strain);
    return return_to(hardening, SolidTrial{stress, start, steel.shear, 1.0});
  };
  // 3 G (e - x) = 260e6 at x = 0.001; 240e9 (e - 0.002) = 260e6 + 1/3 40e6 at x = 0.002
  CHECK(end(0.0, 0.001 + 260e6 / 240e9)->increment(0) == Approx(0.001).epsilon(1e-14));
  CHECK(end(0.0, 0.002 + (260e6 + 40e6 / 3.0) / 240e9)->increment(0) == Approx(0.002).epsilon(1e-14));
  CHECK(end(0.0, 0.03 + 340e6 / 240e9)->increment(0) == Approx(0.03).epsilon(1e-14));
  CHECK(end(0.1, 0.2 + 340e6 / 240e9)->increment(0) == Approx(0.2).epsilon(1e-14));
  CHECK_FALSE(end(0.0, 200e6 / 240e9));
  CHECK_FALSE(return_to(hardening, SolidTrial{Lanes::Constant(1e9), Lanes::Zero(), steel.shear, 0.0}));
}

TEST_CASE("kinematic hardening along a curve yields early on the way back, isotropic late",
          "[core][materials]") {
  const double beta = GENERATE(0.0, 1.0);
  FastPoint point(law_of(beta));
  Matrix3d shear = Matrix3d::Zero();
  // Equivalent strain of a shear strain e: 2 e / sqrt(3). To the point at 0.004: 300e6.
  const double per_equivalent = 0.5 * std::sqrt(3.0);
  shear(0, 1) = shear(1, 0) = per_equivalent * (0.004 + 300e6 / 240e9);
  point.strain(shear);
  CHECK(point.state[6](0) == Approx(0.004));
  CHECK(point.stress[3](0) == Approx(300e6 / std::sqrt(3.0)));
  const double range = beta == 0.0 ? 2.0 * 200e6 : 2.0 * 300e6;
  shear(0, 1) = shear(1, 0) = -per_equivalent * range / 240e9 * (1.0 - 1e-9);
  point.strain(shear);
  CHECK(point.state[6](0) == Approx(0.004).epsilon(1e-12));
  shear *= 0.01;
  point.strain(shear);
  CHECK(point.state[6](0) > 0.004);
}

TEST_CASE("a fibre in tension follows the curve", "[core][materials][lines]") {
  const double beta = GENERATE(0.0, 0.5, 1.0);
  const int n_steps = GENERATE(1, 40);
  const PlasticLaw<MultilinearHardening> law = law_of(beta);
  FibreLanes stress{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  std::array<Lanes, 7> state;
  law.start(state);
  const double strain = 0.012 + 320e6 / steel.youngs();
  for (int i = 0; i < n_steps; ++i)
    law.update_fibre({{Lanes::Constant(strain / n_steps), Lanes::Zero(), Lanes::Zero()}, 1.0}, stress, state);
  CHECK(state[6](0) == Approx(0.012).epsilon(1e-12));
  CHECK(stress[0](0) == Approx(320e6).epsilon(1e-12));
  CHECK(1.5 * state[0](0) == Approx((1.0 - beta) * 120e6).margin(1e-3));
}

TEST_CASE("the yield condition of a shell on a curve holds to round-off", "[core][materials][shells]") {
  const double size = GENERATE(1e-5, 1.0, 10.0);
  const PlasticLaw<MultilinearHardening> law = law_of(1.0);
  PlaneLanes s;
  for (Lanes& component : s) component.setZero();
  std::array<Lanes, 7> state;
  law.start(state);
  const auto move = [&](double factor) {
    const double strain[] = {4e-3, -1e-3, 2e-3, 1e-3, 0.5e-3};
    PlaneStep step{{}, 1.0};
    for (std::size_t i = 0; i < 5; ++i) step.strain[i].setConstant(factor * strain[i]);
    law.update_plane(step, s, state);
  };
  move(1.0);
  move(size);
  const double von_mises = std::sqrt((s[0] * s[0] - s[0] * s[1] + s[1] * s[1])(0) +
                                     3.0 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4])(0));
  CHECK(von_mises == Approx(PiecewiseLinear(points).evaluate(state[6](0))).epsilon(4e-15));
}

}  // namespace multilinear_hardening_test
