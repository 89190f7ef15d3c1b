// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/material_table.hpp"

#include <algorithm>
#include <set>

#include "core/materials/elastic.hpp"
#include "core/materials/hardening_table.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/rate_hardening.hpp"
#include "core/materials/tearing.hpp"
#include "core/materials/voce_hardening.hpp"
#include "support/catch.hpp"
#include "support/steel_model.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace material_table_test {

namespace {

MaterialModel johnson_cook() {
  return steel_model("johnson_cook", {{"yield stress", 200e6},
                                      {"hardening constant", 5e8},
                                      {"hardening exponent", 0.3},
                                      {"rate constant", 0.015},
                                      {"reference rate", 2.0}});
}

/// A model of a row with two elastic constants and all that is required.
MaterialModel whole_model(const MaterialRow& row) {
  MaterialModel model = steel_model(row.names.front());
  if (row.elastic == ElasticNeed::one_or_two) model.values.set("shear modulus", {});
  for (const Parameter& parameter : row.parameters) {
    if (parameter.is_required) model.values.set(parameter.phrase, example_of(parameter));
  }
  if (row.missing_besides == nullptr) return model;
  for (const std::string& phrase : row.missing_besides(model.values)) {
    const auto parameter = std::ranges::find(row.parameters, phrase, &Parameter::phrase);
    REQUIRE(parameter != row.parameters.end());
    model.values.set(phrase, example_of(*parameter));
  }
  return model;
}

/// Strains that stay elastic keep plane stress and fibre stress on the moduli: the solid law with no stress
/// across. A law with directions has its own test.
void check_twins(const MaterialLaw& law) {
  constexpr double strain = 1e-6;
  const ElasticModuli& moduli = law.moduli();
  std::vector<Lanes> state(law.kind().n_state);
  if (law.kind().update_plane != nullptr && law.kind().n_vectors == 0) {
    PlaneStep step{{}, 1.0};
    for (Lanes& component : step.strain) component.setZero();
    step.strain[0].setConstant(strain);
    PlaneLanes stress = step.strain;
    for (Lanes& component : stress) component.setZero();
    law.start(state);
    law.update_plane(step, stress, state);
    CHECK(stress[0](0) == Approx(PlaneModuli(moduli).direct * strain).epsilon(1e-4));
  }
  if (law.kind().update_fibre != nullptr) {
    FibreStep step{{}, 1.0};
    for (Lanes& component : step.strain) component.setZero();
    step.strain[0].setConstant(strain);
    FibreLanes stress = step.strain;
    for (Lanes& component : stress) component.setZero();
    law.start(state);
    law.update_fibre(step, stress, state);
    CHECK(stress[0](0) == Approx(moduli.youngs() * strain).epsilon(1e-4));
  }
}

}  // namespace

TEST_CASE("every material has a name of its own and parameters with help and dimension",
          "[core][materials][conformance]") {
  std::set<std::string> names;
  for (const MaterialRow& row : material_rows()) {
    REQUIRE_FALSE(row.names.empty());
    INFO(row.names.front());
    CHECK_FALSE(row.help.empty());
    for (const std::string& name : row.names) {
      CHECK(name == fold(name));
      CHECK(names.insert(name).second);
      CHECK(find_material_row(name) == &row);
    }
    std::set<std::string> phrases;
    for (const Parameter& parameter : row.parameters) {
      CHECK_FALSE(parameter.help.empty());
      CHECK(phrases.insert(parameter.phrase).second);
    }
    CHECK((row.make == nullptr) == row.laws.empty());
  }
}

TEST_CASE("every material makes one of its laws of what it requires, and says what is missing",
          "[core][materials][conformance]") {
  for (const MaterialRow& row : material_rows()) {
    INFO(row.names.front());
    if (row.make == nullptr) continue;
    const MaterialModel model = whole_model(row);
    CHECK(missing_parameters(row.parameters, model.values).empty());
    Diagnostics diagnostics;
    const auto law = made_law(model, diagnostics);
    CHECK_FALSE(diagnostics.has_errors());
    REQUIRE(law);
    CHECK(std::ranges::find(row.laws, &law->kind()) != row.laws.end());
    check_twins(*law);
    for (const Parameter& parameter : row.parameters) {
      if (!parameter.is_required) continue;
      MaterialModel lacking = model;
      lacking.values.set(parameter.phrase, {});
      CHECK(missing_parameters(row.parameters, lacking.values) == std::vector{parameter.phrase});
    }
  }
}

TEST_CASE("every law's variables lie within its state, and its failure is one of them",
          "[core][materials][conformance]") {
  for (const LawKind* law : material_laws()) {
    CHECK(6 * law->n_tensors + 3 * law->n_vectors <= law->n_state);
    bool has_failure = law->failure.empty();
    for (const StateVariable& variable : law->variables) {
      CHECK(variable.first + variable.n_components <= law->n_state);
      has_failure = has_failure || variable.name == law->failure;
    }
    CHECK(has_failure);
    CHECK(law->start != nullptr);
    CHECK(law->update != nullptr);
    CHECK((law->plane_stiffening == nullptr || law->update_plane != nullptr));
    CHECK((law->fibre_stiffening == nullptr || law->update_fibre != nullptr));
  }
}

TEST_CASE("every model that can be integrated becomes its law", "[core][materials]") {
  law_of<ElasticLaw>(steel_model("elastic"));
  Diagnostics said;
  const auto of_small_strain = made_law(steel_model("linear_elastic"), said);
  REQUIRE(of_small_strain);
  CHECK(of_small_strain->get_if<ElasticLaw>() != nullptr);
  CHECK(said.all().at(0).id == "material-linear");
  law_of<NeoHookeanLaw>(steel_model("neo_hookean"));
  const auto linear = law_of<PlasticLaw<LinearHardening>>(
      steel_model("elastic_plastic", {{"yield stress", 200e6}, {"hardening modulus", 1e9}, {"beta", 0.25}}));
  CHECK(linear.hardening.yield_stress == 200e6);
  CHECK(linear.hardening.isotropic_modulus == 0.25e9);
  CHECK(linear.hardening.kinematic_modulus == 0.75e9);
  const auto power =
      law_of<PlasticLaw<PowerHardening>>(steel_model("ep_power_hard", {{"yield stress", 200e6},
                                                                       {"hardening constant", 5e8},
                                                                       {"hardening exponent", 0.3},
                                                                       {"luders strain", 0.01}}));
  CHECK(power.hardening.constant == 5e8);
  CHECK(power.hardening.exponent == 0.3);
  CHECK(power.hardening.luders_strain == 0.01);
  const auto cook = law_of<PlasticLaw<JohnsonCookHardening>>(johnson_cook());
  CHECK(cook.hardening.power.constant == 5e8);
  CHECK(cook.hardening.rate_constant == 0.015);
  CHECK(cook.hardening.reference_rate == 2.0);
}

TEST_CASE("Johnson-Cook with failure constants fails by its damage", "[core][materials]") {
  MaterialModel model = johnson_cook();
  set_values(model, {{"d1", 0.1}, {"d3", -2.0}});
  const auto law = law_of<FailingJohnsonCookLaw>(model);
  CHECK(law.hardening.rate_constant == 0.015);
  CHECK(law.failure_strain.d1 == 0.1);
  CHECK(law.failure_strain.d2 == 0.0);
  CHECK(law.failure_strain.d3 == -2.0);
  CHECK(law.failure_strain.reference_rate == 2.0);
  CHECK(MaterialLaw(law).kind().failure == "damage");
  CHECK(MaterialLaw(ElasticLaw{}).kind().failure == "");
}

TEST_CASE("hardening along a curve becomes its law, with failure or without", "[core][materials]") {
  const std::initializer_list<std::pair<const char*, ParameterValue>> curve{
      {"yield stress", 200e6}, {"beta", 0.25}, {"hardening function", DeckName{"f", {}}}};
  MaterialModel model = steel_model("multilinear_ep", curve);
  const auto plastic = law_of<PlasticLaw<MultilinearHardening>>(model);
  CHECK(plastic.hardening.beta == 0.25);
  REQUIRE(plastic.hardening.curve.points().size() == 2);
  CHECK(plastic.hardening.curve.points()[0].slope == Approx(1e9));
  MaterialModel torn = steel_model("ml_ep_fail", curve);
  set_values(torn, {{"critical tearing parameter", 0.3}, {"critical crack opening strain", 0.05}});
  const auto tearing = law_of<TearingLaw>(torn);
  CHECK(tearing.hardening.beta == 0.25);
  CHECK(tearing.critical_tearing == 0.3);
  CHECK(tearing.critical_opening == 0.05);
  model.values.set("beta", 1.5);
  CHECK(model_error(model) == "model 'multilinear_ep': beta must be from 0 to 1, found 1.5");
  torn.values.set("yield stress", 250e6);
  CHECK_THAT(model_error(torn), Catch::StartsWith("the hardening function 'f' begins at"));
}

TEST_CASE("a Mooney-Rivlin model takes the bulk modulus from one constant or from two that fit",
          "[core][materials]") {
  MaterialModel model = material_model("mooney_rivlin", {{"c10", 30e9}, {"c01", 10e9}});
  CHECK(model_error(model) == "model 'mooney_rivlin': nothing gives the bulk modulus; add BULK MODULUS");
  model.values.set("bulk modulus", 160e9);
  CHECK(law_of<MooneyRivlinLaw>(model).c10() == Approx(30e9));
  model.values.set("shear modulus", 80.1e9);
  CHECK(law_of<MooneyRivlinLaw>(model).c01 == 10e9);
  model.values.set("shear modulus", 90e9);
  CHECK(model_error(model) ==
        "model 'mooney_rivlin': the elastic constants give a shear modulus of 90000000000, C10 and C01 one "
        "of 80000000000");
  MaterialModel by_ratio =
      material_model("mooney_rivlin", {{"c10", 30e9}, {"c01", 10e9}, {"poissons ratio", 0.25}});
  Diagnostics diagnostics;
  CHECK(made_law(by_ratio, diagnostics)->moduli().bulk == Approx(80e9 * 2.5 / 1.5));
  by_ratio.values.set("c10", -10e9);
  CHECK(model_error(by_ratio) == "model 'mooney_rivlin': the sum of C10 and C01 must be positive");
}

TEST_CASE("models without a law are refused by name, and unstable constants by theirs", "[core][materials]") {
  const std::string text = ": the model is not supported; there are elastic, linear_elastic, ";
  CHECK_THAT(model_error({{"foam", {}}, {}}), Catch::StartsWith("model 'foam'" + text));
  MaterialModel failing = johnson_cook();
  set_values(failing, {{"d1", 0.1}, {"d2", -0.2}});
  CHECK(model_error(failing) ==
        "model 'johnson_cook': d1 + d2, the failure strain in shear, must be positive");
  CHECK(
      model_error(steel_model("elastic_plastic", {{"yield stress", 200e6}, {"hardening modulus", -250e9}})) ==
      "model 'elastic_plastic': the hardening modulus falls faster than three times the shear modulus");
  CHECK_THAT(model_error(material_model("elastic", {{"youngs modulus", 9e9}, {"bulk modulus", 1e9}})),
             Catch::StartsWith("model 'elastic': the elastic constants give"));
}

TEST_CASE("undeformed rubber has the unit tensor", "[core][materials]") {
  std::vector<Lanes> b(6);
  MaterialLaw(NeoHookeanLaw{}).start(b);
  for (std::size_t i = 0; i < 6; ++i) CHECK((b[i] == (i < 3 ? 1.0 : 0.0)).all());
}

TEST_CASE("an auxetic material's bounds hold without the help of its negative lambda", "[core][materials]") {
  const ElasticLaw law{{10.0, 30.0}};
  SymmetricLanes stress = SymmetricLanes::zero();
  const LaneModuli moduli = law.update({SymmetricLanes::zero(), {}, 1.0}, stress, {});
  CHECK((moduli.lambda() == 0.0).all());
  CHECK((moduli.shear == 30.0).all());
}

}  // namespace material_table_test
