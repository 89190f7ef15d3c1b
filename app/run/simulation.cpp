// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/run/simulation_parts.hpp"
#include "core/base/memory_pages.hpp"
#include "core/parallel/on_root.hpp"

namespace contactsim {

namespace {

/// Calls what takes long, and adds the time of the clock to a sum.
template <class Work>
void add_time(double& seconds, const Work& work) {
  const double begun = clock_seconds();
  work();
  seconds += clock_seconds() - begun;
}

}  // namespace

Simulation::Simulation(const RunInput& input, RunSettings settings, Diagnostics& diagnostics)
    : parts_(std::make_unique<Parts>(input, std::move(settings), diagnostics)) {}

Simulation::~Simulation() = default;

void Simulation::observe(Observer observer) { parts_->observers.push_back(std::move(observer)); }

void Simulation::notify(RunEvent event) {
  add_time(parts_->output_seconds, [&] {
    for (const Observer& observer : parts_->observers) observer(event, *this);
  });
}

/// Observers are notified of what throws SolveError first.
template <class Work>
void Simulation::try_to(const Work& work) {
  try {
    work();
  } catch (const SolveError& error) {
    parts_->failure = error.what();
    notify(RunEvent::failed);
    throw;
  }
}

void Simulation::begin() {
  parts_->begun = clock_seconds();
  parts_->settings.ranks.wait_for_all(std::numeric_limits<double>::infinity());  // files of before are whole
  parts_->restart.find_state(parts_->outputs.names(), parts_->diagnostics);
  notify(RunEvent::restart_sought);
  parts_->prepare_files();
  try_to([&] { parts_->restart.earlier() != nullptr ? resume() : begin_anew(); });
}

void Simulation::begin_anew() {
  Parts& run = *parts_;
  run.take_over();
  // What sets up and starts takes more for a while than steps do.
  return_freed_memory();
  run.start_anew();
  return_freed_memory();
  notify(RunEvent::begun);
  run.energy_warnings.begin(run.state);
  end_step();
  run.restart.begin(run.state);
}

RunEstimate Simulation::estimate() {
  constexpr int max_steps = 20;
  constexpr double max_seconds = 1.0;
  Parts& run = *parts_;
  run.check_files();
  run.start_anew();
  RunEstimate estimate;
  estimate.stable_step = run.at_start.stable_step;
  estimate.step = run.state.next_dt;
  const double left = run.setup.control.termination_time() - run.state.time;
  estimate.n_steps = static_cast<std::int64_t>(std::ceil(left / estimate.step));
  for (const ModelBlock& block : run.setup.model.blocks)
    estimate.n_elements += block.is_rigid ? 0 : block.n_elements;
  estimate.files = run.outputs.estimate(
      run.state.time, left / static_cast<double>(std::max<std::int64_t>(estimate.n_steps, 1)),
      estimate.n_steps);
  const double begun = clock_seconds();
  int n_steps = 0;
  while (!control().is_over(state().time, state().dt) && n_steps < max_steps &&
         run.settings.ranks.of_root(clock_seconds() - begun < max_seconds)) {
    run.advance();
    ++n_steps;
  }
  if (n_steps > 0) estimate.seconds_per_step = (clock_seconds() - begun) / n_steps;
  return estimate;
}

void Simulation::resume() {
  Parts& run = *parts_;
  StateArchive saved(*run.restart.earlier());
  const std::vector<RunMark> changed = archive(run.checkpoint(), saved);
  run.restart.forget_earlier();
  run.energy_warnings.begin(run.state);
  run.outputs.resume(run.state);
  // A state may be stored where a condition ended the run, which the next step would go beyond.
  run.end = run.outputs.check_restored_termination(run.state);
  warn_of_restart(run.restart, changed, is_over(), run.diagnostics);
  run.restart.begin(run.state);
  notify(RunEvent::resumed);
}

bool Simulation::is_over() const {
  return parts_->end || parts_->stopped_by || control().is_over(state().time, state().dt);
}

void Simulation::step() {
  Parts& run = *parts_;
  try_to([&] {
    if (!run.advance()) return stop(run.find_stop().value());
    run.energy_warnings.step(run.state);
    if (run.load_steps) run.load_step_warnings.step(run.state, run.load_steps->report());
    if (run.contact && !run.load_steps) run.contact->stop_at_runaway(run.state);
    if (run.contact) run.contact->watch(run.state, [&run] { run.complete_coordinates(); });
    end_step();
    store(false, false);
  });
}

/// Whoever looks at a state, once each.
void Simulation::end_step() {
  Parts& run = *parts_;
  add_time(run.output_seconds, [&] { run.end = run.find_end(); });
  if (run.death) {
    run.let_die();
    if (run.death->is_report_due(run.state)) {
      notify(RunEvent::elements_died);
      run.death->begin_tally(run.state);
    }
  }
  write(false);
  notify(RunEvent::step);
}

void Simulation::finish() {
  Parts& run = *parts_;
  run.complete_state();
  if (!run.failure) {
    run.energy_warnings.end(run.state);
    // A run that resumes from here must not know that this one ended: the state comes first.
    store(true, run.stopped_by.has_value());
  }
  write(true);
  run.whole_seconds = clock_seconds() - run.begun;
  run.load_step_warnings.end(run.state);
  if (run.contact) run.contact->warn_of_end(run.state, run.diagnostics);
  if (run.is_settling()) run.warn_of_preload();
  notify(RunEvent::ended);
  if (run.contact) on_root(run.settings.ranks, [&] { run.contact->write_debug_files(); });
}

void Simulation::stop_when(std::function<std::optional<std::string>()> find_stop) {
  parts_->find_stop = std::move(find_stop);
  if (!parts_->load_steps) return;
  parts_->load_steps->give_up_when([&run = *parts_] { return run.find_stop && run.find_stop().has_value(); });
}

void Simulation::stop(std::string reason) { parts_->stopped_by = std::move(reason); }

void Simulation::store_restart() { store(false, true); }

void Simulation::store(bool is_last, bool is_wanted) {
  add_time(parts_->restart_seconds, [&] {
    if (!parts_->restart.is_due(parts_->state, is_last, is_wanted)) return;
    parts_->complete_state();
    parts_->restart.store(parts_->checkpoint());
    parts_->outputs.write_at_restart(parts_->state);
  });
}

void Simulation::write(bool is_last) {
  add_time(parts_->output_seconds, [&] { parts_->outputs.write(parts_->state, is_last); });
}

const Procedure& Simulation::procedure() const { return parts_->input.procedure; }
const Mesh& Simulation::mesh() const { return parts_->input.mesh; }
const Model& Simulation::model() const { return parts_->setup.model; }
const State& Simulation::state() const { return parts_->state; }
const TimeStepControl& Simulation::control() const { return parts_->setup.control; }
const RunDeath* Simulation::deaths() const { return parts_->death.get(); }
const RunRestart& Simulation::restart() const { return parts_->restart; }
void Simulation::begin_at_start() { parts_->restart.begin_at_start(); }
std::vector<std::string> Simulation::output_paths() const { return parts_->outputs.paths(); }
const LoadSteps* Simulation::load_steps() const {
  return parts_->load_steps ? &*parts_->load_steps : nullptr;
}
const StepReport& Simulation::start_report() const { return parts_->at_start; }
const std::optional<std::string>& Simulation::failure() const { return parts_->failure; }
const std::optional<EarlyEnd>& Simulation::end() const { return parts_->end; }
const std::optional<std::string>& Simulation::stopped_by() const { return parts_->stopped_by; }
double Simulation::seconds() const { return parts_->whole_seconds; }
std::vector<PartTime> Simulation::part_times() const { return parts_->times(); }

std::optional<RankTraffic> Simulation::rank_traffic() const {
  if (!parts_->share) return std::nullopt;
  RankTraffic traffic = parts_->share->traffic();
  if (parts_->load_steps) {
    const State& state = parts_->state;
    traffic.bytes_gathered +=
        sizeof(double) *
        static_cast<std::size_t>(state.forces.internal.size() + state.rotations.moments.internal.size());
  }
  return traffic;
}

const ContactForce* Simulation::contact_force() const {
  return parts_->contact ? &parts_->contact->force() : nullptr;
}
ContactForce* Simulation::contact_force() { return parts_->contact ? &parts_->contact->force() : nullptr; }

const ContactModel* Simulation::contact_model() const {
  return parts_->contact ? &parts_->contact->model() : nullptr;
}

IndexedSpan<PairIndex, const UntiedPart> Simulation::untied() const {
  return parts_->contact ? parts_->contact->untied() : IndexedSpan<PairIndex, const UntiedPart>();
}

IndexedSpan<PairIndex, const Interpenetration> Simulation::interpenetrations() const {
  return parts_->contact ? parts_->contact->interpenetrations()
                         : IndexedSpan<PairIndex, const Interpenetration>();
}

double Simulation::given_out_by_overlaps() const {
  return parts_->contact ? parts_->contact->given_out_by_overlaps() : 0.0;
}

}  // namespace contactsim
