// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_part_commands.hpp"

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"
#include "parser/commands/death_commands.hpp"
#include "parser/commands/entity_set_commands.hpp"
#include "parser/commands/implicit_commands.hpp"
#include "parser/commands/variable_readers.hpp"

namespace contactsim {

namespace {

const Table<MassProperties>& mass_properties_table() {
  using M = MassProperties;
  static const Table<M> table(joined<M>({
      lift_all(entity_set_rows(), &M::set),
      {row("structure name", read::text, &M::structure_name, "What the report calls the set",
           "the block's name")},
  }));
  return table;
}

const Table<SpotWeld>& spot_weld_table() {
  static const Choice one_force{"has no DISPLACEMENT FUNCTION, normal or tangential", ""};
  using W = SpotWeld;
  static const Table<W> table(joined<W>({
      {
          row("node set", read::names_of(NameKind::node_set), &W::node_sets, "Node sets of the welded nodes")
              .or_spelled("nodeset")
              .required(),
          row("surface", read::names_of(NameKind::side_set), &W::side_sets,
              "Side sets that the nodes are welded to")
              .or_spelled("side set")
              .or_spelled("sideset")
              .required(),
      },
      scaled_function_rows("normal displacement", &W::normal, "of opening [length]: the normal force [force]",
                           one_force),
      scaled_function_rows("tangential displacement", &W::tangential,
                           "of slip [length]: the tangential force [force]", one_force),
      {
          row("failure envelope exponent", read::positive, &W::envelope_exponent,
              "Exponent p of the failure envelope (normal part)^p + (tangential part)^p = 1 [1]"),
          row("failure decay cycles", read::positive_integer, &W::decay_cycles,
              "Steps [1] over which the force fades after failure"),
          row("failure function", read::name_of(NameKind::function), &W::failure_function,
              "Failure envelope as a function [1]"),
          row("ignore initial offsets", read::on_off, &W::ignores_initial_offsets,
              "Takes the gap at the start as no displacement"),
      },
  }));
  return table;
}

const Table<MassScaling>& mass_scaling_table() {
  using M = MassScaling;
  static const Table<M> table(joined<M>({
      lift_all(entity_set_rows(must_pick_parts), &M::set),
      {
          row("target time step", read::positive, &M::target_time_step,
              "Stable step, before its scale factor, that every element shall allow at the start [time]")
              .required(),
          row("allowable mass increase ratio", read::positive, &M::allowable_mass_increase,
              "Most times that an element may become as heavy [1]", "no bound"),
      },
  }));
  return table;
}

void read_termination(Arguments& arguments, SolutionTermination& termination) {
  using R = NodalCriterion::Reduction;
  static const Choices locations({"global", "nodal", "node", "element"});
  static constexpr VariableLocation meanings[] = {VariableLocation::global, VariableLocation::nodal,
                                                  VariableLocation::nodal, VariableLocation::element};
  TerminationCriterion criterion;
  criterion.location = meanings[arguments.choice(locations)];
  if (criterion.location != VariableLocation::global) {
    if (arguments.accept("avg")) criterion.reduction = R::average;
    if (arguments.accept("max")) criterion.reduction = R::maximum;
    if (arguments.accept("min")) criterion.reduction = R::minimum;
  }
  criterion.test = read_variable_test(arguments);
  termination.criteria.push_back(std::move(criterion));
}

void read_skipped_times(Arguments& arguments, SolutionTermination& termination) {
  TimeRange range{arguments.real(), 0.0};
  arguments.expect("to");
  range.to = arguments.real();
  if (range.to < range.from) arguments.fail_here("the second of the skipped times lies before the first");
  termination.skipped_times.push_back(range);
}

const Table<SolutionTermination>& termination_table() {
  using T = SolutionTermination;
  static const auto scope = choice_of<T::Scope>({"entire_run", "procedure"});
  static const Table<T> table({
      row<T>("terminate", "{GLOBAL|{NODAL|ELEMENT} [{AVG|MAX|MIN}]} <variable> {<|<=|=|>=|>} <real>",
             read_termination, "Ends the run when it holds, in the variable's dimension; any of several",
             "none"),
      row<T>("skip times", "= <from> TO <to>", read_skipped_times,
             "Times between which nothing is looked at [time]", "none"),
      row("terminate type", scope, &T::scope, "What ends"),
  });
  return table;
}

std::vector<Row<Region>> unsupported_rows() {
  using R = Region;
  const std::string estimate = "The element-based estimate of the time step is used, which is safe";
  return {
      ignored_block<R>("node based time step parameters", estimate),
      ignored_block<R>("lanczos parameters", estimate),
      ignored_block<R>("power method parameters", estimate),
      ignored_block<R>("rebalance", "Of parallel runs only"),
      refused_block<R>("line weld", "SPOT WELD joins nodes to faces"),
      refused_block<R>("mpc", "Constraints between nodes are not supported; a TIED MODEL joins surfaces"),
      refused_block<R>("tied joint", "A TIED MODEL joins surfaces"),
      refused_block<R>("submodel", "Submodels are not supported"),
      refused_block<R>("torsional spring mechanism", "Mechanisms are not supported"),
  };
}

}  // namespace

std::vector<Row<Region>> region_part_rows() {
  using R = Region;
  return joined<R>({
      {
          block<R, ElementDeath>("element death", Naming::optional, element_death_table, &R::element_deaths,
                                 "Elements that die, and when"),
          block<R, SolutionTermination>("solution termination", Naming::optional, termination_table,
                                        &R::terminations, "When the run ends before its termination time"),
          block<R, MassProperties>("mass properties", Naming::optional, mass_properties_table,
                                   &R::mass_properties, "Reports mass, centre and inertia"),
          block<R, SpotWeld>("spot weld", Naming::optional, spot_weld_table, &R::spot_welds,
                             "Springs between nodes and faces that can fail"),
          block<R, MassScaling>("mass scaling", Naming::optional, mass_scaling_table, &R::mass_scalings,
                                "Adds mass to elements for a larger time step"),
          row("subcycle blocks", read::names_of_or_all(NameKind::block), &R::subcycle_blocks,
              "Blocks of small elements, advanced in parts of the steps that all others allow; ALL: what "
              "sizes "
              "say",
              "none"),
      },
      unsupported_rows(),
      implicit_region_rows(),
  });
}

}  // namespace contactsim
