// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/materials/elastic.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/material_table.hpp"
#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/orthotropic.hpp"
#include "core/materials/power_hardening.hpp"
#include "core/materials/rate_hardening.hpp"
#include "core/materials/tearing.hpp"
#include "core/materials/voce_hardening.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"

/// Every law, and every row of the table of solid elements with them.
namespace contactsim::test {

inline constexpr ElasticModuli steel{160e9, 80e9};

/// Steel three times as stiff along x as along z.
inline OrthotropicLaw rolled() {
  return make_orthotropic_law({{}, 300e9, 200e9, 100e9, 0.3, 0.2, 0.4, 80e9, 60e9, 100e9});
}

inline std::vector<MaterialLaw> elastic_laws() {
  return {ElasticLaw{steel}, NeoHookeanLaw{steel}, MooneyRivlinLaw{steel, 15e9}, rolled()};
}

inline std::vector<MaterialLaw> plastic_laws() {
  const std::vector<FunctionPoint> points{{0.0, 200e6}, {0.002, 300e6}, {0.01, 350e6}, {0.1, 500e6}};
  RateFactor of_rate;
  of_rate.kind = RateFactor::Kind::johnson_cook;
  of_rate.constant = 0.015;
  const PlasticLaw<MultilinearHardening> multilinear{steel, {HardeningCurve(points), 0.4}};
  return {PlasticLaw<LinearHardening>{steel, {200e6, 1e9, 1e9}},
          PlasticLaw<PowerHardening>{steel, {200e6, 500e6, 0.3, 0.001}},
          PlasticLaw<JohnsonCookHardening>{steel, {{200e6, 500e6, 0.3}, 0.015, 1.0}},
          FailingJohnsonCookLaw{{steel, {{200e6, 500e6, 0.3}, 0.015, 1.0}}, {0.05, 0.3, -2.0, 0.01, 1.0}},
          multilinear,
          TearingLaw{multilinear, 1e-4, 0.02},
          PlasticLaw<VoceHardening>{steel, {200e6, 150e6, 20.0}},
          PlasticLaw<RateHardening>{steel, {LinearHardening{200e6, 1e9, 0.0}, 200e6, of_rate, {}}}};
}

inline std::vector<MaterialLaw> all_laws() {
  std::vector<MaterialLaw> laws = elastic_laws();
  for (const MaterialLaw& law : plastic_laws()) laws.push_back(law);
  REQUIRE(laws.size() == material_laws().size());
  return laws;
}

/// Calls check(row, law) for every row of the element table and each of some laws.
template <class Check>
void for_each_row(const std::vector<MaterialLaw>& laws, const Check& check) {
  for (const ElementFormulation* row : solid_elements()) {
    for (const MaterialLaw& law : laws) {
      INFO(name_of(*row) << ", moduli " << law.moduli().bulk << ", state " << law.kind().n_state);
      check(*row, law);
    }
  }
}

}  // namespace contactsim::test
