// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/traction_law_table.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

MaterialModel cohesive_model(double lambda_1, double lambda_2) {
  MaterialModel model{{"Tvergaard_Hutchinson", {}}, ParameterValues(traction_law_rows()[0].parameters)};
  for (const auto& [phrase, value] : {std::pair{"peak traction", 10.0},
                                      {"lambda_1", lambda_1},
                                      {"lambda_2", lambda_2},
                                      {"normal length scale", 2.0},
                                      {"tangential length scale", 4.0}})
    model.values.set(phrase, value);
  return model;
}

std::string refusal_of_model(const MaterialModel& model) {
  Diagnostics diagnostics;
  CHECK_FALSE(make_traction_law(model, diagnostics));
  return messages(diagnostics);
}

}  // namespace

TEST_CASE("every traction law is found by its name and has parameters with help",
          "[core][materials][conformance]") {
  for (const TractionLawRow& row : traction_law_rows()) {
    CHECK(find_traction_law_row(row.name) == &row);
    CHECK(row.make != nullptr);
    CHECK_FALSE(row.help.empty());
    for (const Parameter& parameter : row.parameters) {
      CHECK(parameter.help.ends_with("]"));  // its dimension
      CHECK((parameter.is_required || ParameterValues(row.parameters).real(parameter.phrase) == 1.0));
    }
  }
  CHECK(find_traction_law_row("TVERGAARD HUTCHINSON") == &traction_law_rows()[0]);
  CHECK(find_traction_law_row("elastic") == nullptr);
}

TEST_CASE("a trapezoid is made of its parameters", "[core][materials]") {
  Diagnostics diagnostics;
  const auto law = make_traction_law(cohesive_model(0.25, 0.5), diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(law);
  CHECK(law->normal_stiffness() == 10.0 / (0.25 * 2.0));
  CHECK(law->tangential_stiffness() == 10.0 * 2.0 / (0.25 * 16.0));
  CHECK(law->toughness() == 0.5 * 10.0 * 2.0 * 1.25);
  CHECK(law->penetration_factor == 1.0);
  CHECK(make_traction_law(cohesive_model(0.5, 0.5), diagnostics));  // a triangle
}

TEST_CASE("what makes no traction law is reported at the model", "[core][materials]") {
  CHECK(refusal_of_model(cohesive_model(0.5, 0.4)) ==
        "error: model 'Tvergaard_Hutchinson': 0 < LAMBDA_1 <= LAMBDA_2 < 1 must hold, found 0.5 and 0.4\n");
  CHECK(refusal_of_model(cohesive_model(0.5, 1.0)) ==
        "error: model 'Tvergaard_Hutchinson': 0 < LAMBDA_1 <= LAMBDA_2 < 1 must hold, found 0.5 and 1\n");
  CHECK(refusal_of_model({{"elastic", {}}, {}}) ==
        "error: model 'elastic': cohesive elements take no such model; there is tvergaard_hutchinson\n");
}
