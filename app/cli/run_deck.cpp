// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_deck.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <utility>

#include "app/cli/read_run_deck.hpp"
#include "app/cli/run_mesh.hpp"
#include "app/cli/surface_stage.hpp"
#include "app/reports/deck_report.hpp"
#include "app/reports/overlap_report.hpp"
#include "app/reports/run_head.hpp"
#include "app/reports/run_log.hpp"
#include "app/reports/surface_report.hpp"
#include "app/run/file_clashes.hpp"
#include "app/run/simulation.hpp"
#include "app/run/start_overlap.hpp"
#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "contact/output/surface_summary.hpp"
#include "core/definition/simulation.hpp"
#include "core/elements/cohesive_section.hpp"

namespace contactsim {

namespace {

/// Whether a run may resume from where an earlier one was.
bool asks_to_resume(const SimulationDefinition& definition) {
  if (definition.restart.is_automatic || definition.restart.time) return true;
  for (const Procedure& procedure : definition.procedures) {
    for (const Region& region : procedure.regions) {
      if (std::ranges::any_of(region.restart_data, [](const RestartData& restart) {
            return restart.is_automatic || restart.restart_time;
          }))
        return true;
    }
  }
  return false;
}

/// A deck with errors goes no further, but wrong names of surfaces are found all the same.
void add_name_errors(const Options& options, const SimulationDefinition& definition, Diagnostics& errors) {
  Diagnostics discarded, found;
  const Region region = choose_region(definition, true, discarded).region;
  add_surface_name_errors(definition, region, run_mesh_path(options, definition, region), found);
  // What the deck alone shows to be wrong has been reported.
  const auto is_reported = [known = errors.all()](const Diagnostic& error) {
    return std::ranges::any_of(known, [&](const Diagnostic& other) {
      return other.severity == Severity::error && error.severity == Severity::error &&
             to_string(other.location) == to_string(error.location);
    });
  };
  for (const Diagnostic& error : found.all()) {
    if (!is_reported(error)) errors.add(error);
  }
}

/// Removes overlaps where the deck wants it; the mesh whose nodes have moved, if some have.
std::optional<Mesh> part_overlaps(const RunInput& input, Log& log, Diagnostics& warnings) {
  auto removed = remove_initial_overlap(input);
  if (!removed) return std::nullopt;
  log.write(format_overlap(*removed, *input.contact, input.mesh));
  return move_nodes(input, std::move(*removed), warnings);
}

std::vector<StartOverlap> find_overlaps(const RunInput& input, Log& log) {
  if (input.contact == nullptr) return {};
  auto overlaps = find_start_overlaps(*input.contact, input.mesh, *input.region.contact);
  log.write(format_start_overlaps(overlaps, *input.contact, input.mesh));
  return overlaps;
}

/// The mesh that the deck names must outlive the run as well.
void check_mesh_is_kept(const Options& options, const std::string& mesh_path) {
  const RunFile mesh{mesh_path, "the mesh"};
  const std::string clash = find_file_clash({&mesh, 1}, files_written(options));
  if (!clash.empty()) throw FileError(mesh_path, clash);
}

RunSettings run_settings(const Options& options, const Mesh& mesh, Log& log) {
  std::vector<RunFile> kept = files_read(options);
  kept.push_back({mesh.path(), "the mesh"});
  for (RunFile& file : files_written(options)) {
    if (file.path != options.results) kept.push_back(std::move(file));
  }
  return {options.results, options.command_line, std::move(kept),
          [&log](std::string_view text) { log.write(text); }};
}

/// Has the run do what signals ask for.
void obey(StopSignals& signals, Simulation& simulation) {
  if (const auto signal = signals.find_stop()) simulation.stop(*signal);
  if (signals.take_restart_wish()) simulation.store_restart();
}

ExitCode estimate_run(Simulation& simulation, Log& log) {
  const RunEstimate estimate = simulation.estimate();
  log.write(format_estimate(estimate));
  log.write_to_file(format_estimated_time(estimate, omp_get_max_threads()));
  return ExitCode::done;
}

/// The loop of a run.
ExitCode run_steps(Simulation& simulation, StopSignals& signals) {
  ExitCode code = ExitCode::done;
  try {
    simulation.begin();
    obey(signals, simulation);
    while (!simulation.is_over()) {
      simulation.step();
      obey(signals, simulation);
    }
  } catch (const SolveError&) {
    code = ExitCode::solve;
  }
  simulation.finish();
  return simulation.stopped_by() ? ExitCode::stopped : code;
}

ExitCode run_to_end(Simulation& simulation, StopSignals& signals, RunSummary& summary) {
  try {
    const ExitCode code = run_steps(simulation, signals);
    note_run(simulation, summary);
    return code;
  } catch (...) {
    note_run(simulation, summary);
    throw;
  }
}

}  // namespace

ExitCode run_deck(const Options& options, StopSignals& signals, Log& log, Diagnostics& warnings,
                  RunSummary& summary, ReportDraft& draft) {
  const auto [definition, digest, sources] = read_run_deck(
      {options.deck, options.definitions, options.is_lenient, options.includes_folder}, warnings);
  summary.deck_digest = format_digest(digest);
  draft.deck = sources;
  log.begin(asks_to_resume(definition));
  if (warnings.has_errors()) {
    if (options.stage != Stage::parse) add_name_errors(options, definition, warnings);
    throw DeckError(warnings);
  }
  log.write(fmt::format("Deck {}\n{}", options.deck, format_definition(definition)));
  if (options.stage == Stage::parse) return ExitCode::done;

  const bool may_pass_over = options.is_lenient || options.stage == Stage::tables;
  const auto [procedure, region] = choose_region(definition, may_pass_over, warnings);
  if (options.report) {
    draft.definition = definition;
    draft.region = region;
  }
  if (options.stage == Stage::run) stop_on_errors(warnings);
  const std::string mesh_path = run_mesh_path(options, definition, region);
  check_mesh_is_kept(options, mesh_path);
  if (options.summary) summary.mesh = {mesh_path, digest_of_file(mesh_path), std::nullopt, std::nullopt};
  Mesh mesh = with_cohesive_blocks(definition, region, read_run_mesh(options, definition, region, warnings));
  log.write(fmt::format("Mesh {}\n{}", mesh.path(), format_mesh(mesh)));
  draft.has_mesh = true;
  if (summary.mesh) summary.mesh = {mesh_path, summary.mesh->digest, mesh.n_nodes(), mesh.n_elements()};
  signals.end_if_stopped();

  ResolvedContact contact;
  if (region.contact || options.stage != Stage::run) {
    contact = resolve_contact(options, definition, region, mesh, log, warnings);
    if (contact.model) note_pairs(*contact.model, summary);
    if (contact.model && options.report)
      draft.surfaces = format_surfaces_json(*contact.model, summarize(*contact.model, mesh));
    if (contact.code != ExitCode::done) return contact.code;
  }
  signals.end_if_stopped();
  RunInput input{definition, procedure, region, mesh, contact.model ? &*contact.model : nullptr};
  if (auto moved = part_overlaps(input, log, warnings)) {
    mesh = std::move(*moved);
    refit_smoothings(mesh, *contact.model);
  }
  const std::vector<StartOverlap> overlaps = find_overlaps(input, log);
  // A deck of contact alone has nothing else to check.
  const bool is_run_known = definition.form == DeckForm::full;
  if (options.stage == Stage::tables || (options.stage == Stage::check && !is_run_known)) {
    warn_of_overlaps(input, overlaps, {}, warnings);
    return ExitCode::done;
  }

  signals.end_if_stopped();
  input.overlaps = overlaps;
  Simulation simulation(input, run_settings(options, mesh, log), warnings);
  signals.end_if_stopped();
  if (options.stage == Stage::check) return estimate_run(simulation, log);
  if (options.is_strict && !warnings.empty()) return ExitCode::done;
  RunLog run_log(log);
  simulation.observe([&](RunEvent event, const Simulation& run) { run_log.look(event, run); });
  if (options.report)
    simulation.observe([&](RunEvent event, const Simulation& run) { draft.curves.look(event, run); });
  draft.output_paths = simulation.output_paths();
  return run_to_end(simulation, signals, summary);
}

}  // namespace contactsim
