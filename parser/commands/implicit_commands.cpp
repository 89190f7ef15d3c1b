// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/implicit_commands.hpp"

#include "parser/commands/block_rows.hpp"

namespace contactsim {

namespace {

/// These blocks are bound into nothing.
struct Nothing {};

Row<Nothing> line(std::string_view phrase, std::string_view syntax, const std::string& help) {
  return ignored<Nothing>(phrase, syntax, "implicit only: " + help);
}

Row<Nothing> inner(std::string_view phrase, const std::function<const TableText&()>& contents,
                   const std::string& help) {
  return ignored_block<Nothing>(phrase, contents, "implicit only: " + help);
}

const TableText& preconditioner_text() {
  static const Table<Nothing> table({
      line("linear solver", "= <equation solver>", "solver of the preconditioner"),
      line("nodal probe factor", "= <real>", "size of the probe [1]"),
      line("small number of iterations", "= <integer>", "iterations that do not call for a new one [1]"),
      line("iteration update", "= <integer>", "iterations between two updates [1]"),
      line("step update", "= <integer>", "steps between two updates [1]"),
      line("constraint enforcement", "= <method>", "how constraints enter"),
      line("minimum smoothing iterations", "= <integer>", "smoothing before the solve [1]"),
      line("maximum smoothing iterations", "= <integer>", "smoothing before the solve [1]"),
      line("tangent diagonal scale", "= <real>", "factor of the diagonal [1]"),
  });
  return table.text();
}

const TableText& conjugate_gradient_text() {
  static const Table<Nothing> table({
      line("target relative residual", "= <real> [DURING <period> ...]", "residual aimed at [1]"),
      line("target residual", "= <real> [DURING <period> ...]", "residual aimed at [force]"),
      line("acceptable relative residual", "= <real> [DURING <period> ...]", "residual put up with [1]"),
      line("acceptable residual", "= <real> [DURING <period> ...]", "residual put up with [force]"),
      line("maximum iterations", "= <integer> [DURING <period> ...]", "iterations at most [1]"),
      line("minimum iterations", "= <integer> [DURING <period> ...]", "iterations at least [1]"),
      line("iteration print", "= <integer>", "iterations between two lines of the log [1]"),
      line("reference", "= {BELYTSCHKO|EXTERNAL|INTERNAL}", "force that residuals are compared with"),
      line("line search", "SECANT [<tolerance>]", "line search, tolerance [1]"),
      line("preconditioner", "= <name>", "preconditioner"),
      inner("full tangent preconditioner", preconditioner_text, "preconditioner from the tangent stiffness"),
  });
  return table.text();
}

const TableText& control_text() {
  static const Table<Nothing> table({
      line("target relative residual", "= <real> [DURING <period> ...]", "residual aimed at [1]"),
      line("acceptable relative residual", "= <real> [DURING <period> ...]", "residual put up with [1]"),
      line("target relative contact residual", "= <real> [DURING <period> ...]", "residual aimed at [1]"),
      line("acceptable relative contact residual", "= <real> [DURING <period> ...]",
           "residual put up with [1]"),
      line("minimum iterations", "= <integer> [DURING <period> ...]", "iterations at least [1]"),
      line("maximum iterations", "= <integer> [DURING <period> ...]", "iterations at most [1]"),
      line("level", "= <integer>", "level of the control loop [1]"),
      line("reference", "= {BELYTSCHKO|EXTERNAL|INTERNAL}", "force that residuals are compared with"),
  });
  return table.text();
}

const TableText& predictor_text() {
  static const Table<Nothing> table({
      line("type", "= {SCALE_FACTOR|SECANT} [DURING <period> ...]", "how the first guess is made"),
      line("scale factor", "= <real> [<real>] [DURING <period> ...]", "factor of the last increment [1]"),
  });
  return table.text();
}

}  // namespace

const TableText& solver_text() {
  static const Table<Nothing> table({
      inner("cg", conjugate_gradient_text, "nonlinear conjugate gradients"),
      inner("control contact", control_text, "loop over the contact constraints"),
      inner("control failure", control_text, "loop over failing elements"),
      inner("control stiffness", control_text, "loop over stiff materials"),
      inner("loadstep predictor", predictor_text, "first guess of a step"),
      line("level 1 predictor", "= <name>", "first guess of the outer loop"),
  });
  return table.text();
}

const TableText& adaptive_time_stepping_text() {
  static const Table<Nothing> table({
      line("method", "= <name>", "what the step adapts to"),
      line("cutback factor", "= <real>", "factor after a failed step [1]"),
      line("growth factor", "= <real>", "factor after an easy step [1]"),
      line("maximum failure cutbacks", "= <integer>", "cutbacks in a row [1]"),
      line("target iterations", "= <integer> [DURING <period> ...]", "iterations aimed at [1]"),
      line("iteration window", "= <integer>", "tolerance of the iterations aimed at [1]"),
      line("maximum multiplier", "= <real> [DURING <period> ...]", "largest step over the given one [1]"),
      line("minimum multiplier", "= <real> [DURING <period> ...]", "smallest step over the given one [1]"),
      line("active periods", "= <period> ...", "when the step adapts"),
  });
  return table.text();
}

const TableText& implicit_dynamics_text() {
  static const Table<Nothing> table({
      line("contact timestep", "= {ON|OFF}", "whether contact limits the step"),
      line("active periods", "= <period> ...", "when inertia is counted"),
      line("use hht integration", "", "time integration with numerical damping"),
      line("alpha", "= <real>", "damping of the time integration [1]"),
      line("beta", "= <real>", "parameter of the time integration [1]"),
      line("gamma", "= <real>", "parameter of the time integration [1]"),
  });
  return table.text();
}

const TableText& equation_solver_text() {
  static const Table<Nothing> table({
      line("maximum iterations", "= <integer>", "iterations at most [1]"),
      line("residual norm tolerance", "= <real>", "residual aimed at [1]"),
      line("maximum orthogonalization", "= <integer>", "directions kept [1]"),
      line("preconditioning method", "= <name>", "preconditioner"),
      line("local solver", "= <name>", "solver of a part"),
      line("coarse solver", "= <name>", "solver of the coarse problem"),
      line("print timers", "= {ON|OFF}", "times in the log"),
  });
  return table.text();
}

}  // namespace contactsim
