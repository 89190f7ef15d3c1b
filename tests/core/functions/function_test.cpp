// SPDX-License-Identifier: BSD-3-Clause
#include "core/functions/function.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/function_definition.hpp"

using namespace contactsim;

namespace {

constexpr double lost_digits = std::numeric_limits<double>::quiet_NaN();

Function made(const FunctionDefinition& definition) {
  Diagnostics diagnostics;
  auto function = make_function(definition, diagnostics);
  REQUIRE(diagnostics.empty());
  REQUIRE(function);
  return *function;
}

}  // namespace

TEST_CASE("two points of one abscissa are a jump, with the value of the right or the left side",
          "[core][function]") {
  FunctionDefinition definition =
      table_function(FunctionType::piecewise_linear, {{0, 0}, {1, 1}, {1, 3}, {2, 4}});
  Diagnostics diagnostics;
  const Function right = make_function(definition, diagnostics).value();
  definition.at_discontinuity = DiscontinuitySide::left;
  const Function left = make_function(definition, diagnostics).value();
  CHECK(diagnostics.empty());
  CHECK(right.evaluate(1.0) == 3.0);
  CHECK(left.evaluate(1.0) == 1.0);
  for (const Function& function : {right, left}) {
    CHECK(function.evaluate(0.0) == 0.0);
    CHECK(function.evaluate(0.5) == 0.5);
    CHECK(function.evaluate(std::nextafter(1.0, 0.0)) == Approx(1.0));
    CHECK(function.evaluate(std::nextafter(1.0, 2.0)) == Approx(3.0));
    CHECK(function.evaluate(1.5) == 3.5);
    CHECK(function.evaluate(2.0) == 4.0);
  }
  CHECK(find_jump(definition) == 1.0);
  CHECK_FALSE(find_jump(table_function(FunctionType::piecewise_linear, {{0, 0}, {1, 1}})));
}

TEST_CASE("both coordinates are offset first and scaled then", "[core][function]") {
  FunctionDefinition definition = table_function(FunctionType::piecewise_linear, {{0, 1}, {1, 3}});
  definition.x_scale = 2.0;
  definition.x_offset = 1.0;  // abscissae 2 and 4
  definition.y_scale = 10.0;
  definition.y_offset = -1.0;  // ordinates 0 and 20
  const Function f = made(definition);
  CHECK(f.evaluate(2.0) == 0.0);
  CHECK(f.evaluate(3.0) == 10.0);
  CHECK(f.evaluate(4.0) == 20.0);
  definition.y_scale = -10.0;
  CHECK(made(definition).evaluate(4.0) == -20.0);
}

TEST_CASE("a constant function is scaled", "[core][function]") {
  FunctionDefinition definition = table_function(FunctionType::constant, {{lost_digits, 7}});
  definition.y_scale = 2.0;
  definition.y_offset = 1.0;
  CHECK(made(definition).evaluate(123.0) == 16.0);
  CHECK(made(definition).is_constant());
}

TEST_CASE("an analytic function reads x and is scaled", "[core][function]") {
  FunctionDefinition definition = analytic_function("x < 1 ? 10*x : 10;");
  definition.y_scale = 2.0;
  definition.y_offset = 1.0;
  const Function f = made(definition);
  CHECK(f.inputs().empty());
  CHECK(f.evaluate(0.5) == 12.0);
  CHECK(f.evaluate(2.0) == 22.0);
  CHECK_FALSE(f.is_constant());
  CHECK(made(analytic_function("pi - pi")).is_constant());
  CHECK_FALSE(std::isfinite(made(analytic_function("1/x")).evaluate(0.0)));
}

TEST_CASE("expression variables are the inputs of a function", "[core][function]") {
  FunctionDefinition definition = analytic_function("v_y + 10*T + 100*s_zx");
  definition.variables = {{{"V", {}}, ExpressionSource::nodal_vector, {"velocity", {}}},
                          {{"t", {}}, ExpressionSource::global, {"time", {}}},
                          {{"s", {}}, ExpressionSource::element_sym_tensor, {"stress", {}}}};
  const Function f = made(definition);
  REQUIRE(f.inputs().size() == 10);
  CHECK(f.inputs()[1].name == "v_y");
  CHECK(f.inputs()[1].component == "y");
  CHECK(f.inputs()[1].variable.text == "velocity");
  CHECK(f.inputs()[3].name == "t");
  CHECK(f.inputs()[3].component.empty());
  CHECK(f.inputs()[9].name == "s_zx");
  CHECK(f.evaluate(std::array{0.0, 2.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0}) == 432.0);
}

TEST_CASE("a full tensor has nine inputs", "[core][function]") {
  FunctionDefinition definition = analytic_function("f_xz - f_zx");
  definition.variables = {{{"f", {}}, ExpressionSource::nodal_tensor, {"gradient", {}}}};
  CHECK(made(definition).inputs().size() == 9);
  CHECK(made(definition).evaluate(std::array{0.0, 0.0, 0.0, 0.0, 0.0, 6.0, 0.0, 0.0, 9.0}) == 3.0);
}
