// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/plastic_law.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/materials/elastic.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/power_hardening.hpp"
#include "core/materials/voce_hardening.hpp"
#include "support/catch.hpp"
#include "support/root_by_halving.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace plastic_law_test {

namespace {

constexpr double dt = 1e-3;
const ElasticModuli steel{160e9, 80e9};

/// The same tensor in every lane.
SymmetricLanes everywhere(const std::array<double, 6>& values) {
  SymmetricLanes tensor;
  for (std::size_t i = 0; i < 6; ++i) tensor[i].setConstant(values[i]);
  return tensor;
}

template <class Law>
struct Element {
  Law law;
  SymmetricLanes stress = SymmetricLanes::zero();
  std::vector<Lanes> state = std::vector<Lanes>(Law::n_state, Lanes::Zero());

  void strain(const SymmetricLanes& e, double step = dt) {
    law.update({e, {{{e[0], e[3], e[5]}, {e[3], e[1], e[4]}, {e[5], e[4], e[2]}}}, step}, stress, state);
  }
  double eqps() const { return state.back()(0); }
  double equivalent_stress() const {
    const SymmetricLanes s = deviator(stress);
    return std::sqrt(1.5 * contract(s, s)(0));
  }
};

/// Equivalent strain of a shear strain xy.
double equivalent(double xy) { return 2.0 / std::sqrt(3.0) * xy; }

PlasticLaw<LinearHardening> linear_law(double beta, double modulus = 2e9) {
  return {steel, {200e6, beta * modulus, (1.0 - beta) * modulus}};
}

}  // namespace

TEST_CASE("an elastic stress follows Hooke's law", "[core][materials]") {
  Element<ElasticLaw> element{{steel}};
  element.strain(everywhere({1e-3, 2e-3, -1e-3, 5e-4, -2e-4, 3e-4}));
  // lambda = 160e9 - 2/3 80e9, trace = 2e-3
  const double pressure = (160e9 - 160e9 / 3.0) * 2e-3;
  const double expected[] = {pressure + 160e6, pressure + 320e6, pressure - 160e6, 80e6, -32e6, 48e6};
  for (std::size_t i = 0; i < 6; ++i) CHECK(element.stress[i](3) == Approx(expected[i]));
}

TEST_CASE("below its yield stress a plastic law is elastic", "[core][materials]") {
  Element<PlasticLaw<LinearHardening>> plastic{linear_law(1.0)};
  Element<ElasticLaw> elastic{{steel}};
  const SymmetricLanes increment = everywhere({1e-4, -2e-4, 1e-4, 5e-4, 0, 0});
  plastic.strain(increment);
  elastic.strain(increment);
  for (std::size_t i = 0; i < 6; ++i) CHECK((plastic.stress[i] == elastic.stress[i]).all());
  CHECK(plastic.eqps() == 0.0);
}

TEST_CASE("proportional shear with linear hardening needs no small steps", "[core][materials]") {
  const double beta = GENERATE(0.0, 0.4, 1.0);
  const int n_steps = GENERATE(1, 7, 100);
  Element<PlasticLaw<LinearHardening>> element{linear_law(beta)};
  const double shear = 0.02;
  for (int i = 0; i < n_steps; ++i) element.strain(everywhere({0, 0, 0, shear / n_steps, 0, 0}));
  // 3 G (e - p) = y + H p
  const double eqps = (3.0 * 80e9 * equivalent(shear) - 200e6) / (3.0 * 80e9 + 2e9);
  CHECK(element.eqps() == Approx(eqps));
  CHECK(element.equivalent_stress() == Approx(200e6 + 2e9 * eqps));
}

TEST_CASE("kinematic hardening yields early on the way back, isotropic late", "[core][materials]") {
  const double beta = GENERATE(0.0, 1.0);
  Element<PlasticLaw<LinearHardening>> element{linear_law(beta)};
  element.strain(everywhere({0, 0, 0, 0.02, 0, 0}));
  const double before = element.eqps(), top = element.equivalent_stress();
  // The elastic range is 2 y when the surface moves, twice the stress reached when it grows.
  const double range = beta == 0.0 ? 2.0 * 200e6 : 2.0 * top;
  const double elastic_shear = range / std::sqrt(3.0) / (2.0 * 80e9);
  element.strain(everywhere({0, 0, 0, -0.999 * elastic_shear, 0, 0}));
  CHECK(element.eqps() == before);
  element.strain(everywhere({0, 0, 0, -0.01 * elastic_shear, 0, 0}));
  CHECK(element.eqps() > before);
}

TEST_CASE("power hardening lies on its curve", "[core][materials]") {
  const PowerHardening hardening{200e6, 500e6, GENERATE(0.3, 1.0, 1.7), GENERATE(0.0, 0.004)};
  Element<PlasticLaw<PowerHardening>> element{{steel, hardening}};
  const double shear = 0.03, e = equivalent(shear);
  element.strain(everywhere({0, 0, 0, shear, 0, 0}));
  const auto flow = [&](double p) {
    return 200e6 + 500e6 * std::pow(std::max(p - hardening.luders_strain, 0.0), hardening.exponent);
  };
  const double p = root_by_halving([&](double x) { return 3.0 * 80e9 * (e - x) - flow(x); }, 0.0, e);
  CHECK(element.eqps() == Approx(p).epsilon(1e-10));
  CHECK(element.equivalent_stress() == Approx(flow(p)).epsilon(1e-10));
}

TEST_CASE("Voce hardening lies on its curve", "[core][materials]") {
  Element<PlasticLaw<VoceHardening>> element{{steel, {200e6, 150e6, 20.0}}};
  const double shear = GENERATE(0.002, 0.03, 0.5), e = equivalent(shear);
  element.strain(everywhere({0, 0, 0, shear, 0, 0}));
  const auto flow = [](double p) { return 200e6 + 150e6 * (1.0 - std::exp(-20.0 * p)); };
  const double p = root_by_halving([&](double x) { return 3.0 * 80e9 * (e - x) - flow(x); }, 0.0, e);
  CHECK(element.eqps() == Approx(p).epsilon(1e-9));
  CHECK(element.equivalent_stress() == Approx(flow(p)).epsilon(1e-9));
}

TEST_CASE("a Johnson-Cook flow stress grows with the logarithm of the rate", "[core][materials]") {
  const JohnsonCookHardening hardening{{200e6, 500e6, 0.3}, 0.015, 1.0};
  const double step = GENERATE(1e-6, 1e-3, 1e2);  // the last is slower than the reference
  Element<PlasticLaw<JohnsonCookHardening>> element{{steel, hardening}};
  const double shear = 0.03, e = equivalent(shear);
  element.strain(everywhere({0, 0, 0, shear, 0, 0}), step);
  const auto flow = [&](double p) {
    return (200e6 + 500e6 * std::pow(p, 0.3)) * (1.0 + 0.015 * std::log(std::max(p / step, 1.0)));
  };
  const double p = root_by_halving([&](double x) { return 3.0 * 80e9 * (e - x) - flow(x); }, 0.0, e);
  CHECK(element.eqps() == Approx(p).epsilon(1e-10));
}

TEMPLATE_TEST_CASE("plastic work is never negative, and the stress never leaves the surface",
                   "[core][materials]", LinearHardening, PowerHardening, JohnsonCookHardening,
                   MultilinearHardening, VoceHardening) {
  TestType hardening;
  if constexpr (std::is_same_v<TestType, LinearHardening>) hardening = {200e6, 1e9, 1e9};
  if constexpr (std::is_same_v<TestType, PowerHardening>) hardening = {200e6, 500e6, 0.3, 0.001};
  if constexpr (std::is_same_v<TestType, JohnsonCookHardening>) hardening = {{200e6, 500e6, 0.3}, 0.015, 1.0};
  if constexpr (std::is_same_v<TestType, VoceHardening>) hardening = {200e6, 150e6, 20.0};
  if constexpr (std::is_same_v<TestType, MultilinearHardening>)
    hardening = {HardeningCurve(std::vector<FunctionPoint>{{0.0, 200e6}, {0.02, 250e6}, {0.1, 300e6}}), 0.5};
  Element<PlasticLaw<TestType>> element{{steel, hardening}};
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 1e-3);
  for (int step = 0; step < 400; ++step) {
    SymmetricLanes increment;
    for (Lanes& component : increment.components) {
      for (int lane = 0; lane < n_lanes; ++lane) component(lane) = normal(random);
    }
    const Lanes before = element.state.back();
    element.strain(increment);
    const Lanes grown = element.state.back() - before;
    CHECK((grown >= 0.0).all());
    SymmetricLanes relative = deviator(element.stress);
    if (TestType::has_back_stress) {
      for (std::size_t i = 0; i < 6; ++i) relative[i] -= element.state[i];
    }
    const Lanes equivalent_stress = (1.5 * contract(relative, relative)).sqrt();
    const Lanes limit = hardening.at(before, grown, dt).value;
    CHECK((equivalent_stress <= limit * (1.0 + 1e-9)).all());
  }
}

TEST_CASE("what a lane does is its own affair", "[core][materials]") {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, 2e-3);
  const PlasticLaw<PowerHardening> law{steel, {200e6, 500e6, 0.3, 0.0}};
  SymmetricLanes increment;
  for (Lanes& component : increment.components) {
    for (int lane = 0; lane < n_lanes; ++lane) component(lane) = normal(random);
  }
  Element<PlasticLaw<PowerHardening>> together{law};
  together.strain(increment);
  for (int lane = 0; lane < n_lanes; ++lane) {
    Element<PlasticLaw<PowerHardening>> alone{law};
    SymmetricLanes only = SymmetricLanes::zero();
    for (std::size_t i = 0; i < 6; ++i) only[i](lane) = increment[i](lane);
    alone.strain(only);
    for (std::size_t i = 0; i < 6; ++i) CHECK(alone.stress[i](lane) == together.stress[i](lane));
  }
}

TEST_CASE("any two elastic constants give the same moduli", "[core][materials]") {
  // K = 160e9, G = 80e9: E = 9 K G / (3 K + G), nu = (3 K - 2 G) / (2 (3 K + G)), lambda = K - 2/3 G
  const double e = 9.0 * 160e9 * 80e9 / 560e9, nu = 320e9 / 1120e9, lambda = 160e9 - 160e9 / 3.0;
  const ElasticConstants all{e, nu, 80e9, 160e9, lambda};
  for (int first = 0; first < 5; ++first) {
    for (int second = first + 1; second < 5; ++second) {
      ElasticConstants two;
      const auto take = [&](int i, auto member) {
        if (i == first || i == second) two.*member = all.*member;
      };
      take(0, &ElasticConstants::youngs_modulus);
      take(1, &ElasticConstants::poissons_ratio);
      take(2, &ElasticConstants::shear_modulus);
      take(3, &ElasticConstants::bulk_modulus);
      take(4, &ElasticConstants::lambda);
      const ElasticModuli moduli = make_elastic_moduli(two);
      CAPTURE(first, second);
      CHECK(moduli.bulk == Approx(160e9));
      CHECK(moduli.shear == Approx(80e9));
    }
  }
}

TEST_CASE("elastic constants that give no stable material are refused", "[core][materials]") {
  ElasticConstants constants;
  constants.youngs_modulus = 9e9;
  constants.bulk_modulus = 1e9;
  CHECK_THROWS_WITH(make_elastic_moduli(constants),
                    Catch::Contains("both must be positive") && Catch::Contains("shear modulus of inf"));
}

}  // namespace plastic_law_test
