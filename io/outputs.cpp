// SPDX-License-Identifier: BSD-3-Clause
#include "io/outputs.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <utility>

#include "core/base/errors.hpp"
#include "core/base/version.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/block_names.hpp"
#include "core/output/single_values.hpp"

namespace contactsim {

namespace {

// Adds the problem of an output at its block of the deck.
void warn(Diagnostics& diagnostics, std::string_view id, const DeckName& output, std::string text,
          std::string hint = "") {
  diagnostics.add_warning(id, output.location, std::move(text), std::move(hint));
}

bool has_lines(const OutputSchedule& schedule) {
  return !schedule.time_phases.empty() || !schedule.step_phases.empty() ||
         !schedule.additional_times.empty() || !schedule.additional_steps.empty();
}

bool is_log(const std::string& stream) {
  constexpr std::array names{"cout", "stdout", "cerr", "stderr", "clog", "log", "output", "outputp0"};
  const std::string folded = fold(stream);
  return std::find(names.begin(), names.end(), folded) != names.end();
}

std::string format_clock(std::time_t time, const char* format) {
  std::array<char, 32> text{};
  std::tm local{};
  localtime_r(&time, &local);
  const std::size_t n = std::strftime(text.data(), text.size(), format, &local);
  return {text.data(), n};
}

// The results of a run that is asked for a file by the command line alone.
ResultsOutput make_default_results() {
  ResultsOutput output;
  for (const char* name : {"displacement", "velocity"})
    output.variables.push_back({VariableLocation::nodal, {{name, {}}, "", {}}, "", {}});
  for (const char* name : {"stress", "von_mises"})
    output.variables.push_back({VariableLocation::element, {{name, {}}, "", {}}, "", {}});
  return output;
}

void check_clashes(const std::vector<std::string>& paths, const DeckName& region, Diagnostics& diagnostics) {
  std::map<std::filesystem::path, int> n_uses;
  for (const std::string& path : paths) {
    if (++n_uses[std::filesystem::path(path).lexically_normal()] != 2) continue;
    diagnostics.add_error(region.location, fmt::format("two outputs would write {}", path),
                          "DATABASE NAME or STREAM NAME gives each its own file");
  }
}

}  // namespace

Outputs::Outputs(const ConditionScope& scope, const Model& model, OutputSettings settings)
    : model_(model),
      rigid_part_(model),
      variables_(model, std::move(settings.variables)),
      user_outputs_(scope, variables_),
      terminations_(scope.region.terminations, variables_, scope.diagnostics),
      settings_(std::move(settings)) {
  const FiniteElementModel* elements = find_finite_element_model(scope.definition, scope.region);
  const std::span<const MeshAlias> aliases =
      elements ? std::span<const MeshAlias>(elements->aliases) : std::span<const MeshAlias>();
  block_names_ = find_block_names(*model.mesh, aliases);
  std::optional<std::string> path = settings_.results_path;
  for (const ResultsOutput& output : scope.region.results_outputs)
    add_results(scope, output, std::exchange(path, std::nullopt));
  if (path) add_results(scope, make_default_results(), path);
  for (const HistoryOutput& output : scope.region.history_outputs) add_history(scope, output);
  for (const HeartbeatOutput& output : scope.region.heartbeat_outputs) add_heartbeat(scope, output);
  check_clashes(paths(), scope.region.name, scope.diagnostics);
}

void Outputs::add_results(const ConditionScope& scope, const ResultsOutput& output,
                          std::optional<std::string> path) {
  const SimulationDefinition& definition = scope.definition;
  Diagnostics& diagnostics = scope.diagnostics;
  const OutputDatabase& database = output.database;
  if (!path) path = expand_file_name(definition, database.name ? database.name->text : "%B.e");
  if (output.mesh != ResultsOutput::OutputMesh::unrefined || !output.included.empty() ||
      !output.excluded.empty()) {
    warn(diagnostics, "output-mesh-whole", output.name, "the file holds the whole mesh as it was read",
         "INCLUDE and EXCLUDE choose the blocks of element variables");
  }
  const OutputSchedule schedule =
      resolve_schedule(output.schedule, definition.output_schedulers, diagnostics);
  if (!has_lines(schedule)) {
    warn(diagnostics, "output-schedule-missing", output.name,
         fmt::format("only the first and the last state are written to {}", *path),
         "AT TIME <start> INCREMENT = <increment> asks for more");
  }
  const FieldRequests requests{output.variables, output.included, output.excluded,
                               database.component_separator};
  constexpr std::int64_t ends_only = 0;
  exodus_.push_back({*path,
                     database.overwrites,
                     true,
                     database.title.empty() ? definition.title : database.title,
                     OutputTimes(schedule, ends_only),
                     make_requested_fields(variables_, requests, block_names_, diagnostics),
                     {},
                     nullptr});
}

void Outputs::add_history(const ConditionScope& scope, const HistoryOutput& output) {
  const SimulationDefinition& definition = scope.definition;
  Diagnostics& diagnostics = scope.diagnostics;
  const OutputDatabase& database = output.database;
  const OutputSchedule schedule =
      resolve_schedule(output.schedule, definition.output_schedulers, diagnostics);
  constexpr std::int64_t every_step = 1;
  exodus_.push_back(
      {expand_file_name(definition, database.name ? database.name->text : "%B.h"),
       database.overwrites,
       false,
       database.title.empty() ? definition.title : database.title,
       OutputTimes(schedule, every_step),
       make_single_values(variables_, output.variables, database.component_separator, diagnostics),
       {},
       nullptr});
}

void Outputs::add_heartbeat(const ConditionScope& scope, const HeartbeatOutput& output) {
  const SimulationDefinition& definition = scope.definition;
  Diagnostics& diagnostics = scope.diagnostics;
  const std::string path = expand_file_name(definition, output.stream ? output.stream->text : "%B.csv");
  const OutputSchedule schedule =
      resolve_schedule(output.schedule, definition.output_schedulers, diagnostics);
  constexpr std::int64_t every_step = 1;
  heartbeats_.push_back({is_log(path) ? "" : path, output.appends, output.monitored, has_lines(schedule),
                         OutputTimes(schedule, every_step),
                         make_single_values(variables_, output.variables, "_", diagnostics),
                         heartbeat_style(output), std::nullopt});
}

std::vector<std::string> Outputs::paths() const {
  std::vector<std::string> paths;
  for (const ExodusJob& job : exodus_) paths.push_back(job.path);
  for (const HeartbeatJob& job : heartbeats_) {
    if (!job.path.empty()) paths.push_back(job.path);
  }
  return paths;
}

void Outputs::add_suffix(const std::string& suffix) {
  for (ExodusJob& job : exodus_) job.path += suffix;
  for (HeartbeatJob& job : heartbeats_) {
    if (!job.path.empty() && !job.appends) job.path += suffix;
  }
}

std::vector<StepTarget> Outputs::step_targets() const {
  std::vector<StepTarget> targets;
  const auto add = [&](const OutputTimes& times) {
    if (!times.adjustment_interval()) return;
    targets.push_back({[times](double time) { return times.next_time(time); }, *times.adjustment_interval()});
  };
  for (const ExodusJob& job : exodus_) add(job.times);
  for (const HeartbeatJob& job : heartbeats_) add(job.times);
  return targets;
}

ResultsText Outputs::make_text(const std::string& title) const {
  const Mesh& mesh = *model_.mesh;
  ResultsText text;
  text.title = title;
  if (!mesh.path().empty()) text.qa_records = read_qa_records(mesh.path());
  const std::time_t now = settings_.clock();
  text.qa_records.push_back(
      {"contactsim", version, format_clock(now, "%m/%d/%Y"), format_clock(now, "%H:%M:%S")});
  text.info.push_back(settings_.command_line);
  text.info.insert(text.info.end(), settings_.deck_lines.begin(), settings_.deck_lines.end());
  return text;
}

void Outputs::open_files() {
  const Mesh no_mesh, mesh = rigid_part_.on(model_.mesh->with_side_sets(settings_.side_sets));
  const auto open = [&](ExodusJob& job) {
    std::error_code ignored;
    if (!job.overwrites && std::filesystem::exists(job.path, ignored))
      throw FileError(job.path, "exists, and the deck says OVERWRITE = OFF");
    job.defined = job.fields.fields();
    job.writer = std::make_unique<ResultsWriter>(job.path, job.has_mesh ? mesh : no_mesh,
                                                 make_text(job.title), job.defined);
  };
  for (ExodusJob& job : exodus_) open(job);
  for (HeartbeatJob& job : heartbeats_) {
    std::error_code ignored;
    const bool continues = job.appends && std::filesystem::file_size(job.path, ignored) > 0 && !ignored;
    if (continues && job.style.format != HeartbeatOutput::Format::spyhis) job.style.has_legend = false;
    job.writer.emplace(job.path.empty() ? settings_.log : make_file_sink(job.path, job.appends), job.style,
                       value_names(job.values), settings_.clock);
  }
}

std::optional<std::string> Outputs::check_termination(const State& state) {
  const OutputContext context{model_, state};
  user_outputs_.compute(context, !terminations_.is_empty() || settings_.always_computes);
  return terminations_.find_reason(context);
}

bool Outputs::find_due(const OutputTime& now) {
  bool has_results = false, has_history = false, is_any = false;
  for (ExodusJob& job : exodus_) {
    job.is_due = job.times.is_due(now);
    (job.has_mesh ? has_results : has_history) |= job.is_due;
    is_any |= job.is_due;
  }
  using Monitored = HeartbeatOutput::Monitored;
  for (HeartbeatJob& job : heartbeats_) {
    job.is_due = job.times.is_due(now) && (job.has_schedule || !job.monitored);
    job.is_due |= job.monitored == Monitored::results && has_results;
    job.is_due |= job.monitored == Monitored::history && has_history;
    is_any |= job.is_due;
  }
  return is_any;
}

void Outputs::HeartbeatJob::write(const State& state, const OutputContext& context) {
  writer->write(state.time, evaluate_all(values, context));
  last_step = state.step;
}

void Outputs::write(const State& state, bool is_last) {
  if (!std::exchange(is_open_, true)) open_files();
  const OutputContext context{model_, state};
  const bool is_any_due = find_due({state.step, state.time, is_last});
  user_outputs_.compute(context, is_any_due);
  for (ExodusJob& job : exodus_) {
    if (!job.is_due) continue;
    job.writer->write_step(state.time, [&](std::size_t field) {
      return rigid_part_.extended(job.defined[field], job.fields.evaluate(field, context), state);
    });
  }
  for (HeartbeatJob& job : heartbeats_) {
    if (!job.is_due) continue;
    job.write(state, context);
  }
}

void Outputs::write_at_restart(const State& state) {
  for (HeartbeatJob& job : heartbeats_) {
    if (job.monitored != HeartbeatOutput::Monitored::restart || job.last_step == state.step) continue;
    const OutputContext context{model_, state};
    user_outputs_.compute(context, true);
    job.write(state, context);
  }
}

}  // namespace contactsim
