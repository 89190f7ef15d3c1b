// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/tearing.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace tearing_test {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
constexpr double yield = 200e6, never = 1e9;

/// Without hardening.
TearingLaw law_of(double critical_tearing, double critical_opening = 0.01) {
  const std::vector<FunctionPoint> flat{{0.0, yield}};
  return {{steel, {HardeningCurve(flat), 1.0}}, critical_tearing, critical_opening};
}

struct Point {
  TearingLaw law;
  std::array<Lanes, TearingLaw::n_state> state;
  SymmetricLanes stress = SymmetricLanes::zero();
  PlaneLanes plane;
  FibreLanes fibre;

  explicit Point(const TearingLaw& its_law) : law(its_law) {
    law.start(state);
    for (Lanes& component : plane) component.setZero();
    for (Lanes& component : fibre) component.setZero();
  }
  void strain(const std::array<double, 6>& strain, double dt = 1.0) {
    StrainStep step{SymmetricLanes::zero(), {}, dt};
    for (std::size_t i = 0; i < 6; ++i) step.strain[i].setConstant(strain[i]);
    law.update(step, stress, state);
  }
  void strain_plane(const std::array<double, 5>& strain) {
    PlaneStep step{{}, 1.0};
    for (std::size_t i = 0; i < 5; ++i) step.strain[i].setConstant(strain[i]);
    law.update_plane(step, plane, state);
  }
  void pull(double strain) {
    law.update_fibre({{Lanes::Constant(strain), Lanes::Zero(), Lanes::Zero()}, 1.0}, fibre, state);
  }

  double eqps() const { return state[12](3); }
  double tearing() const { return state[13](3); }
  double opening() const { return state[14](3); }
  double damage() const { return state[15](3); }
};

}  // namespace

TEST_CASE("in uniaxial tension the tearing parameter is the plastic strain, in compression nothing",
          "[core][materials][lines]") {
  Point pulled(law_of(never)), pushed(law_of(never));
  for (int i = 0; i < 10; ++i) {
    pulled.pull(2e-3);
    pushed.pull(-2e-3);
  }
  CHECK(pulled.eqps() == Approx(0.02 - yield / steel.youngs()));
  CHECK(pulled.tearing() == Approx(pulled.eqps()).epsilon(1e-12));
  CHECK(pushed.eqps() == Approx(pulled.eqps()));
  CHECK(pushed.tearing() < 1e-30);  // its largest principal stress is 0 up to round-off
}

TEST_CASE("shear under tension tears by its triaxiality, under pressure less", "[core][materials]") {
  for (const double volume : {0.0, 3e-4, -1e-4, -1e-3}) {
    Point point(law_of(never));
    point.strain({volume, volume, volume, 0.01, 0.0, 0.0});
    const double mean = 3.0 * 160e9 * volume, shear = yield / std::sqrt(3.0);
    const double rate = std::max(0.0, 2.0 * (mean + shear) / (3.0 * shear));
    CHECK(point.eqps() == Approx(2.0 / std::sqrt(3.0) * (0.01 - shear / 160e9)));
    CHECK(point.tearing() == Approx(std::pow(rate, 4.0) * point.eqps()).epsilon(1e-7));
  }
}

TEST_CASE("a shell that is pulled both ways tears sixteen times as fast as it flows",
          "[core][materials][shells]") {
  Point point(law_of(never));
  for (int i = 0; i < 10; ++i) point.strain_plane({1e-3, 1e-3, 0.0, 0.0, 0.0});
  CHECK(point.plane[0](0) == Approx(yield));
  CHECK(point.eqps() > 0.01);
  CHECK(point.tearing() == Approx(16.0 * point.eqps()).epsilon(1e-6));  // two principal stresses are equal
}

TEST_CASE("the stress falls in proportion to the opening of the crack, down to nothing",
          "[core][materials][lines]") {
  constexpr double at_failure = 0.004, critical = 0.01;
  Point point(law_of(at_failure, critical));
  point.pull(yield / steel.youngs() + 0.999 * at_failure);
  CHECK(point.damage() == 0.0);
  point.pull(0.001 * at_failure * (1.0 + 1e-9));
  CHECK(point.fibre[0](3) == Approx(yield));
  CHECK(point.opening() == 0.0);
  for (int i = 1; i <= 10; ++i) {
    point.pull(0.1 * critical);
    CHECK(point.opening() == Approx(0.1 * i * critical));
    CHECK(point.fibre[0](3) == Approx((1.0 - 0.1 * i) * yield).margin(1.0));
  }
  point.pull(0.1 * critical);
  CHECK(point.damage() == 1.0);
  CHECK(point.fibre[0](3) == 0.0);
  point.pull(-1e-3);
  CHECK(point.fibre[0](3) == 0.0);
}

TEST_CASE("a crack that closes heals nothing, and opens further only beyond where it has been",
          "[core][materials][lines]") {
  constexpr double critical = 0.01;
  Point point(law_of(1e-6, critical));
  point.pull(yield / steel.youngs() + 2e-6);
  point.pull(0.25 * critical);
  CHECK(point.damage() == Approx(0.25));
  const double stress = point.fibre[0](3);
  CHECK(stress == Approx(0.75 * yield));
  point.pull(-1e-4);  // elastic, with what is left of the stiffness
  CHECK(point.fibre[0](3) == Approx(stress - 0.75 * steel.youngs() * 1e-4));
  CHECK(point.damage() == Approx(0.25));
  point.pull(1e-4);
  CHECK(point.fibre[0](3) == Approx(stress));
  CHECK(point.damage() == Approx(0.25));
  point.pull(0.25 * critical);
  CHECK(point.damage() == Approx(0.5));
}

TEST_CASE("a crack stands across the largest principal stress when it began", "[core][materials]") {
  constexpr double critical = 0.1;
  Point point(law_of(1e-4, critical));
  point.strain({0.0, 0.0, 0.0, 0.01, 0.0, 0.0});  // shear: the normal is (1, 1, 0) / sqrt(2)
  CHECK(point.stress[3](0) == Approx(yield / std::sqrt(3.0)));
  const double normal[] = {0.5, 0.5, 0.0, 0.5, 0.0, 0.0};
  for (std::size_t i = 0; i < 6; ++i) CHECK(point.state[6 + i](3) == Approx(normal[i]).margin(1e-12));
  point.strain({0.01, -0.01, 0.0, 0.0, 0.0, 0.0});
  CHECK(point.opening() == Approx(0.0).margin(1e-16));
  CHECK(point.damage() < 1e-14);
  point.strain({0.0, 0.0, 0.0, 0.02, 0.0, 0.0});
  CHECK(point.opening() == Approx(0.02));
  CHECK(point.damage() == Approx(0.2));
  const SymmetricLanes s = deviator(point.stress);
  CHECK(std::sqrt(1.5 * contract(s, s)(3)) == Approx(0.8 * yield));
  point.strain({0.04, 0.04, 0.0, 0.0, 0.0, 0.0});  // 0.04 across the crack
  CHECK(point.damage() == Approx(0.6));
}

TEST_CASE("a shell tears as a fibre does", "[core][materials][shells][lines]") {
  Point fibre(law_of(0.002, 0.05)), shell(law_of(0.002, 0.05));
  for (int i = 0; i < 4000; ++i) {
    fibre.pull(1e-5);
    shell.strain_plane({1e-5, -0.5e-5, 0.0, 0.0, 0.0});  // flow keeps its volume
  }
  CHECK(fibre.damage() > 0.6);
  CHECK(shell.damage() == Approx(fibre.damage()).epsilon(0.02));  // its stress across settles in a few steps
  CHECK(shell.plane[0](0) == Approx((1.0 - shell.damage()) * yield).epsilon(1e-4));
  CHECK(fibre.fibre[0](0) == Approx((1.0 - fibre.damage()) * yield));
}

TEST_CASE("a step of no time tears nothing, and a lane tears alone", "[core][materials]") {
  Point point(law_of(1e-6, 0.1));
  point.strain({0.0, 0.0, 0.0, 0.01, 0.0, 0.0}, 0.0);
  CHECK(point.tearing() == 0.0);
  Point one(law_of(1e-6, 0.1));
  StrainStep step{SymmetricLanes::zero(), {}, 1.0};
  step.strain[3](5) = 0.01;
  for (int i = 0; i < 2; ++i) one.law.update(step, one.stress, one.state);
  for (int lane = 0; lane < n_lanes; ++lane) {
    CHECK(one.state[15](lane) == (lane == 5 ? Approx(0.1) : Approx(0.0).margin(0.0)));
    if (lane != 5) CHECK(one.stress[3](lane) == 0.0);
  }
}

}  // namespace tearing_test
