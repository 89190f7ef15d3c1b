// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/johnson_cook.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr ElasticModuli steel{160e9, 80e9};

/// Without hardening; breaks at 0.1 + 0.9 exp(-1.5 triaxiality) in slow flow.
FailingJohnsonCookLaw law_of(double d4 = 0.0) {
  return {{steel, {{200e6, 0.0, 1.0}, 0.0, 2.0}}, {0.1, 0.9, -1.5, d4, 2.0}};
}

/// Strains a solid point in one step; the damage.
double damage_of(const FailingJohnsonCookLaw& law, const std::array<double, 6>& strain, double dt) {
  StrainStep step{SymmetricLanes::zero(), {}, dt};
  for (std::size_t i = 0; i < 6; ++i) step.strain[i].setConstant(strain[i]);
  SymmetricLanes stress = SymmetricLanes::zero();
  std::array<Lanes, 2> state;
  law.start(state);
  law.update(step, stress, state);
  return state[1](0);
}

constexpr double slow = 1e6;

}  // namespace

TEST_CASE("damage in shear grows by the plastic strain over d1 + d2", "[core][materials]") {
  // An angle of 0.02: 80e9 x 0.02 elastic, 200e6 / sqrt(3) stays; the rest flows.
  const double plastic = (0.02 - 200e6 / std::sqrt(3.0) / 80e9) / std::sqrt(3.0);
  CHECK(damage_of(law_of(), {0.0, 0.0, 0.0, 0.01, 0.0, 0.0}, slow) == Approx(plastic / 1.0));
}

TEST_CASE("damage grows faster under tension and slower under pressure", "[core][materials]") {
  const double shear = damage_of(law_of(), {0.0, 0.0, 0.0, 0.01, 0.0, 0.0}, slow);
  for (const double volume : {1e-3, -1e-3}) {
    const double triaxiality = 160e9 * 3.0 * volume / 200e6;
    const double limit = 0.1 + 0.9 * std::exp(-1.5 * triaxiality);
    CHECK(damage_of(law_of(), {volume, volume, volume, 0.01, 0.0, 0.0}, slow) == Approx(shear / limit));
  }
}

TEST_CASE("fast flow breaks later by the logarithm of its rate", "[core][materials]") {
  const std::array<double, 6> strain{0.0, 0.0, 0.0, 0.01, 0.0, 0.0};
  const double shear = damage_of(law_of(), strain, slow), dt = 1e-4;
  const double rate = shear / dt;  // the failure strain of slow shear is 1
  CHECK(damage_of(law_of(0.2), strain, dt) == Approx(shear / (1.0 + 0.2 * std::log(rate / 2.0))));
  CHECK(damage_of(law_of(0.2), strain, slow) == Approx(shear));
}

TEST_CASE("a bar in uniaxial stress breaks at the strain of triaxiality 1/3, as shell, fibre or solid",
          "[core][materials][shells][lines]") {
  const double limit = 0.1 + 0.9 * std::exp(-0.5);
  const FailingJohnsonCookLaw law = law_of();
  std::array<Lanes, 2> fibre, shell;
  law.start(fibre);
  law.start(shell);
  FibreLanes pull;
  PlaneLanes plane;
  for (Lanes& component : pull) component.setZero();
  for (Lanes& component : plane) component.setZero();
  FibreStep step{{Lanes::Constant(1e-3), Lanes::Zero(), Lanes::Zero()}, slow};
  const double nu = (3.0 * 160.0 - 2.0 * 80.0) / (6.0 * 160.0 + 2.0 * 80.0);
  for (int i = 0; i < 20; ++i) {
    law.update_fibre(step, pull, fibre);
    // Elastic while i is 0; then the flow keeps its volume.
    PlaneStep of_shell{
        {Lanes::Constant(1e-3), Lanes::Constant(-0.5e-3), Lanes::Zero(), Lanes::Zero(), Lanes::Zero()}, slow};
    if (i == 0) of_shell.strain[1].setConstant(-nu * 1e-3);
    law.update_plane(of_shell, plane, shell);
  }
  const double plastic = 0.02 - 200e6 / steel.youngs();
  CHECK(fibre[0](0) == Approx(plastic));
  CHECK(fibre[1](0) == Approx(plastic / limit));
  CHECK(shell[1](0) == Approx(plastic / limit).epsilon(0.02));  // its stress across settles in a few steps
}

TEST_CASE("an elastic step and one of no time do no damage", "[core][materials]") {
  CHECK(damage_of(law_of(), {1e-4, 0.0, 0.0, 0.0, 0.0, 0.0}, slow) == 0.0);
  CHECK(damage_of(law_of(), {0.0, 0.0, 0.0, 0.01, 0.0, 0.0}, 0.0) == 0.0);
}
