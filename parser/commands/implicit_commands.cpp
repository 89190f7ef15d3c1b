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

/// A command with one value for all time stepping blocks, or DURING some.
template <class T, class V, class F>
Row<T> during_row(std::string_view phrase, const Reader<V>& reader, F T::*field, std::string_view help,
                  std::string_view default_text = "") {
  Row<T> made = row(phrase, reader, field, help, default_text);
  made.text.syntax += " [DURING <time stepping block> ...]";
  made.text.is_single = false;
  made.text.references.push_back(NameKind::time_stepping_block);
  made.read_command = [read_value = reader.read, field](Arguments& arguments, T& target) {
    const V value = read_value(arguments);
    if (!arguments.accept("during")) return store(value, target.*field);
    for (DeckName& period : arguments.references(NameKind::time_stepping_block))
      target.during.push_back({std::move(period), [value, field](T& settings) { settings.*field = value; }});
  };
  return made;
}

/// A positive number below 1.
Reader<double> cutback() {
  Reader<double> reader = read::positive;
  reader.read = [](Arguments& arguments) {
    if (arguments.at_end()) return arguments.positive();
    const Word& word = arguments.peek();
    const double value = arguments.positive();
    if (!(value < 1.0)) arguments.fail(word, "the factor must be below 1");
    return value;
  };
  return reader;
}

/// The solvers of Sierra/SM stand for the choice of contactsim.
void read_linear_solver(Arguments& arguments, FullTangentSettings& full) {
  static const Choices words({"auto", "amg", "direct", "distributed", "feti", "gdsw", "tpetra"});
  const Word& word = arguments.peek();
  const std::size_t choice = arguments.choice(words);
  if (choice == 1) full.linear_solver = LinearSolver::multigrid;
  if (choice == 2) full.linear_solver = LinearSolver::direct;
  if (choice == 3) full.linear_solver = LinearSolver::distributed;
  if (choice > 3)
    arguments.warn("deck-ignored", word,
                   "the equation solver is one of contactsim's own, chosen by the model",
                   "LINEAR SOLVER = AUTO says so; AMG and DIRECT choose");
}

const Table<FullTangentSettings>& full_tangent_table() {
  using F = FullTangentSettings;
  const std::string_view when =
      "it is made anew in each step, and where an iteration leaves more than a tenth";
  const std::string_view own = "the equation solvers that there are do without";
  static const Table<F> table({
      row("tangent diagonal scale", read::non_negative, &F::tangent_diagonal_scale,
          "Share of the diagonal that is added to the stiffness, for bodies that nothing holds yet [1]"),
      ignored<F>("iteration update", "= <integer>", when),
      ignored<F>("small number of iterations", "= <integer>", when),
      ignored<F>("maximum updates for modelproblem", "= <integer>", when),
      ignored<F>("step update", "= <integer>", when),
      row<F>(
          "linear solver", "= {AUTO|AMG|DIRECT|DISTRIBUTED|FETI|GDSW|TPETRA}", read_linear_solver,
          "Equation solver: AMG is multigrid, for large solids; DIRECT a sparse factor; AUTO the sooner one; "
          "DISTRIBUTED a factor whose memory ranks divide, with results that agree to the target of forces, "
          "not to the byte",
          "AUTO"),
      ignored<F>("nodal probe factor", "= <real>", "probes are a millionth of the distance between nodes"),
      ignored<F>("constraint enforcement", "= <method>", own),
      ignored<F>("minimum smoothing iterations", "= <integer>", own),
      ignored<F>("maximum smoothing iterations", "= <integer>", own),
      ignored<F>("adaptive strategy", "= <name>", own),
      ignored<F>("conditioning", "= <name>", own),
  });
  return table;
}

/// ELASTIC, BLOCK and the like: all of them stand for nodal blocks here.
void read_preconditioner(Arguments& arguments, CgSettings&) {
  static const Choices nodal({"block", "probe", "elastic", "diagonal", "tangent", "schur", "identity"});
  const Word& word = arguments.peek();
  if (arguments.choice(nodal) > 1)
    arguments.warn("deck-ignored", word, "the stiffness of each node, by probes, is used in its place",
                   "PRECONDITIONER = PROBE says so");
}

void read_line_search(Arguments& arguments, CgSettings& cg) {
  arguments.expect("secant");
  if (!arguments.at_end()) cg.line_search_tolerance = arguments.positive();
}

const Table<CgSettings>& cg_table() {
  using C = CgSettings;
  static const auto reference = choice_of<ResidualReference>({"external", "internal", "belytschko"});
  static const Table<C> table({
      during_row("target relative residual", read::positive, &C::target_relative_residual,
                 "Forces left over, of the reference, that end a search [1]"),
      during_row("target residual", read::positive, &C::target_residual,
                 "Forces left over that end a search [force]"),
      during_row("acceptable relative residual", read::positive, &C::acceptable_relative_residual,
                 "What is put up with after the last iteration, of the reference [1]", "10 times the target"),
      during_row("acceptable residual", read::positive, &C::acceptable_residual,
                 "What is put up with after the last iteration [force]"),
      during_row("minimum iterations", read::non_negative_integer, &C::min_iterations,
                 "Iterations of a search at least [1]"),
      during_row("maximum iterations", read::positive_integer, &C::max_iterations,
                 "Iterations of a search at most [1]", "100 with a full tangent, else nodes, at least 1000"),
      row("reference", reference, &C::reference,
          "What forces left over are compared with: loads and reactions, forces of elements, or the largest"),
      row<C>("line search", "SECANT [<tolerance>]", read_line_search,
             "Search along a direction, until so much of the slope is left [1]", "SECANT 0.01"),
      row<C>("preconditioner", "= {PROBE|BLOCK|ELASTIC|DIAGONAL|TANGENT|SCHUR|IDENTITY}", read_preconditioner,
             "Nodal preconditioner: the stiffness of each node", "PROBE"),
      block<C, FullTangentSettings>(
          "full tangent preconditioner", Naming::optional, full_tangent_table,
          [](C& cg, FullTangentSettings full) { cg.full_tangent = std::move(full); },
          "The whole stiffness in place of that of each node: for slender, thin and large bodies"),
      ignored<C>("iteration print", "= <integer>", "the log has a line for every step"),
  });
  return table;
}

const Table<ControlContact>& control_contact_table() {
  using C = ControlContact;
  const std::string_view one = "what the multipliers still change contact forces by is the one measure";
  static const Table<C> table({
      during_row("target relative residual", read::positive, &C::target_relative_residual,
                 "Change of contact forces by their multipliers that ends a step, of these forces [1]"),
      during_row("acceptable relative residual", read::positive, &C::acceptable_relative_residual,
                 "What is put up with after the last iteration [1]", "10 times the target"),
      during_row("maximum iterations", read::non_negative_integer, &C::max_iterations,
                 "Updates of the multipliers in a step at most; 0: the penalty alone [1]"),
      during_row("minimum iterations", read::non_negative_integer, &C::min_iterations,
                 "Updates of the multipliers in a step at least [1]"),
      ignored<C>("target relative contact residual", "= <real> [DURING <period> ...]", one),
      ignored<C>("acceptable relative contact residual", "= <real> [DURING <period> ...]", one),
      ignored<C>("level", "= <integer>", "contact is the one level"),
      ignored<C>("reference", "= {BELYTSCHKO|EXTERNAL|INTERNAL}", one),
  });
  return table;
}

const Table<ControlFailure>& control_failure_table() {
  using C = ControlFailure;
  static const Table<C> table({
      during_row("maximum iterations", read::non_negative_integer, &C::max_iterations,
                 "Searches for equilibrium after deaths in a step at most; 0: the next step finds it [1]"),
      ignored<C>("level", "= <integer>", "failure is the outermost level"),
      ignored<C>("iteration plot", "= <integer> [DURING <period> ...]", "results are those of whole steps"),
      ignored<C>("iteration plot output blocks", "= <block> ...", "results are those of whole steps"),
  });
  return table;
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

void read_scale_factors(Arguments& arguments, LoadstepPredictor& predictor) {
  predictor.scale_factor = arguments.non_negative();
  if (!arguments.at_end()) predictor.first_scale_factor = arguments.non_negative();
}

const Table<LoadstepPredictor>& predictor_table() {
  using P = LoadstepPredictor;
  static const auto type = choice_of<P::Type>({"secant", "scale_factor"});
  static const Table<P> table({
      row("type", type, &P::type, "Where the search of a step begins: from the increment of the last one"),
      row<P>("scale factor", "= <real> [<first>]", read_scale_factors,
             "Factor of the last increment, and that of the first step of a period [1]", "1"),
  });
  return table;
}

const Table<SolverSettings>& solver_table() {
  using S = SolverSettings;
  static const Table<S> table({
      block<S, CgSettings>(
          "cg", Naming::optional, cg_table, [](S& solver, CgSettings cg) { solver.cg = std::move(cg); },
          "Nonlinear conjugate gradients"),
      block<S, LoadstepPredictor>(
          "loadstep predictor", Naming::optional, predictor_table,
          [](S& solver, LoadstepPredictor predictor) { solver.predictor = std::move(predictor); },
          "First guess of a step"),
      block<S, ControlContact>(
          "control contact", Naming::optional, control_contact_table,
          [](S& solver, ControlContact control) { solver.control_contact = std::move(control); },
          "How exactly contact holds: updates of its multipliers in each step"),
      block<S, ControlFailure>(
          "control failure", Naming::optional, control_failure_table,
          [](S& solver, ControlFailure control) { solver.control_failure = std::move(control); },
          "Equilibrium is sought anew in the step in which elements have died"),
      ignored_block<S>("control stiffness", control_text, "all stiffness acts from the first iteration on"),
      ignored<S>("level 1 predictor", "= <name>", "there is one level"),
  });
  return table;
}

const Table<AdaptiveTimeStepping>& adaptive_time_stepping_table() {
  using A = AdaptiveTimeStepping;
  static const Table<A> table({
      row("cutback factor", cutback(), &A::cutback_factor,
          "Factor of the step where no equilibrium is found [1]"),
      row("growth factor", read::positive, &A::growth_factor, "Factor of the step after an easy one [1]"),
      row("maximum failure cutbacks", read::non_negative_integer, &A::max_failure_cutbacks,
          "Cutbacks in a row at most [1]"),
      during_row("target iterations", read::non_negative_integer, &A::target_iterations,
                 "A step of fewer iterations is easy, one of more has smaller ones follow [1]",
                 "every step is easy"),
      row("iteration window", read::non_negative_integer, &A::iteration_window,
          "Iterations around the target that leave the step as it is [1]"),
      during_row("maximum multiplier", read::positive, &A::max_multiplier,
                 "Largest step over the one of the deck [1]", "no bound"),
      during_row("minimum multiplier", read::positive, &A::min_multiplier,
                 "Smallest step over the one of the deck [1]"),
      ignored<A>("method", "= <name>", "iterations are what the step adapts to"),
      refused<A>("active periods", "= <period> ...", "Steps adapt in all time stepping blocks"),
  });
  return table;
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

}  // namespace

std::vector<Row<Region>> implicit_region_rows() {
  using R = Region;
  return {
      block<R, SolverSettings>(
          "solver", Naming::optional, solver_table,
          [](R& region, SolverSettings solver) { region.solver = std::move(solver); },
          "Implicit only: how equilibrium is found"),
      block<R, AdaptiveTimeStepping>(
          "adaptive time stepping", Naming::optional, adaptive_time_stepping_table,
          [](R& region, AdaptiveTimeStepping adaption) {
            region.adaptive_time_stepping = std::move(adaption);
          },
          "Implicit only: how load steps adapt"),
      refused_block<R>("implicit dynamics", "Inertia takes part in explicit procedures alone"),
  };
}

std::vector<Row<SimulationDefinition>> implicit_sierra_rows() {
  constexpr const char* help =
      "implicit only: linear equation solver, in whose place is one of contactsim's own";
  using S = SimulationDefinition;
  return {
      ignored_block<S>("feti equation solver", equation_solver_text, help),
      ignored_block<S>("gdsw equation solver", equation_solver_text, help),
      ignored_block<S>("tpetra equation solver", equation_solver_text, help),
  };
}

}  // namespace contactsim
