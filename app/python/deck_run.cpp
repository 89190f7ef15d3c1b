// SPDX-License-Identifier: BSD-3-Clause
#include "app/python/deck_run.hpp"

#include "app/cli/options.hpp"
#include "app/cli/read_run_deck.hpp"
#include "app/cli/run_mesh.hpp"
#include "app/run/start_overlap.hpp"
#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "core/base/errors.hpp"
#include "core/elements/cohesive_section.hpp"

namespace contactsim {

DeckRun::DeckRun(const DeckRunRequest& request) : results_(request.results) {
  definition_ =
      read_run_deck({request.deck, request.definitions, request.is_lenient, {}}, diagnostics_).definition;
  stop_on_errors(diagnostics_);
  auto chosen = choose_region(definition_, request.is_lenient, diagnostics_);
  stop_on_errors(diagnostics_);
  procedure_ = std::move(chosen.procedure);
  region_ = std::move(chosen.region);
  Options options;
  options.deck = request.deck;
  options.mesh = request.mesh;
  mesh_ =
      with_cohesive_blocks(definition_, region_, read_run_mesh(options, definition_, region_, diagnostics_));
  if (!region_.contact) return;
  contact_ = make_contact_model(definition_, region_, mesh_, diagnostics_);
  stop_on_errors(diagnostics_);
  for (const SurfaceWarning& warning : contact_->surfaces.warnings)
    diagnostics_.add_warning(warning.id, warning.location, warning.text);
}

void DeckRun::begin() {
  if (simulation_) return;
  RunInput input{definition_, procedure_, region_, mesh_, contact()};
  if (auto removed = remove_initial_overlap(input)) {
    if (auto moved = move_nodes(input, std::move(*removed), diagnostics_)) {
      mesh_ = std::move(*moved);
      refit_smoothings(mesh_, *contact_);
    }
  }
  if (contact_) overlaps_ = find_start_overlaps(*contact_, mesh_, *region_.contact);
  input.overlaps = overlaps_;
  RunSettings settings;
  settings.results_path = results_;
  settings.command_line = "contactsim, from Python";
  settings.kept_files = {{mesh_.path(), "the mesh"}};
  simulation_ = std::make_unique<Simulation>(input, std::move(settings), diagnostics_);
  simulation_->begin();
  end_if_due();
}

void DeckRun::step() {
  begin();
  if (is_finished_) return;
  try {
    simulation_->step();
  } catch (const SolveError&) {
    finish();
    throw;
  }
  end_if_due();
}

void DeckRun::end_if_due() {
  if (simulation_->is_over()) finish();
}

void DeckRun::finish() {
  if (!simulation_ || is_finished_) return;
  is_finished_ = true;
  simulation_->finish();
}

const Simulation& DeckRun::simulation() const {
  if (!simulation_) {
    Diagnostics early;
    early.add_error({}, "the run has not begun: call begin(), step() or run() first");
    throw DeckError(early);
  }
  return *simulation_;
}

}  // namespace contactsim
