// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/planned_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/definition/simulation.hpp"
#include "core/mesh/block_names.hpp"
#include "core/output/single_values.hpp"

namespace contactsim {

namespace {

constexpr std::int64_t ends_only = 0, every_step = 1;  // defaults of OutputTimes

bool has_lines(const OutputSchedule& schedule) {
  return !schedule.time_phases.empty() || !schedule.step_phases.empty() ||
         !schedule.additional_times.empty() || !schedule.additional_steps.empty();
}

/// That of the file, else that of the deck: of its TITLE, else behind BEGIN SIERRA.
std::string title_of(const SimulationDefinition& definition, const OutputDatabase& database) {
  if (!database.title.empty()) return database.title;
  return definition.title.empty() ? definition.name.text : definition.title;
}

ResultsFile make_file(const ConditionScope& scope, const OutputDatabase& database, bool has_mesh) {
  const std::string name = database.name ? database.name->text : has_mesh ? "%B.e" : "%B.h";
  return {expand_file_name(scope.definition, name), database.overwrites, has_mesh,
          title_of(scope.definition, database)};
}

OutputSchedule find_schedule(const ConditionScope& scope, const OutputSchedule& schedule) {
  return resolve_schedule(schedule, scope.definition.output_schedulers, scope.diagnostics);
}

std::vector<std::vector<std::string>> names_of_blocks(const ConditionScope& scope) {
  const FiniteElementModel* elements = find_finite_element_model(scope.definition, scope.region);
  if (elements == nullptr) return find_block_names(scope.mesh, {});
  return find_block_names(scope.mesh, elements->aliases);
}

}  // namespace

bool goes_to_log(const HeartbeatOutput& output) {
  constexpr std::array names{"cout", "stdout", "cerr", "stderr", "clog", "log", "output", "outputp0"};
  const std::string folded = output.stream ? fold(output.stream->text) : "";
  return std::find(names.begin(), names.end(), folded) != names.end();
}

ResultsOutput make_default_results() {
  ResultsOutput output;
  for (const char* name : {"displacement", "velocity"})
    output.variables.push_back({VariableLocation::nodal, {{name, {}}, "", {}}, "", {}});
  for (const char* name : {"stress", "von_mises"})
    output.variables.push_back({VariableLocation::element, {{name, {}}, "", {}}, "", {}});
  return output;
}

PlannedResults plan_results(const ConditionScope& scope, const ResultsOutput& output,
                            const std::optional<std::string>& path, const OutputVariables& variables) {
  ResultsFile file = make_file(scope, output.database, true);
  if (path) file.path = *path;
  if (output.mesh != ResultsOutput::OutputMesh::unrefined || !output.included.empty() ||
      !output.excluded.empty()) {
    scope.diagnostics.add_warning("output-mesh-whole", output.name.location,
                                  "the file holds the whole mesh as it was read",
                                  "INCLUDE and EXCLUDE choose the blocks of element variables");
  }
  const OutputSchedule schedule = find_schedule(scope, output.schedule);
  if (!has_lines(schedule)) {
    scope.diagnostics.add_warning(
        "output-schedule-missing", output.name.location,
        fmt::format("only the first and the last state are written to {}", file.path),
        "AT TIME <start> INCREMENT = <increment> asks for more");
  }
  const FieldRequests requests{output.variables, output.included, output.excluded,
                               output.database.component_separator};
  return {std::move(file), OutputTimes(schedule, ends_only),
          make_requested_fields(variables, requests, names_of_blocks(scope), scope.diagnostics)};
}

PlannedResults plan_history(const ConditionScope& scope, const HistoryOutput& output,
                            const OutputVariables& variables) {
  return {make_file(scope, output.database, false),
          OutputTimes(find_schedule(scope, output.schedule), every_step),
          make_single_values(variables, output.variables, output.database.component_separator,
                             scope.diagnostics)};
}

PlannedHeartbeat plan_heartbeat(const ConditionScope& scope, const HeartbeatOutput& output,
                                const OutputVariables& variables) {
  const std::string path = expand_file_name(scope.definition, output.stream ? output.stream->text : "%B.csv");
  const OutputSchedule schedule = find_schedule(scope, output.schedule);
  if (output.has_units && output.format == HeartbeatOutput::Format::spyhis) {
    scope.diagnostics.add_warning("units-line-left-out", output.name.location,
                                  "UNITS LINE does nothing here: programs read SPYHIS by its form");
  }
  PlannedHeartbeat plan{{goes_to_log(output) ? "" : path, output, {}},
                        has_lines(schedule),
                        OutputTimes(schedule, every_step),
                        make_single_values(variables, output.variables, "_", scope.diagnostics)};
  plan.file.dimensions = value_dimensions(plan.values);
  return plan;
}

}  // namespace contactsim
