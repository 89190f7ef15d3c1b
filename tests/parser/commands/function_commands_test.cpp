// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/function_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// A deck that uses the function f: as the step of an implicit region, a reference that needs little else.
/// The lines of the function begin at line 3.
ParsedDeck using_function(const std::string& lines) {
  return parsed_sierra("begin function f\n" + lines +
                       "end\n"
                       "begin adagio procedure p\n"
                       "  begin time control\n"
                       "    begin time stepping block t\n"
                       "      start time = 0\n"
                       "      begin parameters for adagio region r\n"
                       "        time increment function = F\n"
                       "      end\n"
                       "    end\n"
                       "    termination time = 1\n"
                       "  end\n"
                       "  begin adagio region r\n"
                       "    use finite element model m\n"
                       "  end\n"
                       "end\n"
                       "begin finite element model m\n"
                       "end\n");
}

}  // namespace

TEST_CASE("a piecewise linear function keeps its points as written", "[parser][function]") {
  const auto [simulation, said] = using_function(
      "  type is piecewise linear\n"
      "  abscissa = time, in seconds\n"
      "  ordinate is velocity\n"
      "  x scale = 2\n  x offset = 1\n  ordinate scale = 3\n  y offset = -1\n"
      "  begin values\n    0.0, 1.0\n    0.5 2.0 # a comment\n    0.6 3\n  end values\n");
  REQUIRE(said == "");
  const FunctionDefinition& function = simulation.functions.at(0);
  CHECK(function.name.text == "f");
  CHECK(function.type == FunctionType::piecewise_linear);
  CHECK(function.abscissa_label == "time, in seconds");
  CHECK(function.ordinate_label == "velocity");
  CHECK(function.x_scale == 2.0);
  CHECK(function.x_offset == 1.0);
  CHECK(function.y_scale == 3.0);
  CHECK(function.y_offset == -1.0);
  REQUIRE(function.values.size() == 3);
  CHECK(function.values[1].abscissa == 0.5);
  CHECK(function.values[1].ordinate == 2.0);
  CHECK(function.values[1].location.line == 12);
}

TEST_CASE("the older spelling defines a function too", "[parser][function]") {
  const auto [simulation, said] = parsed_sierra(
      "begin definition for function f\n  type = constant\n  begin values\n    7\n  end\nend\n");
  CHECK(said == "");
  REQUIRE(simulation.functions.size() == 1);
  CHECK(simulation.functions[0].values.at(0).ordinate == 7.0);
  CHECK(std::isnan(simulation.functions[0].values[0].abscissa));
}

TEST_CASE("an analytic function keeps its expression and variables", "[parser][function]") {
  const auto [simulation, said] = using_function(
      "  type = analytic\n"
      "  expression variable: v = nodal velocity(x)\n"
      "  expression variable: c = nodal_vector coordinates\n"
      "  evaluate expression is \"(v > 0) ? pow(v, 2) : c_x; \"\n");
  REQUIRE(said == "");
  const FunctionDefinition& function = simulation.functions.at(0);
  REQUIRE(function.variables.size() == 2);
  CHECK(function.variables[0].name.text == "v");
  CHECK(function.variables[0].source == ExpressionSource::nodal);
  CHECK(function.variables[0].variable.text == "velocity(x)");
  CHECK(function.variables[1].source == ExpressionSource::nodal_vector);
  CHECK(function.expression->text == "(v > 0) ? pow(v, 2) : c_x; ");
}

TEST_CASE("a piecewise constant function may take the left value at a jump", "[parser][function]") {
  const auto [simulation, said] = using_function(
      "  type = piecewise constant\n  at discontinuity evaluate to left\n  begin values\n    0 1\n  end\n");
  CHECK(said == "");
  CHECK(simulation.functions.at(0).at_discontinuity == DiscontinuitySide::left);
}

TEST_CASE("what a used function lacks is reported", "[parser][function]") {
  CHECK(using_function("").messages ==
        "a.i:2:16: error: the function 'f' has no TYPE; add TYPE = {piecewise linear|piecewise "
        "constant|constant|analytic|piecewise analytic|piecewise multivariate|multicolumn piecewise "
        "linear|xtable|polynomial|haversine spike}\n");
  CHECK(using_function("  type = analytic\n").messages ==
        "a.i:2:16: error: the function 'f' has no expression; add EVALUATE EXPRESSION\n");
  CHECK(using_function("  type = piecewise linear\n").messages ==
        "a.i:2:16: error: the function 'f' has no values; add a VALUES block\n");
  CHECK(using_function("  type = constant\n  begin values\n    1\n    2\n  end\n").messages ==
        "a.i:2:16: error: the function 'f' of type constant needs one value, found 2\n");
}

TEST_CASE("a table whose abscissa decreases is reported at its line", "[parser][function]") {
  CHECK(
      using_function("  type = piecewise linear\n  begin values\n    0 0\n    2 1\n    1 1\n    0 1\n  end\n")
          .messages == "a.i:7:5: error: the function 'f' has an abscissa that decreases from 2 to 1\n");
  CHECK(using_function("  type = piecewise linear\n  begin values\n    0 0\n    1\n    2 1 5\n  end\n")
            .messages == "a.i:6:5: error: the function 'f' needs two numbers on each line\n");
}

TEST_CASE("a mistake in an expression is reported at its character", "[parser][function]") {
  CHECK(using_function("  type = analytic\n  evaluate expression = \"2*sqtr(x)\"\n").messages ==
        "a.i:4:28: error: the function 'f': unknown function 'sqtr'; did you mean 'sqrt'?\n");
  CHECK(using_function("  type = analytic\n  evaluate expression is \"x < 1 ? 1 : \\# first\n    t\"\n")
            .messages ==
        "a.i:5:5: error: the function 'f': unknown name 't' in the expression; it may read x\n");
  CHECK(using_function("  type = analytic\n  evaluate expression is 2 * (x\n").messages ==
        "a.i:4:32: error: the function 'f': expected ')' for this '(', found the end of the expression\n");
}

TEST_CASE("words among the values are reported", "[parser][function]") {
  CHECK(using_function("  type = piecewise linear\n  begin values\n    0 0\n    1 one\n  end\n").messages ==
        "a.i:6:7: error: expected a number for '1', found 'one'\n");
  CHECK(using_function("  type = piecewise linear\n  begin values\n    0 0\n    one 1\n  end\n").messages ==
        "a.i:6:5: error: unknown command 'one 1' in 'values'\n");
}

TEST_CASE("a function that nothing uses is not judged", "[parser][function]") {
  CHECK(parsed_sierra(
            "begin function f\n  type = piecewise linear\n  begin values\n    1 0\n    0 1\n  end\nend\n")
            .messages == "");
}

TEST_CASE("function types of the language are all known", "[parser][function]") {
  for (const std::string type : {"piecewise linear", "PIECEWISE CONSTANT", "constant", "analytic",
                                 "piecewise analytic", "piecewise multivariate",
                                 "multicolumn piecewise linear", "xtable", "polynomial", "haversine spike"}) {
    INFO(type);
    CHECK(parsed_sierra("begin function f\n  type = " + type + "\nend\n").messages == "");
  }
  CHECK(
      using_function("  type = piecewise linaer\n").messages ==
      "a.i:3:10: error: expected one of piecewise linear, piecewise constant, constant, analytic, piecewise "
      "analytic, piecewise multivariate, multicolumn piecewise linear, xtable, polynomial, haversine spike "
      "for "
      "'type', found 'piecewise'\n");
}

TEST_CASE("lines that change a function in ways not supported are refused when it is used",
          "[parser][function]") {
  CHECK(using_function("  type = constant\n  begin values\n    1\n  end\n  data file = f.txt\n").messages ==
        "a.i:7:3: error: 'data file' is not supported and would change the answer; put the values into a "
        "VALUES "
        "block, or name the file by INCLUDEFILE inside it\n");
  CHECK(parsed_sierra("begin function f\n  data file = f.txt\nend\n").messages ==
        "a.i:3:3: warning: 'data file' is not supported and would change the answer, but nothing uses this "
        "definition; put the values into a VALUES block, or name the file by INCLUDEFILE inside it "
        "[deck-unused]\n");
}

TEST_CASE("a point that is repeated is taken once, with a warning", "[parser][function]") {
  const auto [simulation, said] = parsed_sierra(
      "begin function f\n  type = piecewise linear\n  begin values\n    0 0\n    1 2\n    1 2\n    1 3\n"
      "  end\nend\n");
  REQUIRE(simulation.functions[0].values.size() == 3);
  CHECK(simulation.functions[0].values[2].ordinate == 3.0);
  CHECK(said.find("a.i:7:5: warning: a point of the function is repeated; the first one is taken") !=
        std::string::npos);
}
