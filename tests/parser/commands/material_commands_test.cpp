// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/material_commands.hpp"

#include "core/materials/elastic_constants.hpp"
#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// A deck whose block b takes the model of the material m. The lines of the material begin at line 3.
ParsedDeck using_model(const std::string& model, const std::string& lines) {
  return parsed_sierra("begin material m\n" + lines +
                       "end\n"
                       "begin finite element model fem\n"
                       "  begin parameters for block b\n"
                       "    material m\n"
                       "    solid mechanics use model " +
                       model +
                       "\n"
                       "  end\n"
                       "end\n"
                       "begin presto procedure p\n"
                       "  begin presto region r\n"
                       "    use finite element model fem\n"
                       "  end\n"
                       "end\n");
}

/// The values of the first model.
const ParameterValues& values_of(const ParsedDeck& deck) {
  return deck.simulation.materials.at(0).models.at(0).values;
}

const std::string elastic = "youngs modulus = 200e9\npoissons ratio = 0.3\n";

}  // namespace

TEST_CASE("elastic models are bound with two constants of any kind", "[parser][material]") {
  for (const std::string name : {"elastic", "LINEAR_ELASTIC", "neo_hookean", "linear elastic"}) {
    INFO(name);
    const ParsedDeck deck = using_model(name == "linear elastic" ? "linear_elastic" : name,
                                        "density = 7800\nbegin parameters for model " + name +
                                            "\nbulk modulus = 2\nshear modulus = 1\nend\n");
    CHECK(deck.messages == "");
    const ElasticConstants constants = elastic_constants_of(values_of(deck));
    CHECK(constants.bulk_modulus == 2.0);
    CHECK(constants.shear_modulus == 1.0);
    CHECK_FALSE(constants.youngs_modulus);
  }
}

TEST_CASE("twice the shear modulus may be given", "[parser][material]") {
  const ParsedDeck deck = using_model(
      "elastic", "density = 1\nbegin parameters for model elastic\ntwo mu = 8\nlambda = 1\nend\n");
  CHECK(deck.messages == "");
  CHECK(values_of(deck).real("shear modulus") == 4.0);
}

TEST_CASE("the plastic models are bound", "[parser][material]") {
  const ParsedDeck linear =
      using_model("elastic_plastic", "density = 1\nbegin parameters for model elastic_plastic\n" + elastic +
                                         "yield stress = 250e6\nhardening modulus = 1e9\nbeta = 0.5\nend\n");
  CHECK(linear.messages == "");
  CHECK(values_of(linear).real("yield stress") == 250e6);
  CHECK(values_of(linear).real("hardening modulus") == 1e9);
  CHECK(values_of(linear).real("beta") == 0.5);

  for (const std::string name : {"ep_power_hard", "power_law_hardening"}) {
    const ParsedDeck power = using_model(
        name,
        "density = 1\nbegin parameters for model " + name + "\n" + elastic +
            "yield stress = 2\nhardening constant = 3\nhardening exponent = 0.4\nluders strain = 5\nend\n");
    CHECK(power.messages == "");
    CHECK(values_of(power).real("hardening exponent") == 0.4);
    CHECK(values_of(power).real("luders strain") == 5.0);
  }

  const ParsedDeck cook =
      using_model("johnson_cook", "density = 1\nbegin parameters for model johnson_cook\n" + elastic +
                                      "yield stress = 2\nhardening constant = 3\nhardening exponent = 0.4\n"
                                      "rate constant = 0.01\nedot_ref = 2\nd1 = 0.1\nd5 = 0\nend\n");
  CHECK(cook.messages == "");
  CHECK(values_of(cook).real("rate constant") == 0.01);
  CHECK(values_of(cook).real("reference rate") == 2.0);
  CHECK(values_of(cook).real("d1") == 0.1);
  CHECK_FALSE(values_of(cook).has("d2"));
}

TEST_CASE("hardening along a curve is bound with its function, with failure or without",
          "[parser][material]") {
  const auto with = [](const std::string& model, const std::string& lines) {
    return using_model(model, "density = 1\nbegin parameters for model " + model + "\n" + elastic + lines +
                                  "end\nend\nbegin function curve\ntype = piecewise linear\n"
                                  "begin values\n0 2\n1 3\nend\nend\nbegin material other\n");
  };
  const std::string hardening = "yield stress = 2\nbeta = 0.5\nhardening function = curve\n";
  const ParsedDeck curve = with("multilinear_ep", hardening);
  CHECK(curve.messages == "");
  CHECK(values_of(curve).real("yield stress") == 2.0);
  CHECK(values_of(curve).real("beta") == 0.5);
  CHECK(values_of(curve).name("hardening function").text == "curve");
  const ParsedDeck tearing = with(
      "ml_ep_fail", hardening + "critical tearing parameter = 0.3\ncritical crack opening strain = 0.05\n");
  CHECK(tearing.messages == "");
  CHECK(values_of(tearing).real("beta") == 0.5);
  CHECK(values_of(tearing).real("critical tearing parameter") == 0.3);
  CHECK(values_of(tearing).real("critical crack opening strain") == 0.05);
  CHECK(values_of(tearing).real("youngs modulus") == 200e9);
  CHECK_THAT(with("multilinear_ep", "yield stress = 2\nhardening function = curv\n").messages,
             Catch::Contains("unknown function 'curv'") && Catch::Contains("did you mean 'curve'?"));
  CHECK_THAT(with("ml_ep_fail", "beta = 1\n").messages,
             Catch::Contains("has no YIELD STRESS") && Catch::Contains("has no HARDENING FUNCTION") &&
                 Catch::Contains("has no CRITICAL TEARING PARAMETER") &&
                 Catch::Contains("has no CRITICAL CRACK OPENING STRAIN"));
  CHECK_THAT(with("multilinear_ep", hardening + "yield stress function = f\n").messages,
             Catch::Contains("has no effect on materials"));
}

TEST_CASE("J2 plasticity is bound with the hardening that it names", "[parser][material]") {
  const auto with = [](const std::string& lines) {
    return using_model("j2_plasticity", "density = 1\nbegin parameters for model j2_plasticity\n" + elastic +
                                            "yield stress = 2\n" + lines + "end\n");
  };
  const std::string voce = "hardening modulus = 3\nexponential coefficient = 4\n";
  const ParsedDeck plain = with("hardening model = voce\n" + voce);
  CHECK(plain.messages == "");
  CHECK(values_of(plain).word("hardening model") == "voce");
  CHECK(values_of(plain).real("exponential coefficient") == 4.0);
  const ParsedDeck decoupled = with(
      "hardening model = decoupled_flow_stress\nisotropic hardening model = voce\n"
      "yield rate multiplier = rate_independent\n" +
      voce);
  CHECK(decoupled.messages == "");
  CHECK(values_of(decoupled).word("isotropic hardening model") == "voce");
  CHECK_THAT(
      with("hardening model = voce\n").messages,
      Catch::Contains("needs 'hardening modulus'") && Catch::Contains("needs 'exponential coefficient'"));
  CHECK_THAT(with("").messages, Catch::Contains("has no HARDENING MODEL"));
  CHECK_THAT(with("hardening model = decoupled_flow_stress\n").messages,
             Catch::Contains("needs 'isotropic hardening model'"));
  CHECK_THAT(with("hardening model = power_law\n").messages, Catch::Contains("needs 'hardening exponent'"));
  CHECK_THAT(with("hardening model = user_defined\n").messages,
             Catch::Contains("needs 'hardening function'"));
  CHECK_THAT(
      with("hardening model = voce\nyield rate multiplier = power_law_breakdown\n" + voce).messages,
      Catch::Contains("needs 'yield rate coefficient'") && Catch::Contains("needs 'yield rate exponent'"));
}

TEST_CASE("Mooney-Rivlin is bound with one elastic constant or two", "[parser][material]") {
  const std::string begin = "density = 1\nbegin parameters for model mooney_rivlin\nc10 = 3\n";
  const ParsedDeck deck = using_model("mooney_rivlin", begin + "c01 = 2\nbulk modulus = 1000\nend\n");
  CHECK(deck.messages == "");
  CHECK(values_of(deck).real("c10") == 3.0);
  CHECK(values_of(deck).real("c01") == 2.0);
  CHECK(using_model("mooney_rivlin", begin + "c01 = 2\n" + elastic + "end\n").messages == "");
  CHECK_THAT(using_model("mooney_rivlin", begin + "end\n").messages,
             Catch::Contains("needs two elastic constants, found 0") && Catch::Contains("has no C01"));
}

TEST_CASE("an orthotropic model is bound with its coordinate system and turns", "[parser][material]") {
  const std::string moduli =
      "e11 = 1\ne22 = 2\ne33 = 3\nnu12 = 0.1\nnu13 = 0.2\nnu23 = 0.3\ng12 = 4\ng13 = 5\ng23 = 6\n";
  const std::string points =
      "define point o with coordinates 0 0 0\ndefine point z with coordinates 0 0 1\n"
      "define point x with coordinates 1 0 0\n"
      "define coordinate system c rectangular with point o point z point x\n";
  const auto with = [&](const std::string& more) {
    return using_model("elastic_orthotropic",
                       "density = 1\nbegin parameters for model elastic_orthotropic\n" + moduli + more +
                           "end\nend\n" + points + "begin material other\n");
  };
  const ParsedDeck deck =
      with(elastic + "coordinate system = c\ndirection for rotation = 3\nalpha = 30\nsecond alpha = 5\n");
  CHECK(deck.messages == "");
  const ParameterValues& values = values_of(deck);
  CHECK(values.real("e33") == 3.0);
  CHECK(values.real("nu23") == 0.3);
  CHECK(values.real("g13") == 5.0);
  CHECK(values.name("coordinate system").text == "c");
  CHECK(values.word("direction for rotation") == "3");
  CHECK(values.real("alpha") == 30.0);
  CHECK(values.word("second direction for rotation") == "1");
  CHECK(values.real("second alpha") == 5.0);
  CHECK(with("").messages == "");
  CHECK_THAT(with("coordinate system = d\n").messages, Catch::Contains("unknown coordinate system 'd'"));
  CHECK_THAT(with("bulk modulus = 1\n").messages, Catch::Contains("needs two elastic constants, found 1"));
}

TEST_CASE("the older spelling defines a material too", "[parser][material]") {
  const ParsedDeck deck = parsed_sierra("begin property specification for material m\n  density = 3\nend\n");
  CHECK(deck.messages == "");
  CHECK(deck.simulation.materials.at(0).density == 3.0);
}

TEST_CASE("an unknown model is passed over", "[parser][material]") {
  const ParsedDeck deck = using_model("foam_plasticity",
                                      "density = 1\nbegin parameters for model foam_plasticity\n"
                                      "  youngs modulus = 3e9\n"
                                      "  phi 0.2\n"
                                      "  prony shear 1 is 0.4\n"
                                      "  hardening function = f\n"
                                      "  table = 1, 2, 3\n"
                                      "end\n");
  CHECK(deck.messages == "");
  CHECK(values_of(deck).parameters().empty());
}

TEST_CASE("of several models in a material only the selected one matters", "[parser][material]") {
  const ParsedDeck deck =
      using_model("elastic", "density = 1\nbegin parameters for model elastic\n" + elastic +
                                 "end\nbegin parameters for model elastic_plastic\n"
                                 "  youngs modulus = 1\nend\n");
  CHECK(deck.messages == "");
  const MaterialDefinition& material = deck.simulation.materials.at(0);
  REQUIRE(material.models.size() == 2);
  CHECK(find_model(material, "ELASTIC_PLASTIC") == &material.models[1]);
  CHECK(find_model(material, "foam") == nullptr);
}

TEST_CASE("mistakes in a model that is not selected are warnings", "[parser][material]") {
  CHECK(using_model("elastic", "density = 1\nbegin parameters for model elastic\n" + elastic +
                                   "end\nbegin parameters for model elastic_plastic\nyeild stress = 1\nend\n")
            .messages ==
        "a.i:9:1: warning: unknown command 'yeild stress = 1' in 'parameters for model elastic_plastic', but "
        "nothing uses this definition; did you mean 'yield stress'? [deck-unused]\n");
}

TEST_CASE("what a used model lacks is reported", "[parser][material]") {
  CHECK(using_model("elastic", "density = 1\nbegin parameters for model elastic\nyoungs modulus = 1\nend\n")
            .messages ==
        "a.i:4:28: error: the model 'elastic' of the material 'm' needs two elastic constants, found 1; give "
        "two "
        "of youngs modulus, poissons ratio, shear modulus, bulk modulus, lambda\n");
  CHECK(using_model("elastic_plastic",
                    "density = 1\nbegin parameters for model elastic_plastic\n" + elastic + "end\n")
            .messages ==
        "a.i:4:28: error: the model 'elastic_plastic' has no YIELD STRESS; add YIELD STRESS = <real > 0>\n"
        "a.i:4:28: error: the model 'elastic_plastic' has no HARDENING MODULUS; add HARDENING MODULUS = "
        "<real>\n");
  CHECK(using_model("elastic", "begin parameters for model elastic\n" + elastic + "end\n").messages ==
        "a.i:2:16: error: the material 'm' has no density; add DENSITY = <mass per volume>\n");
}

TEST_CASE("Poisson's ratio keeps to its range", "[parser][material]") {
  CHECK(
      using_model("elastic",
                  "density = 1\nbegin parameters for model elastic\n  youngs modulus = 1\n  poissons ratio = "
                  "0.5\n  lambda = 2\nend\n")
          .messages ==
      "a.i:6:20: error: 'poissons ratio' must be greater than -1 and less than 0.5, found '0.5'\n");
}

TEST_CASE("what a material lacks behind a line that cannot be read is not reported", "[parser][material]") {
  CHECK(using_model(
            "elastic",
            "density = -1\nbegin parameters for model elastic\n  youngs modulus = 1\n  poissons ratio = "
            "-3\nend\n")
            .messages ==
        "a.i:3:11: error: 'density' must be greater than 0, found '-1'\n"
        "a.i:6:20: error: 'poissons ratio' must be greater than -1 and less than 0.5, found '-3'\n");
}

TEST_CASE("a model that the material does not have is reported", "[parser][material]") {
  CHECK(using_model("elastik", "density = 1\nbegin parameters for model elastic\n" + elastic + "end\n")
            .messages ==
        "a.i:12:31: error: unknown model 'elastik' of the material 'm'; did you mean 'elastic'?\n");
}

TEST_CASE("a model that is defined twice is reported", "[parser][material]") {
  const std::string model = "begin parameters for model elastic\n" + elastic + "end\n";
  CHECK(using_model("elastic", "density = 1\n" + model + model).messages ==
        "a.i:8:28: error: the model 'elastic' of the material 'm' is defined a second time; the first stands "
        "at "
        "a.i:4:28\n");
}

TEST_CASE("thermal lines of a material are ignored", "[parser][material]") {
  CHECK(using_model("elastic",
                    "density = 1\nthermal engineering strain function = f\nbegin parameters for model "
                    "elastic\n" +
                        elastic + "end\n")
            .messages ==
        "a.i:4:1: warning: 'thermal engineering strain function' has no effect here; temperature has no "
        "effect on "
        "materials [deck-ignored]\n");
}
