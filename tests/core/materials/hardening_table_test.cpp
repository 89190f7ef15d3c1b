// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/hardening_table.hpp"

#include <algorithm>
#include <set>

#include "core/materials/linear_hardening.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/power_hardening.hpp"
#include "core/materials/rate_hardening.hpp"
#include "core/materials/voce_hardening.hpp"
#include "support/catch.hpp"
#include "support/steel_model.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("every hardening makes its law by J2 plasticity and as models of its own",
          "[core][materials][conformance]") {
  std::int64_t position = 0;
  for (const HardeningRow& row : hardening_rows()) {
    INFO(row.word);
    MaterialModel model =
        steel_model("j2_plasticity", {{"yield stress", 200e6}, {"hardening model", position++}});
    const MaterialRow& j2 = *find_material_row("j2_plasticity");
    for (const std::string& phrase : j2.missing_besides(model.values)) {
      const auto parameter = std::ranges::find(row.parameters, phrase, &Parameter::phrase);
      REQUIRE(parameter != row.parameters.end());
      model.values.set(phrase, example_of(*parameter));
    }
    Diagnostics diagnostics;
    const auto law = made_law(model, diagnostics);
    REQUIRE(law);
    CHECK(&law->kind() == row.law);
    for (const std::string& name : row.models) CHECK(find_material_row(name)->make == row.make);
  }
}

TEST_CASE("J2 plasticity becomes the law of the hardening that it names", "[core][materials]") {
  constexpr std::int64_t linear = 0, power_law = 1, voce = 2, user_defined = 3, decoupled = 4;
  MaterialModel model = steel_model(
      "j2_plasticity",
      {{"yield stress", 200e6}, {"hardening model", linear}, {"hardening modulus", 1e9}, {"beta", 0.25}});
  CHECK(law_of<PlasticLaw<LinearHardening>>(model).hardening.kinematic_modulus == 0.75e9);
  set_values(model, {{"hardening model", user_defined}, {"hardening function", DeckName{"f", {}}}});
  CHECK(law_of<PlasticLaw<MultilinearHardening>>(model).hardening.beta == 0.25);
  set_values(model, {{"hardening model", decoupled},
                     {"isotropic hardening model", voce},
                     {"exponential coefficient", 12.0}});
  CHECK(model_error(model) ==
        "model 'j2_plasticity': beta other than 1 goes with linear and user_defined hardening only");
  model.values.set("beta", 1.0);
  const auto made = law_of<PlasticLaw<VoceHardening>>(model);
  CHECK(made.hardening.growth == 1e9);
  CHECK(made.hardening.coefficient == 12.0);
  set_values(model,
             {{"hardening model", power_law}, {"hardening constant", 5e8}, {"hardening exponent", 0.3}});
  CHECK(law_of<PlasticLaw<PowerHardening>>(model).hardening.constant == 5e8);
  set_values(model, {{"hardening model", voce}, {"hardening modulus", -1.0}});
  CHECK(model_error(model) ==
        "model 'j2_plasticity': the hardening modulus of voce must not be negative, found -1");
}

TEST_CASE("J2 plasticity has rate multipliers where the flow stress is decoupled", "[core][materials]") {
  constexpr std::int64_t linear = 0, decoupled = 4, johnson_cook_factor = 1, breakdown = 2;
  MaterialModel model = steel_model("j2_plasticity", {{"yield stress", 200e6},
                                                      {"hardening model", decoupled},
                                                      {"isotropic hardening model", linear},
                                                      {"hardening modulus", 1e9},
                                                      {"yield rate multiplier", breakdown},
                                                      {"yield rate coefficient", 50.0},
                                                      {"yield rate exponent", 4.0},
                                                      {"hardening rate multiplier", johnson_cook_factor}});
  CHECK(find_material_row("j2_plasticity")->missing_besides(model.values) ==
        std::vector<std::string>{"hardening rate constant", "hardening reference rate"});
  set_values(model, {{"hardening rate constant", 0.1}, {"hardening reference rate", 3.0}});
  const auto law = law_of<PlasticLaw<RateHardening>>(model);
  CHECK(law.hardening.yield_stress == 200e6);
  CHECK(law.hardening.of_yield.kind == RateFactor::Kind::power_law_breakdown);
  CHECK(law.hardening.of_yield.coefficient == 50.0);
  CHECK(law.hardening.of_growth.reference_rate == 3.0);
  MaterialModel idle = model;
  idle.values.set("yield rate multiplier", std::int64_t{0});
  Diagnostics told;
  CHECK(made_law(idle, told));
  CHECK(told.all().size() == 2);
  CHECK(told.all()[0].text == "'yield rate coefficient' has no effect");
  model.values.set("beta", 0.5);
  CHECK(model_error(model) ==
        "model 'j2_plasticity': rate multipliers go with isotropic hardening that does not fall: beta = 1");
  set_values(model, {{"beta", 1.0}, {"hardening model", linear}});
  CHECK(model_error(model) ==
        "model 'j2_plasticity': rate multipliers go with hardening model = decoupled_flow_stress");
}

TEST_CASE("every hardening has a word and a law of its own, help, and parameters with a dimension",
          "[core][materials][conformance]") {
  std::set<std::string> words, models;
  std::set<const LawKind*> laws;
  for (const HardeningRow& row : hardening_rows()) {
    INFO(row.word);
    CHECK(words.insert(row.word).second);
    CHECK(laws.insert(row.law).second);
    for (const std::string& model : row.models) CHECK(models.insert(model).second);
    CHECK_FALSE(row.help.empty());
    REQUIRE(row.make != nullptr);
    for (const Parameter& parameter : row.parameters) CHECK(parameter.phrase != "yield stress");
  }
}

TEST_CASE("a material of one hardening has the yield stress before the parameters of that hardening",
          "[core][materials]") {
  for (const HardeningRow& row : hardening_rows()) {
    const MaterialRow material = material_of(row);
    CHECK(material.names == row.models);
    REQUIRE(material.parameters.size() == row.parameters.size() + 1);
    CHECK(material.parameters[0].phrase == "yield stress");
    CHECK(material.parameters[0].is_required);
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
      CHECK(material.parameters[i + 1].phrase == row.parameters[i].phrase);
    CHECK(material.laws == std::vector<const LawKind*>{row.law});
    CHECK(material.make == row.make);
  }
}

TEST_CASE("J2 plasticity has the parameters of all hardenings, each once, and requires none of them at once",
          "[core][materials]") {
  const MaterialRow j2 = j2_material();
  const auto find = [&](const std::string& phrase) {
    return std::ranges::find(j2.parameters, phrase, &Parameter::phrase);
  };
  for (const HardeningRow& row : hardening_rows()) {
    for (const Parameter& parameter : row.parameters) {
      INFO(parameter.phrase);
      CHECK(std::ranges::count(j2.parameters, parameter.phrase, &Parameter::phrase) == 1);
      const auto found = find(parameter.phrase);
      REQUIRE(found != j2.parameters.end());
      CHECK_FALSE(found->is_required);
      CHECK_THAT(found->help, Catch::Matchers::Contains("f " + row.word + ": " + parameter.help));
    }
  }
  CHECK(find("yield stress")->is_required);
  CHECK(find("hardening model")->is_required);
  CHECK_FALSE(find("isotropic hardening model")->is_required);
  CHECK(j2.laws.size() == hardening_rows().size() + 1);  // and that of rates
}

TEST_CASE("what J2 plasticity lacks is told by the hardening that is chosen", "[core][materials]") {
  constexpr std::int64_t linear = 0, power_law = 1, decoupled = 4;
  using Phrases = std::vector<std::string>;
  const auto missing = [](std::initializer_list<std::pair<const char*, ParameterValue>> given) {
    return j2_material().missing_besides(steel_model("j2_plasticity", given).values);
  };
  CHECK(missing({{"yield stress", 200e6}}).empty());  // that no model is named is an error of its own
  CHECK(missing({{"hardening model", linear}}) == Phrases{"hardening modulus"});
  CHECK(missing({{"hardening model", power_law}, {"hardening exponent", 0.3}}) ==
        Phrases{"hardening constant"});
  CHECK(missing({{"hardening model", decoupled}}) == Phrases{"isotropic hardening model"});
  CHECK(missing({{"hardening model", decoupled}, {"isotropic hardening model", linear}}) ==
        Phrases{"hardening modulus"});
  // Named without need it does not count.
  CHECK(missing({{"hardening model", linear}, {"isotropic hardening model", power_law}}) ==
        Phrases{"hardening modulus"});
}
