// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/material_law.hpp"

#include "support/catch.hpp"
#include "support/function_definition.hpp"

using namespace contactsim;

namespace {

ElasticConstants steel() {
  ElasticConstants constants;
  constants.bulk_modulus = 160e9;
  constants.shear_modulus = 80e9;
  return constants;
}

JohnsonCookModel johnson_cook() {
  JohnsonCookModel model;
  model.elastic = steel();
  model.yield_stress = 200e6;
  model.hardening_constant = 5e8;
  model.hardening_exponent = 0.3;
  model.rate_constant = 0.015;
  model.reference_rate = 2.0;
  return model;
}

std::optional<MaterialLaw> make(const decltype(MaterialModel::parameters)& parameters,
                                Diagnostics& diagnostics) {
  const FunctionDefinition function =
      table_function(FunctionType::piecewise_linear, {{0.0, 200e6}, {0.1, 300e6}});
  return make_material_law({{"steel", {}}, parameters}, {&function, 1}, diagnostics);
}

/// The law of a model that must be right.
template <class Law>
Law law_of(const decltype(MaterialModel::parameters)& parameters) {
  Diagnostics diagnostics;
  const auto law = make(parameters, diagnostics);
  REQUIRE(law);
  CHECK(diagnostics.empty());
  CHECK(moduli_of(*law).bulk == 160e9);
  CHECK(moduli_of(*law).shear == 80e9);
  return std::get<Law>(*law);
}

std::string error_of(const decltype(MaterialModel::parameters)& parameters) {
  Diagnostics diagnostics;
  CHECK_FALSE(make(parameters, diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  return diagnostics.all()[0].text;
}

}  // namespace

TEST_CASE("every model that can be integrated becomes its law", "[core][materials]") {
  law_of<ElasticLaw>(ElasticModel{steel()});
  law_of<NeoHookeanLaw>(NeoHookeanModel{steel()});
  const auto linear = law_of<PlasticLaw<LinearHardening>>(ElasticPlasticModel{steel(), 200e6, 1e9, 0.25});
  CHECK(linear.hardening.yield_stress == 200e6);
  CHECK(linear.hardening.isotropic_modulus == 0.25e9);
  CHECK(linear.hardening.kinematic_modulus == 0.75e9);
  const auto power = law_of<PlasticLaw<PowerHardening>>(PowerHardeningModel{steel(), 200e6, 5e8, 0.3, 0.01});
  CHECK(power.hardening.constant == 5e8);
  CHECK(power.hardening.exponent == 0.3);
  CHECK(power.hardening.luders_strain == 0.01);
  const auto cook = law_of<PlasticLaw<JohnsonCookHardening>>(johnson_cook());
  CHECK(cook.hardening.power.constant == 5e8);
  CHECK(cook.hardening.rate_constant == 0.015);
  CHECK(cook.hardening.reference_rate == 2.0);
}

TEST_CASE("Johnson-Cook with failure constants fails by its damage", "[core][materials]") {
  JohnsonCookModel model = johnson_cook();
  model.d1 = 0.1;
  model.d3 = -2.0;
  const auto law = law_of<FailingJohnsonCookLaw>(model);
  CHECK(law.hardening.rate_constant == 0.015);
  CHECK(law.failure_strain.d1 == 0.1);
  CHECK(law.failure_strain.d2 == 0.0);
  CHECK(law.failure_strain.d3 == -2.0);
  CHECK(law.failure_strain.reference_rate == 2.0);
  CHECK(failure_of(law) == "damage");
  CHECK(failure_of(ElasticLaw{}) == "");
  CHECK(has_directions(OrthotropicLaw{}));
  CHECK_FALSE(has_directions(law));
}

TEST_CASE("hardening along a curve becomes its law, with failure or without", "[core][materials]") {
  MultilinearModel model{steel(), 200e6, 0.25, DeckName{"f", {}}};
  const auto plastic = law_of<PlasticLaw<MultilinearHardening>>(model);
  CHECK(plastic.hardening.beta == 0.25);
  REQUIRE(plastic.hardening.curve.points().size() == 2);
  CHECK(plastic.hardening.curve.points()[0].slope == Approx(1e9));
  const auto tearing = law_of<TearingLaw>(TearingModel{model, 0.3, 0.05});
  CHECK(tearing.hardening.beta == 0.25);
  CHECK(tearing.critical_tearing == 0.3);
  CHECK(tearing.critical_opening == 0.05);
  CHECK(failure_of(tearing) == "damage");
  CHECK(can_be_plane(tearing));
  CHECK(can_be_fibre(tearing));
  model.beta = 1.5;
  CHECK(error_of(model) == "model 'steel': beta must be from 0 to 1, found 1.5");
  model.beta = 1.0;
  model.yield_stress = 250e6;
  CHECK_THAT(error_of(TearingModel{model, 0.3, 0.05}),
             Catch::StartsWith("the hardening function 'f' begins at"));
}

TEST_CASE("J2 plasticity becomes the law of the hardening that it names", "[core][materials]") {
  J2Model model;
  model.elastic = steel();
  model.yield_stress = 200e6;
  model.hardening = HardeningModel::linear;
  model.hardening_modulus = 1e9;
  model.beta = 0.25;
  CHECK(law_of<PlasticLaw<LinearHardening>>(model).hardening.kinematic_modulus == 0.75e9);
  model.hardening = HardeningModel::user_defined;
  model.hardening_function = DeckName{"f", {}};
  CHECK(law_of<PlasticLaw<MultilinearHardening>>(model).hardening.beta == 0.25);
  model.hardening = HardeningModel::decoupled_flow_stress;
  model.isotropic_hardening = HardeningModel::voce;
  model.exponential_coefficient = 12.0;
  CHECK(error_of(model) ==
        "model 'steel': beta other than 1 goes with linear and user_defined hardening only");
  model.beta = 1.0;
  const auto voce = law_of<PlasticLaw<VoceHardening>>(model);
  CHECK(voce.hardening.growth == 1e9);
  CHECK(voce.hardening.coefficient == 12.0);
  model.hardening = HardeningModel::power_law;
  model.hardening_constant = 5e8;
  model.hardening_exponent = 0.3;
  CHECK(law_of<PlasticLaw<PowerHardening>>(model).hardening.constant == 5e8);
  model.hardening = HardeningModel::voce;
  model.hardening_modulus = -1.0;
  CHECK(error_of(model) == "model 'steel': the hardening modulus of voce must not be negative, found -1");
}

TEST_CASE("a Mooney-Rivlin model takes the bulk modulus from one constant or from two that fit",
          "[core][materials]") {
  MooneyRivlinModel model{{}, 30e9, 10e9};
  CHECK(error_of(model) == "model 'steel': nothing gives the bulk modulus; add BULK MODULUS");
  model.elastic.bulk_modulus = 160e9;
  CHECK(law_of<MooneyRivlinLaw>(model).c10() == Approx(30e9));
  model.elastic.shear_modulus = 80.1e9;
  CHECK(law_of<MooneyRivlinLaw>(model).c01 == 10e9);
  model.elastic.shear_modulus = 90e9;
  CHECK(error_of(model) ==
        "model 'steel': the elastic constants give a shear modulus of 90000000000, C10 and C01 one of "
        "80000000000");
  MooneyRivlinModel by_ratio{{}, 30e9, 10e9};
  by_ratio.elastic.poissons_ratio = 0.25;
  Diagnostics diagnostics;
  CHECK(moduli_of(*make(by_ratio, diagnostics)).bulk == Approx(80e9 * 2.5 / 1.5));
  by_ratio.c10 = -10e9;
  CHECK(error_of(by_ratio) == "model 'steel': the sum of C10 and C01 must be positive");
}

TEST_CASE("models without a law are refused by name", "[core][materials]") {
  const std::string text =
      "model 'steel': the model is not supported; there are elastic, elastic_orthotropic, neo_hookean, "
      "mooney_rivlin, elastic_plastic, ep_power_hard, johnson_cook, multilinear_ep, ml_ep_fail, "
      "j2_plasticity";
  CHECK(error_of(OpaqueModel{}) == text);
  CHECK(error_of(LinearElasticModel{steel()}) == text);
  JohnsonCookModel failing = johnson_cook();
  failing.d1 = 0.1;
  failing.d2 = -0.2;
  CHECK(error_of(failing) == "model 'steel': d1 + d2, the failure strain in shear, must be positive");
  CHECK(error_of(ElasticPlasticModel{steel(), 200e6, -250e9}) ==
        "model 'steel': the hardening modulus falls faster than three times the shear modulus");
  ElasticConstants soft;
  soft.youngs_modulus = 9e9;
  soft.bulk_modulus = 1e9;
  CHECK_THAT(error_of(ElasticModel{soft}), Catch::StartsWith("model 'steel': the elastic constants give"));
}

TEST_CASE("a law says what it keeps, and starts with undeformed material", "[core][materials]") {
  CHECK(state_of(ElasticLaw{}).n_state == 0);
  const LawState neo = state_of(NeoHookeanLaw{});
  CHECK(neo.n_state == 6);
  CHECK(neo.n_tensors == 0);
  std::vector<Lanes> b(6);
  start_state(NeoHookeanLaw{}, b);
  for (std::size_t i = 0; i < 6; ++i) CHECK((b[i] == (i < 3 ? 1.0 : 0.0)).all());
  const LawState plastic = state_of(PlasticLaw<LinearHardening>{});
  CHECK(plastic.n_state == 7);
  CHECK(plastic.n_tensors == 1);
  CHECK(plastic.variables[0].name == "eqps");
  CHECK(plastic.variables[0].first == 6);
  CHECK(state_of(PlasticLaw<PowerHardening>{}).n_state == 1);
  // Every variable lies within the state.
  for (const MaterialLaw& law :
       {MaterialLaw(ElasticLaw{}), MaterialLaw(NeoHookeanLaw{}), MaterialLaw(PlasticLaw<LinearHardening>{}),
        MaterialLaw(PlasticLaw<JohnsonCookHardening>{}), MaterialLaw(MooneyRivlinLaw{}),
        MaterialLaw(FailingJohnsonCookLaw{}), MaterialLaw(PlasticLaw<MultilinearHardening>{}),
        MaterialLaw(TearingLaw{})}) {
    for (const StateVariable& variable : state_of(law).variables)
      CHECK(variable.first + variable.n_components <= state_of(law).n_state);
  }
}

TEST_CASE("an auxetic material's bounds hold without the help of its negative lambda", "[core][materials]") {
  const ElasticLaw law{{10.0, 30.0}};
  SymmetricLanes stress = SymmetricLanes::zero();
  const LaneModuli moduli = law.update({SymmetricLanes::zero(), {}, 1.0}, stress, {});
  CHECK((moduli.lambda() == 0.0).all());
  CHECK((moduli.shear == 30.0).all());
}
