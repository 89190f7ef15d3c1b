// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/sierra_commands.hpp"

#include "parser/commands/function_commands.hpp"
#include "parser/commands/geometry_commands.hpp"
#include "parser/commands/implicit_commands.hpp"
#include "parser/commands/material_commands.hpp"
#include "parser/commands/model_commands.hpp"
#include "parser/commands/output_schedule_commands.hpp"
#include "parser/commands/procedure_commands.hpp"
#include "parser/commands/rigid_body_commands.hpp"
#include "parser/commands/row_lists.hpp"
#include "parser/commands/section_commands.hpp"

namespace contactsim {

namespace {

const Table<OutputScheduler>& output_scheduler_table() {
  static const Table<OutputScheduler> table(lift_all(output_schedule_rows(), &OutputScheduler::schedule));
  return table;
}

void read_restart_of_run(Arguments& arguments, SimulationDefinition& simulation) {
  static const Choices words({"automatic", "auto"});
  arguments.choice(words);
  simulation.restart.is_automatic = true;
}

std::vector<Row<SimulationDefinition>> run_rows() {
  return {
      row<SimulationDefinition>(
          "title", "<text>",
          [](Arguments& arguments, SimulationDefinition& simulation) { simulation.title = arguments.all(); },
          "Title of the run, the rest of the line", "none"),
      row<SimulationDefinition>("restart", "= {AUTOMATIC|AUTO}", read_restart_of_run,
                                "Goes on from the latest state of an earlier run", "none"),
      row<SimulationDefinition>(
          "restart time", "= <real>",
          [](Arguments& arguments, SimulationDefinition& simulation) {
            simulation.restart.time = arguments.real();
          },
          "Goes on from the state of an earlier run at this time [time]", "none")
          .once(),
  };
}

}  // namespace

std::vector<Row<SimulationDefinition>> definition_rows() {
  using K = NameKind;
  const std::vector<Row<SimulationDefinition>> blocks{
      block("function", Naming::required, function_table, &SimulationDefinition::functions,
            "A function of time, of place or of variables")
          .or_spelled("definition for function")
          .defines(K::function),
      block("material", Naming::required, material_table, &SimulationDefinition::materials,
            "A material: density and models")
          .or_spelled("property specification for material")
          .defines(K::material),
      block("rigid body", Naming::required, rigid_body_table, &SimulationDefinition::rigid_bodies,
            "A rigid body, which sections name")
          .defines(K::rigid_body),
      block("finite element model", Naming::required, finite_element_model_table,
            &SimulationDefinition::finite_element_models, "A mesh file and what its blocks are made of")
          .defines(K::finite_element_model),
      block("output scheduler", Naming::required, output_scheduler_table,
            &SimulationDefinition::output_schedulers, "Output times that several outputs share")
          .defines(K::output_scheduler),
  };
  return joined({geometry_rows(), blocks, lift_all(section_rows(), &SimulationDefinition::sections)});
}

const Table<SimulationDefinition>& sierra_table() {
  static const Table<SimulationDefinition> table(
      joined({definition_rows(), lift_all(procedure_rows(), &SimulationDefinition::procedures),
              implicit_sierra_rows(), run_rows()}));
  return table;
}

}  // namespace contactsim
