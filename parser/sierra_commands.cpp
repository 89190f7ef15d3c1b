// SPDX-License-Identifier: BSD-3-Clause
#include "parser/sierra_commands.hpp"

#include "parser/function_commands.hpp"
#include "parser/geometry_commands.hpp"
#include "parser/implicit_commands.hpp"
#include "parser/material_commands.hpp"
#include "parser/model_commands.hpp"
#include "parser/output_schedule_commands.hpp"
#include "parser/procedure_commands.hpp"
#include "parser/rigid_body_commands.hpp"
#include "parser/section_commands.hpp"

namespace contactsim {

namespace {

using S = SimulationDefinition;

const Table<OutputScheduler>& output_scheduler_table() {
  static const Table<OutputScheduler> table([] {
    std::vector<Row<OutputScheduler>> rows;
    add_lifted(output_schedule_rows(), &OutputScheduler::schedule, rows);
    return rows;
  }());
  return table;
}

void read_restart(Arguments& arguments, S& simulation) {
  static const std::vector<std::string> words{"automatic", "auto"};
  arguments.choice(words);
  simulation.restart.is_automatic = true;
}

std::vector<Row<S>> sierra_rows() {
  std::vector<Row<S>> rows = definition_rows();
  add_lifted(procedure_rows(), &S::procedures, rows);
  for (Row<S>& implicit : implicit_sierra_rows<S>()) rows.push_back(std::move(implicit));
  rows.push_back(row<S>(
      "title", "<text>", [](Arguments& arguments, S& simulation) { simulation.title = arguments.all(); },
      "Title of the run, the rest of the line", "none"));
  rows.push_back(row<S>("restart", "= {AUTOMATIC|AUTO}", read_restart,
                        "Goes on from the latest state of an earlier run", "none"));
  rows.push_back(row<S>(
                     "restart time", "= <real>",
                     [](Arguments& arguments, S& simulation) { simulation.restart.time = arguments.real(); },
                     "Goes on from the state of an earlier run at this time [time]", "none")
                     .once());
  return rows;
}

}  // namespace

std::vector<Row<S>> definition_rows() {
  std::vector<Row<S>> rows = geometry_rows();
  rows.push_back(held("function", block("function", Naming::required, function_table, &S::functions,
                                        "A function of time, of place or of variables"))
                     .or_spelled("definition for function"));
  rows.push_back(held("material", block("material", Naming::required, material_table, &S::materials,
                                        "A material: density and models"))
                     .or_spelled("property specification for material"));
  add_lifted(section_rows(), &S::sections, rows);
  rows.push_back(block("rigid body", Naming::required, rigid_body_table, &S::rigid_bodies,
                       "A rigid body, which sections name"));
  rows.push_back(block("finite element model", Naming::required, finite_element_model_table,
                       &S::finite_element_models, "A mesh file and what its blocks are made of"));
  rows.push_back(block("output scheduler", Naming::required, output_scheduler_table, &S::output_schedulers,
                       "Output times that several outputs share"));
  return rows;
}

const Table<SimulationDefinition>& sierra_table() {
  static const Table<S> table(sierra_rows());
  return table;
}

}  // namespace contactsim
