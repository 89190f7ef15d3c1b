// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/parameter_rows.hpp"

#include "parser/commands/rows.hpp"
#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

/// A law of parameters of most kinds.
const std::vector<Parameter>& sample_parameters() {
  static const std::vector<Parameter> parameters = [] {
    std::vector<Parameter> made{
        {"modulus", ParameterKind::positive, "Young [force/length^2]"},
        {"ratio", ParameterKind::poissons_ratio, "Poisson [1]"},
        {"slope", ParameterKind::real, "Slope [1]"},
        {"terms", ParameterKind::count, "How many [1]"},
        {"rule", ParameterKind::word, "How"},
        {"curve", ParameterKind::function, "A function"},
        {"models", ParameterKind::models_by_period, "Models"},
        {"colour", ParameterKind::ignored, "Looks alone"},
        {"magic", ParameterKind::refused, "Use none"},
        {"double slope", ParameterKind::real, "Twice the slope [1]"},
    };
    made[0] = made[0].required().or_spelled("youngs modulus");
    made[2] = made[2].otherwise(1.5);
    made[4].words = {"first", "second"};
    made[9] = made[9].for_other("slope", 0.5);
    return made;
  }();
  return parameters;
}

struct BoundLaw {
  ParameterValues values{sample_parameters()};
  std::string said;
};

/// Lines of the law, the first of which is line 2.
BoundLaw bound_law(const std::string& lines) {
  static const Table<ParameterValues> table = make_parameter_table(sample_parameters());
  const Block deck = block_of("begin law\n" + lines + "end\n");
  BoundLaw bound;
  Diagnostics said;
  Binding binding{said, false};
  table.bind(std::get<Block>(deck.items.at(0).value), bound.values, binding);
  bound.said = messages(said);
  return bound;
}

}  // namespace

TEST_CASE("parameters of a law are read into their values", "[parser][parameters]") {
  const BoundLaw bound = bound_law(
      "youngs_modulus = 2e11\nratio = -0.25\nslope is 3\nterms = 4\nrule = SECOND\ncurve = ramp\n"
      "models = rub during periods p1 p2\nmodels = glue during period p3\n");
  CHECK(bound.said == "");
  CHECK(bound.values.real("modulus") == 2e11);
  CHECK(bound.values.real("ratio") == -0.25);
  CHECK(bound.values.real("slope") == 3.0);
  CHECK(bound.values.count("terms") == 4);
  CHECK(bound.values.word("rule") == "second");
  CHECK(bound.values.name("curve").text == "ramp");
  REQUIRE(bound.values.models("models").size() == 2);
  CHECK(bound.values.models("models")[0].model.text == "rub");
  CHECK(bound.values.models("models")[0].periods.size() == 2);
  CHECK(bound.values.models("models")[1].periods.at(0).text == "p3");
}

TEST_CASE("parameters that are not given are at their defaults", "[parser][parameters]") {
  const BoundLaw bound = bound_law("");
  CHECK(bound.values.real("slope") == 1.5);
  CHECK_FALSE(bound.values.has("modulus"));
  CHECK_FALSE(bound.values.has("models"));
}

TEST_CASE("a parameter may give another one, times a factor", "[parser][parameters]") {
  CHECK(bound_law("double slope = 5\n").values.real("slope") == 2.5);
}

TEST_CASE("values of parameters keep to their range", "[parser][parameters]") {
  CHECK(bound_law("modulus = 0\n").said == "a.i:2:11: error: 'modulus' must be greater than 0, found '0'\n");
  CHECK(bound_law("ratio = 0.5\n").said ==
        "a.i:2:9: error: 'ratio' must be greater than -1 and less than 0.5, found '0.5'\n");
  CHECK(bound_law("ratio = -1\n").said ==
        "a.i:2:9: error: 'ratio' must be greater than -1 and less than 0.5, found '-1'\n");
  CHECK(bound_law("ratio =\n").said ==
        "a.i:2:1: error: expected a number after 'ratio', found the end of the line\n");
  CHECK(bound_law("terms = 0\n").said.starts_with("a.i:2:9: error: "));
  CHECK(bound_law("rule = third\n").said ==
        "a.i:2:8: error: expected one of first, second for 'rule', found 'third'\n");
  CHECK(bound_law("models = rub p1\n").said ==
        "a.i:2:14: error: expected 'during' in 'models', found 'p1'\n");
}

TEST_CASE("what does nothing is warned about, what would change the answer refused", "[parser][parameters]") {
  CHECK(bound_law("colour = red\n").said.starts_with("a.i:2:1: warning: "));
  CHECK(bound_law("magic = 1\n").said.starts_with("a.i:2:1: error: "));
}

TEST_CASE("rows of parameters tell syntax, default and whether they are required", "[parser][parameters]") {
  const Table<ParameterValues> table = make_parameter_table(sample_parameters());
  const std::vector<RowText>& rows = table.text().rows;
  REQUIRE(rows.size() == sample_parameters().size());
  CHECK(rows[0].syntax == "= <real > 0>");
  CHECK(rows[0].is_required);
  CHECK(rows[0].spellings == std::vector<std::string>{"youngs modulus"});
  CHECK(rows[1].default_text == "none");
  CHECK(rows[2].default_text == "1.5");
  CHECK(rows[4].syntax == "= {first|second}");
  CHECK(rows[5].references == std::vector<NameKind>{NameKind::function});
  CHECK_FALSE(rows[6].is_single);
  CHECK(rows[7].support == Support::ignored);
  CHECK(rows[8].support == Support::refused);
}
