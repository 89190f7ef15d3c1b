// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "core/functions/function.hpp"
#include "support/catch.hpp"
#include "support/function_definition.hpp"

using namespace contactsim;

namespace {

/// What is said about a definition, one line per problem; a function is made exactly when nothing is said.
std::string problems_of(const FunctionDefinition& definition) {
  Diagnostics diagnostics;
  const bool is_made = make_function(definition, diagnostics).has_value();
  CHECK(is_made == diagnostics.empty());
  std::string all;
  for (const DiagnosticGroup& group : diagnostics.grouped()) all += format_machine(group);
  return all;
}

FunctionDefinition linear(const std::vector<std::pair<double, double>>& points) {
  return table_function(FunctionType::piecewise_linear, points);
}

}  // namespace

TEST_CASE("a table whose abscissae do not increase is refused at its line", "[core][function]") {
  CHECK(problems_of(linear({{0, 0}, {2, 1}, {1, 1}, {0, 1}})) ==
        "a.i:3:1: error: the function 'f' has an abscissa that decreases from 2 to 1\n");
  CHECK(problems_of(linear({{0, 0}, {1, 1}, {1, 2}, {1, 3}})) ==
        "a.i:4:1: error: the function 'f' has the abscissa 1 three times; a jump has the value before it and "
        "the one after it\n");
  CHECK(problems_of(table_function(FunctionType::piecewise_constant, {{0, 0}, {1, 1}, {1, 2}})) ==
        "a.i:3:1: error: the function 'f' has the abscissa 1 twice; each point needs one of its own\n");
  FunctionDefinition rounded = linear({{0, 0}, {1, 1}});
  rounded.x_offset = 1e20;
  CHECK(problems_of(rounded).find("has the abscissa 1e+20 twice") != std::string::npos);
}

TEST_CASE("scales that lose a table are refused", "[core][function]") {
  FunctionDefinition definition = linear({{0, 0}, {1, 1}});
  for (const double scale : {0.0, -1.0}) {
    definition.x_scale = scale;
    CHECK(problems_of(definition).find("which is not positive; write the abscissae as they are meant") !=
          std::string::npos);
  }
  definition = linear({{0, 1}, {1, 1e10}});
  definition.y_scale = 1e300;
  CHECK(problems_of(definition) ==
        "a.i:2:1: error: the function 'f' has a scaled value that is not finite\n");
  CHECK(problems_of(linear({{-1.5e308, 1}, {1.5e308, 2}})) ==
        "a.i:100:1: error: the function 'f' has abscissae too far apart\n");
}

TEST_CASE("lines that are no points are refused", "[core][function]") {
  CHECK(problems_of(linear({})) == "a.i:100:1: error: the function 'f' has no values; add a VALUES block\n");
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(problems_of(linear({{0, 1}, {none, 1}})) ==
        "a.i:2:1: error: the function 'f' needs two numbers on each line\n");
  CHECK(problems_of(table_function(FunctionType::constant, {{1, 2}})) ==
        "a.i:1:1: error: the function 'f' of type constant needs one number\n");
  CHECK(problems_of(table_function(FunctionType::constant, {})) ==
        "a.i:100:1: error: the function 'f' of type constant needs one value, found 0\n");
}

TEST_CASE("what is wrong in an expression is reported at its deck column", "[core][function]") {
  CHECK(problems_of(analytic_function("1 + sine(x)")) ==
        "a.i:1:6: error: the function 'f': unknown function 'sine'; did you mean 'sin'?\n");
  CHECK(problems_of(analytic_function("2 * (x")) ==
        "a.i:1:8: error: the function 'f': expected ')' for this '(', found the end of the expression\n");
  CHECK(problems_of(analytic_function("1/0")) == "a.i:1:2: error: the function 'f' has no finite value\n");
}

TEST_CASE("an analytic function that has two readings is refused", "[core][function]") {
  FunctionDefinition definition = analytic_function("x");
  definition.x_scale = 2.0;
  CHECK(problems_of(definition) ==
        "a.i:100:1: error: the function 'f' of type analytic takes no X SCALE and no X OFFSET; put them into "
        "the expression\n");
  definition = analytic_function("v_x");
  definition.variables = {{{"v", {}}, ExpressionSource::nodal_vector, {"velocity", {}}},
                          {{"V_X", definition.name.location}, ExpressionSource::global, {"time", {}}}};
  CHECK(problems_of(definition) == "a.i:100:1: error: the function 'f' has two variables named 'v_x'\n");
}

TEST_CASE("a function is found by its name in any case", "[core][function]") {
  const std::vector<FunctionDefinition> definitions{linear({{0, 5}})};
  Diagnostics diagnostics;
  CHECK(make_named_function({"F", {}}, definitions, diagnostics)->evaluate(0.0) == 5.0);
  CHECK(make_named_function({"Sierra_Constant_Function_One", {}}, {}, diagnostics)->evaluate(9.0) == 1.0);
  CHECK(diagnostics.empty());
  CHECK_FALSE(make_named_function({"ff", {}}, definitions, diagnostics));
  CHECK(diagnostics.all().at(0).text == "there is no function 'ff'");
  CHECK(diagnostics.all().at(0).hint == "did you mean 'f'?");
}
