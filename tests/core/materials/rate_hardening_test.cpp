// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/rate_hardening.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace rate_hardening_test {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};

RateFactor johnson_cook(double constant, double reference) {
  return {.kind = RateFactor::Kind::johnson_cook, .constant = constant, .reference_rate = reference};
}

RateFactor breakdown(double coefficient, double exponent) {
  return {.kind = RateFactor::Kind::power_law_breakdown, .coefficient = coefficient, .exponent = exponent};
}

/// Shears a point by an angle in one step; von Mises stress and plastic strain at the end.
std::pair<double, double> shear(const RateHardening& hardening, double angle, double dt) {
  const PlasticLaw<RateHardening> law{steel, hardening};
  StrainStep step{SymmetricLanes::zero(), {}, dt};
  step.strain[3].setConstant(0.5 * angle);
  SymmetricLanes stress = SymmetricLanes::zero();
  std::array<Lanes, 1> state;
  law.start(state);
  law.update(step, stress, state);
  return {std::sqrt(3.0) * stress[3](0), state[0](0)};
}

double value(const RateFactor& factor, double rate) { return factor.at(Lanes::Constant(rate)).factor(0); }

}  // namespace

TEST_CASE("rate factors are 1 at rest and grow as their laws say", "[core][materials]") {
  CHECK(value({}, 100.0) == 1.0);
  CHECK(value(johnson_cook(0.1, 2.0), 1.0) == 1.0);
  CHECK(value(johnson_cook(0.1, 2.0), 2.0 * std::exp(3.0)) == Approx(1.3));
  CHECK(value(breakdown(10.0, 4.0), 0.0) == 1.0);
  CHECK(value(breakdown(10.0, 4.0), 160.0) == Approx(1.0 + std::asinh(2.0)));
}

TEST_CASE("slopes of rate factors are those of their values", "[core][materials]") {
  const RateFactor factor = GENERATE(johnson_cook(0.1, 2.0), breakdown(10.0, 4.0), breakdown(10.0, 0.7));
  for (const double rate : {0.5, 3.0, 1e4}) {
    const double way = 1e-6 * rate;
    CHECK(factor.at(Lanes::Constant(rate)).slope(0) ==
          Approx((value(factor, rate + way) - value(factor, rate - way)) / (2.0 * way))
              .epsilon(1e-6)
              .margin(1e-12));
  }
}

TEST_CASE("yield stress and growth have factors of their own", "[core][materials]") {
  const LinearHardening linear{200e6, 1e9, 0.0};
  const RateFactor fast = GENERATE(johnson_cook(0.1, 2.0), breakdown(1e4, 3.0));
  for (const bool is_of_yield : {true, false}) {
    const RateHardening hardening{linear, 200e6, is_of_yield ? fast : RateFactor{},
                                  is_of_yield ? RateFactor{} : fast};
    const double dt = 1e-4;
    const auto [von_mises, eqps] = shear(hardening, 0.05, dt);
    const double factor = value(fast, eqps / dt), grown = 1e9 * eqps;
    CHECK(eqps > 0.02);
    CHECK(von_mises == Approx(is_of_yield ? 200e6 * factor + grown : 200e6 + grown * factor).epsilon(1e-9));
  }
}

TEST_CASE("slow flow is that of the hardening at rest, whichever it is", "[core][materials]") {
  const RateHardening::AtRest at_rest = GENERATE(RateHardening::AtRest(LinearHardening{200e6, 1e9, 0.0}),
                                                 RateHardening::AtRest(PowerHardening{200e6, 5e8, 0.5, 0.0}),
                                                 RateHardening::AtRest(VoceHardening{200e6, 1e8, 10.0}));
  const RateFactor slow = johnson_cook(0.3, 1e9);
  const auto [von_mises, eqps] = shear({at_rest, 200e6, slow, slow}, 0.03, 1.0);
  const double expected = std::visit(
      [&](const auto& h) { return h.at(Lanes::Zero(), Lanes::Constant(eqps), 1.0).value(0); }, at_rest);
  CHECK(eqps > 0.01);
  CHECK(von_mises == Approx(expected).epsilon(1e-10));
}

}  // namespace rate_hardening_test
