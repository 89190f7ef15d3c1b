// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/parameter_values.hpp"

#include <stdexcept>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> all{
      parameter::positive("yield stress", "").required(),
      parameter::real("beta", "").otherwise(1.0),
      parameter::word("shape", {"round", "flat"}, ""),
      parameter::word("colour", {"red", "blue"}, "", false),
      parameter::function("curve", ""),
  };
  return all;
}

}  // namespace

TEST_CASE("parameters have their defaults until they are given", "[core][parameter]") {
  ParameterValues values(parameters());
  CHECK(values.real("beta") == 1.0);
  CHECK(values.word("shape") == "round");
  CHECK_FALSE(values.has("colour"));
  CHECK(missing_parameters(parameters(), values) == std::vector<std::string>{"yield stress"});
  values.set("yield stress", 2.0);
  values.set("shape", std::int64_t{1});
  CHECK(values.find_real("yield stress") == 2.0);
  CHECK(values.word("shape") == "flat");
  CHECK(missing_parameters(parameters(), values).empty());
}

TEST_CASE("a parameter that a law does not have, or that has no value, is an error of the program",
          "[core][parameter]") {
  const ParameterValues values(parameters());
  CHECK_THROWS_AS(values.real("yeild stress"), std::logic_error);
  CHECK_THROWS_AS(values.real("yield stress"), std::logic_error);
  CHECK_THROWS_AS(values.real("shape"), std::logic_error);
  CHECK_FALSE(values.knows("yeild stress"));
}

TEST_CASE("values are equal when law and numbers are, wherever names stand", "[core][parameter]") {
  ParameterValues first(parameters()), second(parameters());
  first.set("curve", DeckName{"f", {}});
  second.set("curve", DeckName{"F", {nullptr, 3, 4, nullptr}});
  CHECK(first == second);
  second.set("beta", 0.5);
  CHECK_FALSE(first == second);
  const std::vector<Parameter> others = parameters();
  CHECK_FALSE(ParameterValues(parameters()) == ParameterValues(others));
}

TEST_CASE("names are listed by what they are of", "[core][parameter]") {
  std::vector<Parameter> models = parameters();
  models.push_back(parameter::real("model", ""));
  models.back().kind = ParameterKind::models_by_period;
  ParameterValues values(models);
  values.set("curve", DeckName{"f", {}});
  values.add("model", {{"rub", {}}, {{"p1", {}}}});
  values.add("model", {{"tied", {}}, {{"p2", {}}}});
  CHECK(values.names(ParameterKind::function) == std::vector<DeckName>{{"f", {}}});
  CHECK(values.names(ParameterKind::friction_model) == std::vector<DeckName>{{"rub", {}}, {"tied", {}}});
}
