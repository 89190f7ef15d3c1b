// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/global_expression.hpp"

#include "parser/text/expression_grammar.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("an expression reads globals by name, components by their ending", "[core][output]") {
  SampleRun run;
  const OutputVariables variables(run.model);
  const GlobalExpression expression(read_deck_expression({}, "2 * Time + momentum_y - KineticEnergy"),
                                    variables);
  run.state.time = 3.0;
  run.state.momentum = {1, 20, 300};
  run.state.energies.kinetic = 5.0;
  CHECK(expression.evaluate(run.context()) == 21.0);
  run.state.time = 4.0;
  CHECK(expression.evaluate(run.context()) == 23.0);
}

TEST_CASE("an expression may do without globals", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  CHECK(GlobalExpression(read_deck_expression({}, "max(2, 3)"), variables).evaluate(run.context()) == 3.0);
}

TEST_CASE("what is no number of the whole is unknown to an expression", "[core][output]") {
  const SampleRun run;
  const OutputVariables variables(run.model);
  CHECK_THROWS_AS(GlobalExpression(read_deck_expression({}, "velocity_x + 1"), variables), ExpressionError);
  CHECK_THROWS_AS(GlobalExpression(read_deck_expression({}, "momentum"), variables),
                  ExpressionError);  // three numbers
}
