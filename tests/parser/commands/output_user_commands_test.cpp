// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/output_user_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

UserOutput output_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin user output\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.user_outputs.at(0);
}

UserVariable variable_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin user variable v\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.user_variables.at(0);
}

}  // namespace

TEST_CASE("each reduction of user output is bound", "[parser][output]") {
  const auto [words, reduction] = GENERATE(table<std::string, OutputReduction>({
      {"sum", OutputReduction::sum},
      {"max", OutputReduction::maximum},
      {"min", OutputReduction::minimum},
      {"average", OutputReduction::average},
      {"max absolute value", OutputReduction::absolute_maximum},
      {"l2norm", OutputReduction::l2_norm},
      {"variance", OutputReduction::variance},
  }));
  const UserOutput output =
      output_of("surface = s\ncompute global g as " + words + " of nodal force_contact(z)\n");
  CHECK(joined_names(output.set.side_sets) == "s");
  CHECK_FALSE(output.is_every_step);
  const auto& variable = std::get<ReducedVariable>(output.variables.at(0));
  CHECK(variable.name.text == "g");
  CHECK(variable.reduction == reduction);
  CHECK(variable.source_location == VariableLocation::nodal);
  CHECK(variable.source.name.text == "force_contact");
  CHECK(variable.source.component == "z");
}

TEST_CASE("the other ways to compute variables are bound, in order", "[parser][output]") {
  const UserOutput output = output_of(
      "include all blocks\ncompute at every step\ncompute nodal a as function f\ncompute element b as "
      "function g\n"
      "compute global c as function h\ncompute global d from expression \"a + b, 2\"\n"
      "compute element e as volume weighted average of element eqps\n"
      "extrapolate element variable e to nodal variable en\n");
  CHECK(output.is_every_step);
  REQUIRE(output.variables.size() == 6);
  CHECK(std::get<FunctionVariable>(output.variables[0]).location == VariableLocation::nodal);
  CHECK(std::get<FunctionVariable>(output.variables[1]).location == VariableLocation::element);
  CHECK(std::get<FunctionVariable>(output.variables[2]).location == VariableLocation::global);
  CHECK(std::get<FunctionVariable>(output.variables[2]).function.text == "h");
  CHECK(std::get<ComputedExpression>(output.variables[3]).expression.text == "a + b, 2");
  CHECK(std::get<VolumeAverage>(output.variables[4]).source.name.text == "eqps");
  CHECK(std::get<NodalExtrapolation>(output.variables[5]).source.name.text == "e");
  CHECK(std::get<NodalExtrapolation>(output.variables[5]).name.text == "en");
}

TEST_CASE("what user output cannot compute is reported", "[parser][output]") {
  CHECK(bound_region(
            "begin user output\ncompute at every time\ncompute element b as nonlocal average of element v\n"
            "compute nodal c as sum of nodal v\ncompute element d as\nend\n")
            .messages ==
        "a.i:3:22: error: averages over neighbours are not computed\n"
        "a.i:4:20: error: expected 'function' in 'compute nodal', found 'sum'\n"
        "a.i:5:1: error: expected FUNCTION or VOLUME WEIGHTED AVERAGE OF ELEMENT after 'as'\n");
}

TEST_CASE("a user variable has a place, a shape and values", "[parser][output]") {
  using P = UserVariable::Place;
  using S = UserVariable::Shape;
  CHECK(variable_of("").place == P::node);
  CHECK(variable_of("").shape == S::real);
  CHECK(variable_of("").length == 1);
  CHECK(variable_of("type = element real length = 3\n").place == P::element);
  CHECK(variable_of("type = element real length = 3\n").length == 3);
  CHECK(variable_of("type = global integer length = 1\n").shape == S::integer);
  CHECK(variable_of("type is node vector\n").shape == S::vector);
  CHECK(variable_of("type = node real sym_tensor\n").shape == S::sym_tensor);
  CHECK(variable_of("type = node full_tensor\n").shape == S::full_tensor);
  const UserVariable variable = variable_of(
      "type = global real length = 2\ninitial value = 1 2\nglobal operator = max\nblock = b1 b2\nuse with "
      "restart\n");
  CHECK(variable.name.text == "v");
  CHECK(variable.initial_values == std::vector<double>{1.0, 2.0});
  CHECK(variable.global_operator == UserVariable::GlobalOperator::maximum);
  CHECK(joined_names(variable.blocks) == "b1 b2");
  CHECK(variable.is_in_restart);
}
