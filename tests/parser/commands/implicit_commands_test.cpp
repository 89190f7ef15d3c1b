// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/implicit_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

/// A deck with an implicit region that has these lines.
ParsedDeck with_lines(const std::string& lines) {
  return parsed_sierra(
      "begin adagio procedure p\n"
      "begin adagio region r\n"
      "use finite element model m\n" +
      lines +
      "end\n"
      "end\n"
      "begin finite element model m\nend\n");
}

const Region& region_of(const ParsedDeck& deck) { return deck.simulation.procedures.at(0).regions.at(0); }

}  // namespace

TEST_CASE("the lines of a solver reach their fields", "[parser][implicit]") {
  const ParsedDeck deck = with_lines(
      "begin solver\n"
      "begin cg\n"
      "target relative residual = 1e-6\n"
      "target residual = 2\n"
      "acceptable relative residual = 1e-3\n"
      "acceptable residual = 3\n"
      "minimum iterations = 2\n"
      "maximum iterations = 50\n"
      "reference = belytschko\n"
      "line search secant 1e-3\n"
      "begin full tangent preconditioner\n"
      "tangent diagonal scale = 1e-6\n"
      "linear solver = amg\n"
      "end\n"
      "end\n"
      "begin loadstep predictor\n"
      "type = scale_factor\n"
      "scale factor = 0.5 0.0\n"
      "end\n"
      "end\n");
  CHECK(deck.messages.empty());
  const SolverSettings& solver = *region_of(deck).solver;
  CHECK(solver.cg.target_relative_residual == 1e-6);
  CHECK(solver.cg.target_residual == 2.0);
  CHECK(solver.cg.acceptable_relative() == 1e-3);
  CHECK(solver.cg.acceptable_residual == 3.0);
  CHECK(solver.cg.min_iterations == 2);
  CHECK(solver.cg.max_iterations == 50);
  CHECK(solver.cg.reference == ResidualReference::belytschko);
  CHECK(solver.cg.line_search_tolerance == 1e-3);
  const FullTangentSettings& full = *solver.cg.full_tangent;
  CHECK(full.tangent_diagonal_scale == 1e-6);
  CHECK(full.linear_solver == LinearSolver::multigrid);
  CHECK(solver.predictor.type == LoadstepPredictor::Type::scale_factor);
  CHECK(solver.predictor.scale_factor == 0.5);
  CHECK(solver.predictor.first_scale_factor == 0.0);
}

TEST_CASE("a solver without lines has the defaults of the manual", "[parser][implicit]") {
  const ParsedDeck deck = with_lines("begin solver\nbegin cg\nend\nend\n");
  const CgSettings& cg = region_of(deck).solver->cg;
  CHECK(cg.target_relative_residual == 1e-4);
  CHECK(cg.acceptable_relative() == Approx(1e-3));
  CHECK(cg.reference == ResidualReference::external);
  CHECK_FALSE(cg.full_tangent);
}

TEST_CASE("equation solvers are chosen by the deck or by the model", "[parser][implicit]") {
  const auto with_solver = [](const std::string& line) {
    return with_lines("begin solver\nbegin cg\nbegin full tangent preconditioner\n" + line +
                      "end\nend\nend\n");
  };
  const auto solver_of = [](const ParsedDeck& deck) {
    return region_of(deck).solver->cg.full_tangent->linear_solver;
  };
  CHECK(solver_of(with_solver("")) == LinearSolver::automatic);
  CHECK(solver_of(with_solver("linear solver = auto\n")) == LinearSolver::automatic);
  CHECK(solver_of(with_solver("linear solver = direct\n")) == LinearSolver::direct);
  CHECK(solver_of(with_solver("linear solver = distributed\n")) == LinearSolver::distributed);
  const ParsedDeck of_sierra = with_solver("linear solver = gdsw\n");
  CHECK(solver_of(of_sierra) == LinearSolver::automatic);
  CHECK(of_sierra.messages ==
        "a.i:8:17: warning: the equation solver is one of contactsim's own, chosen by the model; LINEAR "
        "SOLVER = "
        "AUTO says so; AMG and DIRECT choose [deck-ignored]\n");
  CHECK(with_solver("linear solver = agm\n").messages ==
        "a.i:8:17: error: expected one of auto, amg, direct, distributed, feti, gdsw, tpetra for 'linear "
        "solver', found "
        "'agm'; did you mean "
        "'amg'?\n");
}

TEST_CASE("the lines of adaptive time stepping reach their fields", "[parser][implicit]") {
  const ParsedDeck deck = with_lines(
      "begin adaptive time stepping\n"
      "cutback factor = 0.8\n"
      "growth factor = 1.05\n"
      "maximum failure cutbacks = 50\n"
      "target iterations = 75\n"
      "iteration window = 5\n"
      "maximum multiplier = 100\n"
      "minimum multiplier = 1e-12\n"
      "end\n");
  CHECK(deck.messages.empty());
  const AdaptiveTimeStepping& adaption = *region_of(deck).adaptive_time_stepping;
  CHECK(adaption.cutback_factor == 0.8);
  CHECK(adaption.growth_factor == 1.05);
  CHECK(adaption.max_failure_cutbacks == 50);
  CHECK(adaption.target_iterations == 75);
  CHECK(adaption.iteration_window == 5);
  CHECK(adaption.max_multiplier == 100.0);
  CHECK(adaption.min_multiplier == 1e-12);
}

TEST_CASE("what implicit lines do not do is reported", "[parser][implicit]") {
  CHECK(with_lines("begin solver\nbegin cg\npreconditioner = elastic\nend\nend\n").messages ==
        "a.i:7:18: warning: the stiffness of each node, by probes, is used in its place; PRECONDITIONER = "
        "PROBE says so [deck-ignored]\n");
  CHECK(with_lines("begin adaptive time stepping\ncutback factor = 1.5\nend\n").messages ==
        "a.i:6:18: error: the factor must be below 1\n");
  CHECK(
      with_lines("begin implicit dynamics\nend\n").messages ==
      "a.i:5:7: error: block 'implicit dynamics' is not supported and would change the answer; inertia takes "
      "part in explicit procedures alone\n");
  CHECK(with_lines("begin solver\nbegin control stiffness\nend\nend\n").messages ==
        "a.i:6:7: warning: block 'control stiffness' has no effect here; all stiffness acts from the first "
        "iteration on [deck-ignored]\n");
}

TEST_CASE("control failure says how often equilibrium is sought after deaths", "[parser][implicit]") {
  const auto failure = [](const std::string& lines) {
    return with_lines("begin solver\nbegin control failure f\n" + lines + "end\nend\n");
  };
  CHECK_FALSE(region_of(with_lines("begin solver\nend\n")).solver->control_failure);
  CHECK(region_of(failure("")).solver->control_failure->max_iterations == 100);
  CHECK(region_of(failure("maximum iterations = 0\n")).solver->control_failure->max_iterations == 0);
  CHECK(failure("level = 1\n").messages ==
        "a.i:7:1: warning: 'level' has no effect here; failure is the outermost level [deck-ignored]\n");
  CHECK(failure("maximum iterations = -1\n").messages.find("error") != std::string::npos);
  CHECK(failure("target residual = 1\n").messages.find("error") != std::string::npos);
}

TEST_CASE("control contact says how exactly contact holds", "[parser][implicit]") {
  const ParsedDeck deck = with_lines(
      "begin solver\nbegin control contact\ntarget relative residual = 1e-5\nacceptable relative residual = "
      "0.1\n"
      "minimum iterations = 1\nmaximum iterations = 7\nend\nend\n");
  CHECK(deck.messages == "");
  const ControlContact& control = region_of(deck).solver->control_contact;
  CHECK(control.target_relative_residual == 1e-5);
  CHECK(control.acceptable_relative() == 0.1);
  CHECK(control.min_iterations == 1);
  CHECK(control.max_iterations == 7);
  CHECK(ControlContact{}.acceptable_relative() == Approx(1e-2));
  CHECK_THAT(
      with_lines("begin solver\nbegin control contact\ntarget relative residul = 1\nend\nend\n").messages,
      Catch::Contains("target relative residual"));
  CHECK_THAT(with_lines("begin solver\nbegin control contact\nmaximum iterations = -1\nend\nend\n").messages,
             Catch::Contains("error"));
}

TEST_CASE("values may be of one time stepping block", "[parser][implicit]") {
  const ParsedDeck deck = parsed_sierra(
      "begin adagio procedure p\n"
      "begin time control\n"
      "begin time stepping block one\nstart time = 0\n"
      "begin parameters for adagio region r\ntime increment = 1\nend\nend\n"
      "begin time stepping block two\nstart time = 1\n"
      "begin parameters for adagio region r\ntime increment = 1\nend\nend\n"
      "termination time = 2\nend\n"
      "begin adagio region r\n"
      "use finite element model m\n"
      "begin solver\nbegin cg\n"
      "target relative residual = 1e-6 during two\n"
      "target relative residual = 1e-5\n"
      "maximum iterations = 7 during one two\n"
      "end\nend\n"
      "end\nend\n"
      "begin finite element model m\nend\n");
  CHECK(deck.messages.empty());
  const CgSettings& cg = region_of(deck).solver->cg;
  CHECK(cg.target_relative_residual == 1e-5);
  CHECK(settings_during(cg, {"one", {}}).target_relative_residual == 1e-5);
  CHECK(settings_during(cg, {"TWO", {}}).target_relative_residual == 1e-6);
  CHECK(settings_during(cg, {"two", {}}).max_iterations == 7);
  CHECK_THAT(with_lines("begin solver\nbegin cg\ntarget residual = 1 during p1\nend\nend\n").messages,
             Catch::Matchers::Contains("p1"));
}
