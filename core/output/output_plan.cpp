// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/file_paths.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/mesh_parts.hpp"
#include "core/output/single_values.hpp"

namespace contactsim {

namespace {

/// An estimate takes a second for so many steps. Of more it looks at some alone: what is due by steps counts
/// less then.
constexpr std::int64_t max_steps_looked_at = 10'000'000;

/// An output clashes with those before it, once. Returns whether none does.
bool check_clashes(const std::vector<std::string>& paths, const DeckName& region, Diagnostics& diagnostics) {
  bool is_clean = true;
  for (auto path = paths.begin(); path != paths.end(); ++path) {
    const bool clashes = std::any_of(paths.begin(), path, [&](const std::string& other) {
      return would_overwrite(*path, other) || would_overwrite(other, *path);
    });
    if (!clashes) continue;
    is_clean = false;
    diagnostics.add_error(region.location, fmt::format("two outputs would write {}", *path),
                          "DATABASE NAME or STREAM NAME gives each its own file");
  }
  return is_clean;
}

}  // namespace

OutputPlan::OutputPlan(const ConditionScope& scope, const Model& model, OutputSettings settings)
    : model_(model),
      rigid_part_(model),
      variables_(model, std::move(settings.variables), settings.other_names),
      user_outputs_(scope, variables_),
      terminations_(scope.region.terminations, variables_, scope.diagnostics),
      settings_(std::move(settings)) {
  std::optional<std::string> path = settings_.results_path;
  for (const ResultsOutput& output : scope.region.results_outputs)
    results_.push_back({plan_results(scope, output, std::exchange(path, std::nullopt), variables_), {}, {}});
  if (path) results_.push_back({plan_results(scope, make_default_results(), path, variables_), {}, {}});
  for (const HistoryOutput& output : scope.region.history_outputs)
    results_.push_back({plan_history(scope, output, variables_), {}, {}});
  for (const HeartbeatOutput& output : scope.region.heartbeat_outputs)
    heartbeats_.push_back({plan_heartbeat(scope, output, variables_), {}, false, {}});
  // Of pieces those of one name alone are told.
  if (check_clashes(names(), scope.region.name, scope.diagnostics))
    check_clashes(paths(), scope.region.name, scope.diagnostics);
}

/// All files, those of results by a function.
template <class NamesOf>
std::vector<std::string> OutputPlan::list_files(const NamesOf& names_of) const {
  std::vector<std::string> files;
  for (const Results& results : results_)
    std::ranges::move(names_of(results.plan.file), std::back_inserter(files));
  for (const Heartbeat& heartbeat : heartbeats_) {
    if (!heartbeat.plan.file.path.empty()) files.push_back(heartbeat.plan.file.path);
  }
  return files;
}

std::vector<std::string> OutputPlan::paths() const { return list_files(settings_.writers.name_results); }

std::vector<std::string> OutputPlan::names() const {
  return list_files([](const ResultsFile& file) { return std::vector{file.path}; });
}

void OutputPlan::add_suffix(const std::string& suffix) {
  for (Results& results : results_) results.plan.file.path += suffix;
  for (Heartbeat& heartbeat : heartbeats_) {
    HeartbeatFile& file = heartbeat.plan.file;
    if (!file.path.empty() && !file.form.appends) file.path += suffix;
  }
}

std::vector<StepTarget> OutputPlan::step_targets() const {
  std::vector<StepTarget> targets;
  const auto add = [&](const OutputTimes& times) {
    if (!times.adjustment_interval()) return;
    targets.push_back({[times](double time) { return times.next_time(time); }, *times.adjustment_interval()});
  };
  for (const Results& results : results_) add(results.plan.times);
  for (const Heartbeat& heartbeat : heartbeats_) add(heartbeat.plan.times);
  return targets;
}

/// Nothing where no file has a mesh: a copy takes as much memory as the mesh of the run.
Mesh OutputPlan::results_mesh() const {
  if (!std::ranges::any_of(results_, [](const Results& results) { return results.plan.file.has_mesh; }))
    return {};
  MeshParts parts = parts_of(*model_.mesh);
  add_sets(settings_.side_sets, settings_.node_sets, parts);
  rigid_part_.add_to(parts);
  return Mesh(std::move(parts));
}

std::vector<OutputEstimate> OutputPlan::estimate(double begin, double step, std::int64_t n_steps) {
  std::vector<std::int64_t> n_due(results_.size() + heartbeats_.size(), 0);
  const std::int64_t stride = 1 + n_steps / max_steps_looked_at;
  const auto look = [&](std::int64_t i) {
    find_due({i, begin + static_cast<double>(i) * step, i == n_steps});
    for (std::size_t k = 0; k < n_due.size(); ++k) {
      const bool is_due = k < results_.size() ? results_[k].is_due : heartbeats_[k - results_.size()].is_due;
      n_due[k] += is_due ? 1 : 0;
    }
  };
  for (std::int64_t i = 0; i < n_steps; i += stride) look(i);
  look(n_steps);
  std::vector<OutputEstimate> estimates;
  const auto add = [&](const std::string& path, std::int64_t n_states, const OutputBytes& bytes) {
    estimates.push_back({path, n_states, bytes.start + static_cast<std::uint64_t>(n_states) * bytes.step});
  };
  const Mesh no_mesh, mesh = results_mesh();
  for (std::size_t k = 0; k < results_.size(); ++k) {
    const PlannedResults& plan = results_[k].plan;
    add(plan.file.path, n_due[k],
        settings_.writers.measure_results(plan.file, plan.file.has_mesh ? mesh : no_mesh,
                                          plan.fields.fields()));
  }
  for (std::size_t k = 0; k < heartbeats_.size(); ++k) {
    const PlannedHeartbeat& plan = heartbeats_[k].plan;
    if (plan.file.path.empty()) continue;
    add(plan.file.path, n_due[results_.size() + k],
        settings_.writers.measure_heartbeat(plan.file, value_names(plan.values)));
  }
  return estimates;
}

void OutputPlan::open_files() {
  const Mesh no_mesh, mesh = results_mesh();
  for (auto& [plan, defined, open, is_due] : results_) {
    defined = plan.fields.fields();
    open = settings_.writers.open_results(plan.file, plan.file.has_mesh ? mesh : no_mesh, defined);
  }
  for (Heartbeat& heartbeat : heartbeats_)
    heartbeat.append =
        settings_.writers.open_heartbeat(heartbeat.plan.file, value_names(heartbeat.plan.values));
}

std::optional<EarlyEnd> OutputPlan::check_termination(const State& state) {
  const OutputContext context{model_, state, share_};
  const bool ends = !terminations_.is_empty(), are_needed = ends || settings_.always_computes;
  if (terminations_.reads_all() || user_outputs_.read_all(are_needed)) settings_.complete_state();
  user_outputs_.compute(context, are_needed);
  return terminations_.find_end(context);
}

std::optional<EarlyEnd> OutputPlan::check_restored_termination(const State& state) const {
  return terminations_.find_end({model_, state});
}

bool OutputPlan::find_due(const OutputTime& now) {
  bool has_results = false, has_history = false, is_any = false;
  for (Results& results : results_) {
    results.is_due = results.plan.times.is_due(now);
    (results.plan.file.has_mesh ? has_results : has_history) |= results.is_due;
    is_any |= results.is_due;
  }
  using Monitored = HeartbeatOutput::Monitored;
  for (Heartbeat& heartbeat : heartbeats_) {
    const std::optional<Monitored> monitored = heartbeat.plan.file.form.monitored;
    heartbeat.is_due = heartbeat.plan.times.is_due(now) && (heartbeat.plan.has_schedule || !monitored);
    heartbeat.is_due |= monitored == Monitored::results && has_results;
    heartbeat.is_due |= monitored == Monitored::history && has_history;
    is_any |= heartbeat.is_due;
  }
  return is_any;
}

bool OutputPlan::reads_whole_state() const {
  const auto of_results = [](const Results& results) {
    const bool is_whole = results.plan.file.has_mesh && results.open.piece == nullptr;
    return results.is_due && (is_whole || results.plan.fields.read_all());
  };
  const auto of_heartbeat = [](const Heartbeat& heartbeat) {
    return heartbeat.is_due && heartbeat.plan.values.read_all();
  };
  return user_outputs_.read_all(true) || std::ranges::any_of(results_, of_results) ||
         std::ranges::any_of(heartbeats_, of_heartbeat);
}

std::span<const double> OutputPlan::values_of(Results& results, std::size_t field,
                                              const OutputContext& context) {
  RequestedFields& fields = results.plan.fields;
  const MeshPiece* piece = results.open.piece.get();
  const std::span<const double> values =
      piece != nullptr ? fields.evaluate(field, context, *piece) : fields.evaluate(field, context);
  // The spheres of rigid bodies, whose nodes are the last, are all in one piece.
  const bool has_spheres =
      piece == nullptr || (!piece->nodes.empty() && piece->nodes.back() >= model_.mesh->n_nodes());
  return has_spheres ? rigid_part_.extended(results.defined[field], values, context.state) : values;
}

/// Of a history, whose fields are single values.
void OutputPlan::write_single_values(Results& results, const OutputContext& context) const {
  const std::vector<double> all = evaluate_all(results.plan.fields, context);
  std::vector<std::size_t> begins{0};
  for (const OutputField& field : results.defined)
    begins.push_back(begins.back() + static_cast<std::size_t>(field.n_components));
  results.open.append(context.state.time, [&](std::size_t field) {
    return std::span(all).subspan(begins[field], begins[field + 1] - begins[field]);
  });
}

void OutputPlan::write(Results& results, const OutputContext& context) {
  if (!results.plan.file.has_mesh) return write_single_values(results, context);
  results.open.append(context.state.time,
                      [&](std::size_t field) { return values_of(results, field, context); });
}

void OutputPlan::Heartbeat::write(const OutputContext& context) {
  append(context.state.time, evaluate_all(plan.values, context));
  last_step = context.state.step;
}

void OutputPlan::write(const State& state, bool is_last) {
  if (!std::exchange(is_open_, true)) open_files();
  const OutputContext context{model_, state, share_};
  const bool is_any_due = find_due({state.step, state.time, is_last});
  if (is_any_due && reads_whole_state()) settings_.complete_state();
  user_outputs_.compute(context, is_any_due);
  for (Results& results : results_) {
    if (results.is_due) write(results, context);
  }
  for (Heartbeat& heartbeat : heartbeats_) {
    if (heartbeat.is_due) heartbeat.write(context);
  }
}

void OutputPlan::write_at_restart(const State& state) {
  for (Heartbeat& heartbeat : heartbeats_) {
    const auto monitored = heartbeat.plan.file.form.monitored;
    if (monitored != HeartbeatOutput::Monitored::restart || heartbeat.last_step == state.step) continue;
    const OutputContext context{model_, state, share_};
    if (user_outputs_.read_all(true) || heartbeat.plan.values.read_all()) settings_.complete_state();
    user_outputs_.compute(context, true);
    heartbeat.write(context);
  }
}

}  // namespace contactsim
