// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/procedure_commands.hpp"

#include <fmt/format.h>

#include "parser/commands/block_rows.hpp"
#include "parser/commands/region_commands.hpp"
#include "parser/commands/row_lists.hpp"
#include "parser/commands/time_commands.hpp"

namespace contactsim {

namespace {

using Procedures = std::vector<Procedure>;

const Table<ProceduralTransfer>& transfer_table() {
  using E = EntitySet;
  static const Choice must_take_blocks{"takes over the state of no block", ""};
  static const Table<ProceduralTransfer> table(lift_all(
      joined<E>(
          {one_of<E>(
               must_take_blocks,
               {flag("include all blocks", &E::includes_all_blocks, "Takes over the state of every block"),
                row("block", read::names_of(NameKind::block), &E::blocks,
                    "Blocks whose state is taken over: stresses, what materials remember, motion")}),
           {row("remove block", read::names_of(NameKind::block), &E::removed_blocks,
                "Blocks that start from the mesh all the same")}}),
      &ProceduralTransfer::set));
  return table;
}

void set_time_control(Procedure& procedure, TimeControl control) {
  if (procedure.time_control) {
    throw ArgumentError{{Severity::error, "", control.name.location, 1,
                         "a second TIME CONTROL in one procedure",
                         "the first stands at " + to_string(procedure.time_control->name.location)}};
  }
  procedure.time_control = std::move(control);
}

enum class Solution { explicit_dynamics, implicit_statics, as_time_parameters_say };

void add_region(Procedure& procedure, Region region, Solution solution) {
  if (solution == Solution::implicit_statics && !procedure.implicit_by) {
    procedure.implicit_by =
        ImplicitCause{fmt::format("adagio region '{}'", region.name.text), region.name.location};
  }
  procedure.regions.push_back(std::move(region));
}

Row<Procedure> region_row(std::string_view phrase, Solution solution, std::string_view help) {
  return block<Procedure, Region>(
             phrase, Naming::required, region_table,
             [solution](Procedure& procedure, Region region) {
               add_region(procedure, std::move(region), solution);
             },
             help)
      .defines(NameKind::region);
}

const Table<Procedure>& procedure_table() {
  static const Table<Procedure> table({
      block<Procedure, TimeControl>("time control", Naming::optional, time_control_table, set_time_control,
                                    "When the procedure begins and ends, and its time steps"),
      block("procedural transfer", Naming::optional, transfer_table, &Procedure::transfers,
            "Takes the state over from the procedure before"),
      region_row("presto region", Solution::explicit_dynamics, "A model in explicit dynamics"),
      region_row("adagio region", Solution::implicit_statics, "A model in implicit statics"),
      region_row("solid mechanics region", Solution::as_time_parameters_say,
                 "A model; implicit if it has PARAMETERS FOR ADAGIO REGION"),
      refused_block<Procedure>("solution control description",
                               "give the times of the region in a TIME CONTROL block instead"),
      refused_block<Procedure>("aria region", "only solid mechanics is solved; take the thermal region out"),
      refused_block<Procedure>("transfer", "only one region is solved; take the transfer out"),
  });
  return table;
}

/// The first PARAMETERS FOR ADAGIO REGION of the time control.
std::optional<ImplicitCause> find_implicit_parameters(const Procedure& procedure) {
  if (!procedure.time_control) return std::nullopt;
  for (const TimeSteppingBlock& block : procedure.time_control->time_stepping_blocks) {
    if (block.implicit_parameters.empty()) continue;
    const DeckName& region = block.implicit_parameters.front().name;
    return ImplicitCause{fmt::format("parameters for adagio region '{}'", region.text), region.location};
  }
  return std::nullopt;
}

void add_procedure(Procedures& procedures, Procedure procedure, Solution solution) {
  if (solution == Solution::implicit_statics) {
    procedure.implicit_by =
        ImplicitCause{fmt::format("adagio procedure '{}'", procedure.name.text), procedure.name.location};
  } else if (!procedure.implicit_by) {
    procedure.implicit_by = find_implicit_parameters(procedure);
  }
  for (Region& region : procedure.regions) {
    if (region.contact) region.contact->enforcement.is_static = procedure.implicit_by.has_value();
  }
  procedures.push_back(std::move(procedure));
}

Row<Procedures> procedure_row(std::string_view phrase, Solution solution, std::string_view help) {
  return block<Procedures, Procedure>(
             phrase, Naming::optional, procedure_table,
             [solution](Procedures& procedures, Procedure procedure) {
               add_procedure(procedures, std::move(procedure), solution);
             },
             help)
      .defines(NameKind::procedure);
}

}  // namespace

std::vector<Row<std::vector<Procedure>>> procedure_rows() {
  return {
      procedure_row("presto procedure", Solution::explicit_dynamics, "Explicit dynamics"),
      procedure_row("adagio procedure", Solution::implicit_statics,
                    "Quasi-static: equilibrium step by step, without inertia and contact"),
      procedure_row("solid mechanics procedure", Solution::as_time_parameters_say,
                    "Explicit or implicit, as its time parameters say"),
      procedure_row("procedure", Solution::as_time_parameters_say, "The same, as coupled runs spell it"),
  };
}

}  // namespace contactsim
