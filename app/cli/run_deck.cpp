// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/check_files.hpp"
#include "app/cli/prepared_region.hpp"
#include "app/cli/read_run_deck.hpp"
#include "app/cli/run_mesh.hpp"
#include "app/cli/run_procedures.hpp"
#include "app/cli/surface_stage.hpp"
#include "app/reports/deck_report.hpp"
#include "app/reports/procedure_report.hpp"
#include "app/run/procedure_checks.hpp"
#include "app/run/start_overlap.hpp"
#include "app/run/stop_on_errors.hpp"
#include "core/base/errors.hpp"
#include "core/base/memory_error.hpp"
#include "core/definition/simulation.hpp"
#include "core/parallel/on_root.hpp"

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

/// The region that files of surfaces and the report are of: as choose_region() has it.
std::size_t find_shown(const std::vector<ChosenRegion>& chosen) {
  std::size_t shown = 0;
  const auto merit = [&](std::size_t i) { return merit_of(chosen[i].procedure, chosen[i].region); };
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    if (merit(i) > merit(shown)) shown = i;
  }
  return shown;
}

void warn_of_hidden_tables(const Options& options, const std::vector<ChosenRegion>& chosen, std::size_t shown,
                           Diagnostics& warnings) {
  if (!asks_for_tables(options)) return;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i == shown || !chosen[i].region.contact) continue;
    warnings.add_warning("deck-region", chosen[i].procedure.name.location,
                         fmt::format("the files of surfaces do not hold those of the procedure '{}'",
                                     chosen[i].procedure.name.text),
                         fmt::format("they hold those of '{}'", chosen[shown].procedure.name.text));
  }
}

}  // namespace

ExitCode run_deck(const Options& options, Ranks& ranks, StopSignals& signals, Log& log, Diagnostics& warnings,
                  RunSummary& summary, ReportDraft& draft) {
  const RunDeck deck = tell_lack_of_memory("reading the deck", [&] {
    return read_run_deck({options.deck, options.definitions, options.is_lenient, options.includes_folder},
                         warnings);
  });
  const SimulationDefinition& definition = deck.definition;
  if (const std::string clash = find_clash_of_run(options, deck); !clash.empty()) {
    log.leave_file();
    throw FileError(options.deck, clash);
  }
  warn_of_files_outside(options, deck, warnings);
  summary.deck_digest = format_digest(deck.digest);
  draft.deck = deck.sources;
  check_procedures(definition, warnings);
  on_root(ranks, [&] { log.begin(asks_to_resume(definition)); });
  if (warnings.has_errors()) {
    if (options.stage != Stage::parse) add_name_errors(options, definition, warnings);
    throw DeckError(warnings);
  }
  log.write(fmt::format("Deck {}\n{}", options.deck, format_definition(definition)));
  if (options.stage == Stage::parse) return ExitCode::done;

  const bool may_pass_over = options.is_lenient || options.stage == Stage::tables;
  const std::vector<ChosenRegion> chosen = choose_regions(definition, may_pass_over, warnings);
  const std::size_t shown = find_shown(chosen);
  if (options.report) {
    draft.definition = definition;
    draft.region = chosen[shown].region;
  }
  if (options.stage == Stage::run) stop_on_errors(warnings);
  warn_of_hidden_tables(options, chosen, shown, warnings);

  const DeckWay way{options, definition, ranks, signals, log, warnings, summary, draft};
  MeshesByModel meshes;
  std::vector<PreparedRegion> regions;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen.size() > 1 && (chosen[i].region.contact || options.stage != Stage::run))
      log.write(format_procedure(chosen[i].procedure, chosen[i].region,
                                 i > 0 ? &regions.back().procedure : nullptr));
    regions.push_back(prepare_region(way, chosen[i], meshes, i == shown));
    if (regions.back().code != ExitCode::done) return regions.back().code;
  }
  // A deck of contact alone has nothing else to check.
  const bool is_run_known = definition.form == DeckForm::full;
  if (options.stage == Stage::tables || (options.stage == Stage::check && !is_run_known)) {
    for (const PreparedRegion& region : regions)
      warn_of_overlaps(region.input(definition), region.overlaps, {}, warnings);
    return ExitCode::done;
  }
  signals.end_if_stopped();
  return run_procedures(way, regions);
}

}  // namespace contactsim
