// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/friction_commands.hpp"

#include "core/interface_laws/interface_law_table.hpp"
#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// The values of a single friction model of a law.
ParameterValues values_of(const std::string& type, const std::string& lines = "") {
  const std::string block = "begin " + type + " model m\n" + lines;
  const BoundContact bound = bound_contact(block + "end\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.contact.friction_models.size() == 1);
  CHECK(bound.contact.friction_models[0].name.text == "m");
  CHECK(bound.contact.friction_models[0].law.type == type);
  return bound.contact.friction_models[0].law.values;
}

}  // namespace

TEST_CASE("models without parameters are empty blocks", "[parser][friction]") {
  for (const char* type : {"frictionless", "tied", "stick", "glued"})
    CHECK(values_of(type).parameters().empty());
}

TEST_CASE("every line of every law is read into its parameter", "[parser][friction][conformance]") {
  for (const InterfaceLawRow& row : interface_law_rows()) {
    for (const Parameter& parameter : row.parameters) {
      INFO(row.name << ": " << parameter.phrase);
      const bool is_name =
          parameter.kind == ParameterKind::function || parameter.kind == ParameterKind::friction_model;
      const bool is_list = parameter.kind == ParameterKind::models_by_period;
      const std::string value = is_name ? "other" : is_list ? "other during period p" : "3";
      const ParameterValues values = values_of(row.name, parameter.phrase + " = " + value + "\n");
      REQUIRE(values.has(parameter.phrase));
      if (is_name) {
        CHECK(values.name(parameter.phrase).text == "other");
      } else if (is_list) {
        CHECK(values.models(parameter.phrase).size() == 1);
      } else if (parameter.kind == ParameterKind::count) {
        CHECK(values.count(parameter.phrase) == 3);
      } else {
        CHECK(values.real(parameter.phrase) == 3.0);
      }
    }
  }
}

TEST_CASE("a constant friction model has a coefficient, 0 if none is given", "[parser][friction]") {
  CHECK(values_of("constant friction", "friction coefficient = .3\n").real("friction coefficient") == 0.3);
  CHECK(values_of("constant friction").real("friction coefficient") == 0.0);
  CHECK(bound_contact("begin constant friction model m\nfriction coefficient = -1\nend\n").messages ==
        "a.i:3:24: error: 'friction coefficient' must not be negative, found '-1'\n");
}

TEST_CASE("what fails has defaults", "[parser][friction]") {
  const ParameterValues weld = values_of("spring weld");
  CHECK(weld.real("normal displacement scale factor") == 1.0);
  CHECK(weld.real("failure envelope exponent") == 2.0);
  CHECK(weld.count("failure decay cycles") == 1);
  CHECK_FALSE(weld.has("failed model"));
  CHECK_FALSE(values_of("area weld").has("normal capacity"));
  CHECK_FALSE(values_of("junction").has("normal cutoff distance for tangential traction"));
}

TEST_CASE("an underscore is a blank in the name of a law", "[parser][friction]") {
  const BoundContact bound = bound_contact("begin pv_dependent model m\nend\n");
  CHECK(bound.messages == "");
  CHECK(bound.contact.friction_models.at(0).law.type == "pv dependent");
}

TEST_CASE("a time variant model selects among others", "[parser][friction]") {
  const auto models =
      values_of("time variant", "model = glue during periods p1 p2\nmodel rub during period p3\n")
          .models("model");
  REQUIRE(models.size() == 2);
  CHECK(models[0].model.text == "glue");
  CHECK(joined_names(models[0].periods) == "p1 p2");
  CHECK(joined_names(models[1].periods) == "p3");
}

TEST_CASE("a friction model must have a name", "[parser][friction]") {
  CHECK(bound_contact("begin tied model\nend\n").messages ==
        "a.i:2:12: error: the block 'model' needs a name\n");
}

TEST_CASE("a model of user subroutines is refused", "[parser][friction]") {
  CHECK(bound_contact("begin user subroutine model m\nend\n").messages ==
        "a.i:2:7: error: block 'user subroutine model' is not supported and would change the answer; "
        "user subroutines cannot be run\n");
}
